// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/InputSummary.h>

namespace toss {

/// The two kinds of input, each with its own way to look through it.
void summarizeRawlog(const InputOptions& options, InputSummary& summary);
void summarizeKittiFolder(const InputOptions& options, InputSummary& summary);

/// Gathers a path: positions [m] in order of time.
void addPosition(const Eigen::Vector3d& position, InputSummary& summary);

}  // namespace toss
