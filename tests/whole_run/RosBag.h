// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace toss::test {

/// Bytes as ROS 1 and its bags lay them out: little-endian, texts with their length in front.
class RosBytes {
 public:
  template <typename Number>
  RosBytes& add(Number number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes_.append(raw, sizeof number);
    return *this;
  }
  RosBytes& addText(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
    return *this;
  }
  /// `time` [s since 1970], rounded to the 100 ns that MRPT keeps.
  RosBytes& addTime(double time) {
    constexpr std::int64_t kPerSecond = 10'000'000;
    const std::int64_t ticks = std::llround(time * 1e7);
    add(static_cast<std::uint32_t>(ticks / kPerSecond));
    return add(static_cast<std::uint32_t>(ticks % kPerSecond * 100));
  }
  /// std_msgs/Header
  RosBytes& addHeader(double time, const std::string& frame) {
    return add(std::uint32_t{0}).addTime(time).addText(frame);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// A ROS 1 bag, format 2.0 (wiki.ros.org/Bags/Format/2.0), with one uncompressed chunk.
class RosBag {
 public:
  /// `type` and `md5` as in the topic's message definition; `time` [s since 1970].
  void addTopic(const std::string& name, const std::string& type, const std::string& md5) {
    const auto number = static_cast<std::uint32_t>(connections_.size());
    connections_.push_back(record(
        {{"op", "\x07"}, {"conn", raw(number)}, {"topic", name}},
        fields(
            {{"topic", name}, {"type", type}, {"md5sum", md5}, {"message_definition", "none"}})));
    numbers_[name] = number;
    chunk_ += connections_.back();
  }
  void add(const std::string& topic, double time, const RosBytes& message) {
    const std::string at = RosBytes().addTime(time).bytes();
    index_[numbers_.at(topic)] += at + raw(static_cast<std::uint32_t>(chunk_.size()));
    chunk_ +=
        record({{"op", "\x02"}, {"conn", raw(numbers_.at(topic))}, {"time", at}}, message.bytes());
    if (start_.empty()) start_ = at;
    end_ = at;
  }
  /// Messages must have been added by ascending time.
  void write(const std::filesystem::path& file) const {
    const std::string magic = "#ROSBAG V2.0\n";
    const std::uint64_t chunkAt = magic.size() + kHeaderSize;
    const std::string body =
        record({{"op", "\x05"}, {"compression", "none"}, {"size", raw(size32(chunk_))}}, chunk_) +
        indexRecords();
    std::ofstream(file, std::ios::binary)
        << magic << headerRecord(chunkAt + body.size()) << body << summary(chunkAt);
  }

 private:
  using Fields = std::vector<std::pair<std::string, std::string>>;
  static constexpr std::uint64_t kHeaderSize = 4096;
  static constexpr std::uint32_t kIndexEntry = 12;

  template <typename Number>
  static std::string raw(Number number) {
    return RosBytes().add(number).bytes();
  }
  static std::uint32_t size32(const std::string& text) {
    return static_cast<std::uint32_t>(text.size());
  }
  static std::string fields(const Fields& list) {
    RosBytes bytes;
    for (const auto& [name, value] : list) bytes.addText(name + "=" + value);
    return bytes.bytes();
  }
  static std::string record(const Fields& header, const std::string& data) {
    return RosBytes().addText(fields(header)).addText(data).bytes();
  }
  std::string headerRecord(std::uint64_t indexAt) const {
    const Fields header = {{"op", "\x03"},
                           {"index_pos", raw(indexAt)},
                           {"conn_count", raw(static_cast<std::uint32_t>(connections_.size()))},
                           {"chunk_count", raw(std::uint32_t{1})}};
    return record(header, std::string(kHeaderSize - 8 - fields(header).size(), ' '));
  }
  std::string indexRecords() const {
    std::string text;
    for (const auto& [connection, entries] : index_)
      text += record({{"op", "\x04"},
                      {"ver", raw(std::uint32_t{1})},
                      {"conn", raw(connection)},
                      {"count", raw(size32(entries) / kIndexEntry)}},
                     entries);
    return text;
  }
  std::string summary(std::uint64_t chunkAt) const {
    std::string text, counts;
    for (const std::string& connection : connections_) text += connection;
    for (const auto& [connection, entries] : index_)
      counts += raw(connection) + raw(size32(entries) / kIndexEntry);
    return text + record({{"op", "\x06"},
                          {"ver", raw(std::uint32_t{1})},
                          {"chunk_pos", raw(chunkAt)},
                          {"start_time", start_},
                          {"end_time", end_},
                          {"count", raw(static_cast<std::uint32_t>(index_.size()))}},
                         counts);
  }

  std::vector<std::string> connections_;
  std::map<std::string, std::uint32_t> numbers_;
  std::map<std::uint32_t, std::string> index_;  ///< of each connection: its messages' places
  std::string chunk_, start_, end_;
};

}  // namespace toss::test
