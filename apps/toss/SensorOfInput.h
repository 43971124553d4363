// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/SensorChoice.h>

#include <cstdint>
#include <filesystem>

#include "RunConfiguration.h"

namespace toss {

/// The sensor that the configuration names, else the one of the first scan with returns among those
/// numbered `from` to `to`. Throws UserError where there is none.
SensorChoice sensorOfInput(const std::filesystem::path& input,
                           const RunConfiguration& configuration, std::uint64_t from,
                           std::uint64_t to);

}  // namespace toss
