// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>

namespace toss {

/// Accepts 0, 1, ...; unsigned options alone take -1 for their largest number.
inline CLI::Range wholeNumber() {
  return CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max());
}

}  // namespace toss
