// SPDX-License-Identifier: BSD-3-Clause
// What the headers of PLY and PCD have in common.
#include <toss/geometry/Error.h>

#include <algorithm>
#include <charconv>

#include "PointRecords.h"

namespace toss {

std::size_t sizeOf(NumberType type) {
  switch (type) {
    case NumberType::Int8:
    case NumberType::UInt8:
      return 1;
    case NumberType::Int16:
    case NumberType::UInt16:
      return 2;
    case NumberType::Int32:
    case NumberType::UInt32:
    case NumberType::Float32:
      return 4;
    case NumberType::Float64:
      return 8;
  }
  return 0;
}

bool readHeaderLine(std::istream& in, std::string& line, const std::filesystem::path& file) {
  constexpr std::size_t kLongestLine = 4096;
  line.clear();
  for (char c = 0; in.get(c);) {
    if (c == '\n') {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return true;
    }
    line += c;
    if (line.size() > kLongestLine) failReading(file, "its header is damaged");
  }
  return !line.empty();
}

std::vector<std::string> splitAtBlanks(std::string_view line) {
  std::vector<std::string> words;
  for (std::size_t begin = 0;;) {
    begin = line.find_first_not_of(" \t", begin);
    if (begin == std::string_view::npos) return words;
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    words.emplace_back(line.substr(begin, end - begin));
    begin = end;
  }
}

std::uint64_t parseCount(const std::string& text, const std::filesystem::path& file,
                         const std::string& what) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || next != end) failReading(file, what + " is no number: " + text);
  return value;
}

void failReading(const std::filesystem::path& file, const std::string& problem) {
  throw UserError(file.string(), problem, "give a complete PLY, PCD or .metricmap point file");
}

}  // namespace toss
