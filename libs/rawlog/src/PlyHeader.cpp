// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <map>

#include "PointRecords.h"

namespace toss {
namespace {

NumberType plyType(const std::string& name, const std::filesystem::path& file) {
  static const std::map<std::string, NumberType> kTypes = {
      {"char", NumberType::Int8},      {"int8", NumberType::Int8},
      {"uchar", NumberType::UInt8},    {"uint8", NumberType::UInt8},
      {"short", NumberType::Int16},    {"int16", NumberType::Int16},
      {"ushort", NumberType::UInt16},  {"uint16", NumberType::UInt16},
      {"int", NumberType::Int32},      {"int32", NumberType::Int32},
      {"uint", NumberType::UInt32},    {"uint32", NumberType::UInt32},
      {"float", NumberType::Float32},  {"float32", NumberType::Float32},
      {"double", NumberType::Float64}, {"float64", NumberType::Float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) failReading(file, "has a property of unknown type " + name);
  return found->second;
}

/// What the lines of a header say, in the order in which they come.
class PlyHeader {
 public:
  explicit PlyHeader(const std::filesystem::path& file) : file_(file) {}

  void take(const std::vector<std::string>& words) {
    if (words[0] == "format" && words.size() >= 2) {
      takeFormat(words[1]);
    } else if (words[0] == "comment" && words.size() == 5 && words[1] == "offset") {
      takeOffset(words);
    } else if (words[0] == "element" && words.size() == 3) {
      takeElement(words);
    } else if (words[0] == "property" && words.size() >= 3) {
      takeProperty(words);
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      failReading(file_, "its header has a line that is not PLY: " + words[0]);
    }
  }

  PointTable finish(std::istream& in) {
    if (!formatSeen_) failReading(file_, "its header names no format");
    if (place_ == Place::Before) failReading(file_, "has no element vertex");
    if (table_.ascii) {
      std::string line;
      for (std::uint64_t i = 0; i < rowsBefore_ && std::getline(in, line); ++i) continue;
    } else if (!in.seekg(static_cast<std::streamoff>(bytesBefore_), std::ios::cur)) {
      failReading(file_, "is cut short before its points");
    }
    return table_;
  }

 private:
  enum class Place { Before, Inside, After };

  void takeFormat(const std::string& name) {
    formatSeen_ = true;
    table_.ascii = name == "ascii";
    table_.bigEndian = name == "binary_big_endian";
    if (!table_.ascii && !table_.bigEndian && name != "binary_little_endian")
      failReading(file_, "is in an unknown format: " + name);
  }

  void takeOffset(const std::vector<std::string>& words) {
    Eigen::Vector3d offset;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string& text = words[i + 2];
      const char* const end = text.data() + text.size();
      if (std::from_chars(text.data(), end, offset[static_cast<Eigen::Index>(i)]).ptr != end)
        return;
    }
    if (offset.allFinite()) table_.offset = offset;
  }

  void takeElement(const std::vector<std::string>& words) {
    const std::uint64_t count = parseCount(words[2], file_, "its number of " + words[1]);
    if (words[1] == "vertex" && place_ == Place::Before) {
      place_ = Place::Inside;
      table_.rows = count;
    } else if (place_ == Place::Inside) {
      place_ = Place::After;
    }
    elementRows_ = count;
    if (place_ == Place::Before) rowsBefore_ += count;
  }

  void takeProperty(const std::vector<std::string>& words) {
    if (place_ == Place::After) return;
    if (words[1] == "list") {
      if (place_ == Place::Inside || !table_.ascii)
        failReading(file_, "has lists in or before its points, which are not read");
      return;
    }
    const NumberType type = plyType(words[1], file_);
    if (place_ == Place::Inside) {
      table_.fields.push_back({words[2], type, 1});
    } else {
      bytesBefore_ += elementRows_ * sizeOf(type);
    }
  }

  const std::filesystem::path& file_;
  PointTable table_;
  Place place_ = Place::Before;
  bool formatSeen_ = false;
  std::uint64_t elementRows_ = 0, rowsBefore_ = 0, bytesBefore_ = 0;
};

}  // namespace

PointTable readPlyHeader(std::istream& in, const std::filesystem::path& file) {
  PlyHeader header(file);
  std::string line;
  readHeaderLine(in, line, file);
  while (readHeaderLine(in, line, file)) {
    const std::vector<std::string> words = splitAtBlanks(line);
    if (words.empty()) continue;
    if (words[0] == "end_header") return header.finish(in);
    header.take(words);
  }
  failReading(file, "its header has no end");
}

}  // namespace toss
