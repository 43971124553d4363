// SPDX-License-Identifier: BSD-3-Clause
#include "ObjectLengths.h"

#include <cstring>
#include <optional>

namespace toss {
namespace {

/// Walks through the fields of a serialized object; good() until they run out.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : left_(bytes) {}

  bool good() const { return good_; }

  std::string_view bytes(std::size_t count) {
    good_ = good_ && count <= left_.size();
    if (!good_) return {};
    const std::string_view result = left_.substr(0, count);
    left_.remove_prefix(count);
    return result;
  }

  template <typename Number>
  Number number() {
    Number value{};
    const std::string_view raw = bytes(sizeof value);
    if (good_) std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }

  /// Class name and version with which each object begins.
  std::string_view objectHead() {
    const std::string_view name = bytes(number<std::uint8_t>() & 0x7fu);
    number<std::uint8_t>();
    return name;
  }

 private:
  std::string_view left_;
  bool good_ = true;
};

/// Sizes on file: a CPose3D with its head and end, a packet, the coordinates of a point.
constexpr std::size_t kPoseBytes = 119, kPacketBytes = 1206, kPointBytes = 12, kTimeBytes = 8;

std::string tooMany(std::uint64_t count, const char* what) {
  return "is cut off or corrupt: it claims " + std::to_string(count) + " " + what +
         ", more than the rest of the file can hold";
}

/// Skips a text; its length where that is impossible.
std::optional<std::uint64_t> skipText(FieldReader& fields, std::uint64_t bytesLeft) {
  const std::uint32_t length = fields.number<std::uint32_t>();
  if (fields.good() && length > bytesLeft) return length;
  fields.bytes(length);
  return std::nullopt;
}

std::string checkPointCloud(FieldReader& fields, std::uint64_t bytesLeft) {
  if (const auto length = skipText(fields, bytesLeft))
    return tooMany(*length, "letters of a label");
  fields.bytes(kTimeBytes + kPoseBytes);
  const bool external = fields.number<std::uint8_t>() != 0;
  if (external) {
    const auto length = skipText(fields, bytesLeft);
    return length ? tooMany(*length, "letters of a file name") : "";
  }
  const std::string_view mapClass = fields.objectHead();
  const std::uint64_t points = fields.number<std::uint32_t>();
  const bool isMap = mapClass.find("PointsMap") != std::string_view::npos;
  return fields.good() && isMap && points * kPointBytes > bytesLeft ? tooMany(points, "points")
                                                                    : "";
}

std::string checkVelodyneScan(FieldReader& fields, std::uint64_t bytesLeft) {
  fields.bytes(kTimeBytes);
  if (const auto length = skipText(fields, bytesLeft))
    return tooMany(*length, "letters of a label");
  fields.bytes(2 * sizeof(double) + kPoseBytes);
  const std::uint64_t packets = fields.number<std::uint32_t>();
  return fields.good() && packets * kPacketBytes > bytesLeft ? tooMany(packets, "packets") : "";
}

}  // namespace

std::string impossibleLength(std::string_view head, std::uint64_t bytesLeft) {
  FieldReader fields(head);
  const std::string_view name = fields.objectHead();
  if (name == "mrpt::obs::CObservationPointCloud") return checkPointCloud(fields, bytesLeft);
  if (name == "mrpt::obs::CObservationVelodyneScan") return checkVelodyneScan(fields, bytesLeft);
  return "";
}

}  // namespace toss
