// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/InputOptions.h>

#include <filesystem>
#include <string>
#include <vector>

namespace toss {

/// Which LiDARs of an input are mapped, found out from the scans of its beginning.
struct LidarSelection {
  /// Their labels in the order in which they are met; empty where the input has one sensor, or
  /// input.sensor_label names it: then nothing has to be chosen.
  std::vector<std::string> labels;
  /// Sentences for the user, one for each sensor that is left out.
  std::vector<std::string> notes;
};

/// Chooses all sensors that have scans of 200 returns or more within 0.6 s of the first scan, but
/// none whose data another one has already: one that sits at the same place on the robot (within
/// 1 cm: another kind of observation of the same sensor, or a sensor pose that was forgotten), or
/// whose returns are those of another one's scan of the same time, in whatever frame. Of two such
/// the one that is met first is taken. Throws UserError where the input can't be read.
LidarSelection selectLidars(const std::filesystem::path& input, const InputOptions& options);

/// `options` with the labels that selectLidars() chooses: what toss map reads.
InputOptions withSelectedLidars(const std::filesystem::path& input, const InputOptions& options);

}  // namespace toss
