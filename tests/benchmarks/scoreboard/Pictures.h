// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/ContactSheet.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "Scoreboard.h"

namespace toss {

/// Makes the pictures out of the cases as they finish: all scenes, the errors on each, and the
/// paper's figures: maps in true and false colours without and with DS-Voting and of several
/// methods, maps of rough terrain with traces.
class PictureMaker {
 public:
  /// `folder`: for the sheets; single pictures are kept in a temporary folder in it meanwhile.
  explicit PictureMaker(std::filesystem::path folder);
  ~PictureMaker();

  void addLog(const LabelledLog& log);
  void addCase(const FinishedCase& finished);
  /// Writes the sheets and returns Markdown for each. Sheets without pictures are left out, all of
  /// them where this machine can not draw.
  std::vector<std::string> finish();

 private:
  struct Sheet {
    std::string file, title;
    int columns, cellWidth;
    /// By scene and place in the row: cases finish in any order.
    std::map<std::pair<std::string, int>, SheetEntry> entries;
  };
  /// `variants`: names in the order in which they stand side by side.
  void drawErrors(const FinishedCase& finished, const std::vector<const char*>& variants,
                  Sheet& sheet);
  void drawTraces(const FinishedCase& finished);
  std::filesystem::path nextFile();

  std::filesystem::path folder_, temporary_;
  Sheet scenes_, errors_, voting_, comparison_, terrain_;
  int files_ = 0;
  bool canDraw_ = true;
};

}  // namespace toss
