// SPDX-License-Identifier: BSD-3-Clause
#include "NumberLines.h"

#include <toss/geometry/Error.h>

#include <cstdlib>
#include <fstream>

namespace toss {

std::vector<double> parseNumbers(const std::string& text) {
  constexpr const char* kSeparators = " \t\r,";
  std::vector<double> numbers;
  const char* next = text.c_str();
  for (;;) {
    while (*next == ',') ++next;
    char* end = nullptr;
    const double value = std::strtod(next, &end);
    if (end == next) break;
    numbers.push_back(value);
    next = end;
  }
  const bool clean = std::string(next).find_first_not_of(kSeparators) == std::string::npos;
  return clean ? numbers : std::vector<double>();
}

void forEachLine(const std::filesystem::path& file,
                 const std::function<void(const std::string& line, int number)>& use) {
  std::ifstream in(file);
  std::error_code ignored;
  if (!in || std::filesystem::is_directory(file, ignored))
    throw UserError(file.string(), "can't be read", "check that the file exists");
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line[first] != '#') use(line, number);
  }
}

std::string lineOf(const std::filesystem::path& file, int line) {
  return file.string() + ": line " + std::to_string(line);
}

}  // namespace toss
