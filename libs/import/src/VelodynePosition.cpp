// SPDX-License-Identifier: BSD-3-Clause
#include "VelodynePosition.h"

#include <mrpt/system/datetime.h>
#include <toss/rawlog/MrptConversion.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace toss {
namespace {

using mrpt::obs::gnss::Message_NMEA_RMC;

constexpr std::size_t kClockAt = 198, kSentenceAt = 206;

/// The fields between '$' and '*', if the checksum behind fits.
std::vector<std::string> fieldsOf(const std::string& text) {
  const std::size_t star = text.find('*');
  if (text.empty() || text[0] != '$' || star == std::string::npos || star + 3 > text.size())
    return {};
  unsigned sum = 0, expected = 0;
  for (std::size_t i = 1; i < star; ++i) sum ^= static_cast<unsigned char>(text[i]);
  const char* digits = text.data() + star + 1;
  const auto parsed = std::from_chars(digits, digits + 2, expected, 16);
  if (parsed.ptr != digits + 2 || sum != expected) return {};
  std::vector<std::string> fields(1);
  for (std::size_t i = 1; i < star; ++i) {
    if (text[i] == ',')
      fields.emplace_back();
    else
      fields.back() += text[i];
  }
  return fields;
}

/// Two digits at `at`, -1 where there are none.
int pairAt(const std::string& text, std::size_t at) {
  if (text.size() < at + 2) return -1;
  int value = 0;
  const char* begin = text.data() + at;
  return std::from_chars(begin, begin + 2, value).ptr == begin + 2 ? value : -1;
}

/// NMEA writes degrees and minutes in one number: dddmm.mmmm.
double degreesOf(const std::string& text, bool negative) {
  const double value = std::atof(text.c_str());
  const double whole = std::floor(value / 100.0);
  const double angle = whole + (value - 100.0 * whole) / 60.0;
  return negative ? -angle : angle;
}

bool readTime(const std::vector<std::string>& fields, Message_NMEA_RMC::content_t& content) {
  const int hour = pairAt(fields[1], 0), minute = pairAt(fields[1], 2);
  const int day = pairAt(fields[9], 0), month = pairAt(fields[9], 2), year = pairAt(fields[9], 4);
  const double second = fields[1].size() < 6 ? -1.0 : std::atof(fields[1].c_str() + 4);
  if (hour < 0 || hour > 23 || minute < 0 || minute > 59 || !(second >= 0.0 && second < 61.0) ||
      day < 1 || day > 31 || month < 1 || month > 12 || year < 0)
    return false;
  content.UTCTime.hour = static_cast<std::uint8_t>(hour);
  content.UTCTime.minute = static_cast<std::uint8_t>(minute);
  content.UTCTime.sec = second;
  content.date_day = static_cast<std::uint8_t>(day);
  content.date_month = static_cast<std::uint8_t>(month);
  content.date_year = static_cast<std::uint8_t>(year);
  return true;
}

double unixTime(const Message_NMEA_RMC::content_t& content) {
  mrpt::system::TTimeParts parts;
  parts.year = static_cast<std::uint16_t>(2000 + content.date_year);
  parts.month = content.date_month;
  parts.day = content.date_day;
  parts.hour = content.UTCTime.hour;
  parts.minute = content.UTCTime.minute;
  parts.second = content.UTCTime.sec;
  return fromMrptTime(mrpt::system::buildTimestampFromParts(parts));
}

}  // namespace

std::optional<Message_NMEA_RMC> readRmc(const std::string& sentence) {
  const std::vector<std::string> fields = fieldsOf(sentence);
  constexpr std::size_t kFewest = 10;
  if (fields.size() < kFewest || fields[0].size() != 5 || fields[0].substr(2) != "RMC")
    return std::nullopt;
  Message_NMEA_RMC message;
  auto& content = message.fields;
  if (!readTime(fields, content)) return std::nullopt;
  content.validity_char = fields[2] == "A" ? 'A' : 'V';
  content.latitude_degrees = degreesOf(fields[3], fields[4] == "S");
  content.longitude_degrees = degreesOf(fields[5], fields[6] == "W");
  content.speed_knots = std::atof(fields[7].c_str());
  content.direction_degrees = std::atof(fields[8].c_str());
  if (fields.size() > 11)
    content.magnetic_dir = std::atof(fields[10].c_str()) * (fields[11] == "W" ? -1.0 : 1.0);
  if (fields.size() > 12 && !fields[12].empty()) content.positioning_mode = fields[12][0];
  return message;
}

std::optional<VelodynePosition> readVelodynePosition(const UdpPacket& packet) {
  if (packet.size <= kSentenceAt) return std::nullopt;
  const char* text = reinterpret_cast<const char*>(packet.payload) + kSentenceAt;
  const auto message = readRmc(std::string(text, strnlen(text, packet.size - kSentenceAt)));
  if (!message) return std::nullopt;
  VelodynePosition position;
  const std::uint8_t* clock = packet.payload + kClockAt;
  for (int i = 3; i >= 0; --i) position.microseconds = position.microseconds << 8 | clock[i];
  position.sentence = *message;
  position.time = unixTime(message->fields);
  return position;
}

}  // namespace toss
