// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneSurvey.h"

#include <toss/geometry/Error.h>

#include <algorithm>
#include <cmath>

#include "VelodynePackets.h"
#include "VelodynePosition.h"

namespace toss {
namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

constexpr double kHour = 3600.0;
/// A sentence comes up to a second after its second, and is repeated until the next one.
constexpr double kOldestSentence = 2.5;

/// Difference of two times within the hour, from minus to plus half an hour [s].
double withinHour(double difference) {
  return difference - kHour * std::round(difference / kHour);
}

void lookAtPosition(const UdpPacket& packet, VelodyneSurvey& survey) {
  const auto position = readVelodynePosition(packet);
  if (!position) return;
  ++survey.sentences;
  if (!position->valid()) return;
  ++survey.validSentences;
  const double sinceSentence =
      withinHour(1e-6 * position->microseconds - std::fmod(position->time, kHour));
  if (std::abs(sinceSentence) > kOldestSentence) {
    ++survey.disagreeing;
    return;
  }
  const double time = position->time + sinceSentence;
  if (!survey.clock)
    survey.clock = SatelliteClock{time - 1e-9 * static_cast<double>(packet.captureTime)};
}

void lookAtData(const UdpPacket& packet, VelodyneSurvey& survey) {
  const VelodyneRawPacket raw = velodyneRawPacket(packet);
  ++survey.packets;
  ++survey.byOrigin[{packet.sourceAddress, packet.destinationPort}];
  ++survey.byFactoryByte[raw.velodyne_model_ID];
  survey.dual += raw.laser_return_mode == Scan::RETMODE_DUAL;
  survey.lowerBank += hasLowerBank(raw);
}

std::string listOfOthers(const VelodyneSurvey& survey) {
  if (survey.others.empty()) return "";
  const auto most =
      std::max_element(survey.others.begin(), survey.others.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return ", but others, most of them of " + std::to_string(most->first) + " bytes";
}

[[noreturn]] void failWithoutPackets(const VelodyneSurvey& survey, const std::string& file,
                                     const VelodyneImportOptions& options) {
  const bool chosen = options.port != 0 || !options.source.empty();
  const std::string where = (options.port == 0 ? "" : " to port " + std::to_string(options.port)) +
                            (options.source.empty() ? "" : " from " + options.source);
  throw UserError(file, "holds no data packets of a Velodyne sensor" + where + listOfOthers(survey),
                  chosen ? "leave out --port and --source to take any"
                         : "capture what the sensor sends to its data port, 2368 by default");
}

std::string listOfOrigins(const VelodyneSurvey& survey) {
  std::string text;
  for (const auto& [origin, count] : survey.byOrigin)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " from " +
            addressText(origin.first) + " to port " + std::to_string(origin.second);
  return text;
}

/// Name of the model in most packets, "" where they do not tell.
std::string modelInPackets(const VelodyneSurvey& survey) {
  if (survey.lowerBank > 0) return "HDL-64E";
  const auto most =
      std::max_element(survey.byFactoryByte.begin(), survey.byFactoryByte.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return modelOfFactoryByte(most->first);
}

void checkModel(const VelodyneSurvey& survey, const std::string& file,
                const VelodyneImportOptions& options, const VelodyneModel& model) {
  const std::string found = modelInPackets(survey);
  if (model.name == "HDL64" && survey.lowerBank == 0)
    throw UserError(file,
                    "its packets are not those of an HDL-64E" +
                        (found.empty() ? "" : ", but of model " + found),
                    "give the --model that recorded them");
  // A Puck LITE has the beams of a VLP-16; a Puck Hi-Res has others, in the same packets.
  const bool likeVlp16 =
      found == "Puck LITE" || (found == "Puck Hi-Res" && !options.calibration.empty());
  if (found.empty() || found == model.sensor || (likeVlp16 && model.name == "VLP16")) return;
  if (found == "Puck Hi-Res" && model.name == "VLP16")
    throw UserError(file, "its packets are those of a Puck Hi-Res, which has other beams",
                    "give its calibration with --calibration");
  const bool known = found == "HDL-32E" || found == "VLP-16" || found == "HDL-64E";
  throw UserError(file, "its packets are of model " + found + ", not of --model " + model.name,
                  known ? "give the --model that recorded them" : "this model can't be decoded");
}

}  // namespace

double SatelliteClock::timeOf(std::uint32_t microseconds, std::int64_t captureTime) const {
  const double about = 1e-9 * static_cast<double>(captureTime) + offset;
  return about + withinHour(1e-6 * microseconds - std::fmod(about, kHour));
}

VelodyneSurvey surveyCapture(const std::filesystem::path& capture,
                             const VelodyneImportOptions& options) {
  UdpPacketReader reader(capture);
  VelodyneSurvey survey;
  UdpPacket packet;
  while (reader.next(packet)) {
    if (isChosenData(packet, options))
      lookAtData(packet, survey);
    else if (isFromSource(packet, options) && isVelodynePosition(packet))
      lookAtPosition(packet, survey);
    else
      ++survey.others[packet.size];
  }
  if (survey.disagreeing > 0) survey.clock.reset();
  return survey;
}

void checkSurvey(const VelodyneSurvey& survey, const std::filesystem::path& capture,
                 const VelodyneImportOptions& options, const VelodyneModel& model) {
  if (survey.packets == 0) failWithoutPackets(survey, capture.string(), options);
  if (survey.byOrigin.size() > 1)
    throw UserError(capture.string(),
                    "holds data packets of several sensors: " + listOfOrigins(survey),
                    "choose one with --port or --source");
  checkModel(survey, capture.string(), options, model);
}

}  // namespace toss
