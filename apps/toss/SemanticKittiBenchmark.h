// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "RunConfiguration.h"

namespace toss {

/// What `toss benchmark semantickitti` is asked to do.
struct SemanticKittiRequest {
  /// Folder that holds sequences/00 and so on, and the file for the table ("" = none).
  std::filesystem::path folder, output;
  ConfigurationRequest configuration;
};

/// Maps the five ranges that ERASOR and TOSS are published on (spec section 9.1), every scan and
/// every second one, and returns PR, RR and F1 beside the published figures, as Markdown. Sequences
/// that are absent are named in the text. Throws UserError where none is there.
std::string runSemanticKittiBenchmark(const SemanticKittiRequest& request, bool quiet);

}  // namespace toss
