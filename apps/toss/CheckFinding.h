// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace toss {

/// How bad a finding of `toss check` is.
enum class Severity {
  Fault,  ///< the log is unfit: its map would be wrong
  Doubt,  ///< the map may suffer
  Note    ///< good to know; nothing has to be done
};

/// One finding of `toss check`.
struct Finding {
  Severity severity = Severity::Note;
  /// Name for programs, e.g. "pose-frame".
  std::string key;
  /// What was found, and what to do about it.
  std::string text, remedy;
};

using Findings = std::vector<Finding>;

}  // namespace toss
