// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace toss {

/// All numbers of a text, separated by blanks or commas; none at all if anything in it is no
/// number.
std::vector<double> parseNumbers(const std::string& text);

/// Calls `use` with each line that is neither blank nor a comment (#); lines are counted from 1.
/// Throws UserError if the file can't be read.
void forEachLine(const std::filesystem::path& file,
                 const std::function<void(const std::string& line, int number)>& use);

/// "FILE: line N", for errors.
std::string lineOf(const std::filesystem::path& file, int line);

}  // namespace toss
