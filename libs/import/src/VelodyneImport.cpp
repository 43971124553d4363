// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <toss/geometry/Error.h>
#include <toss/import/UdpPackets.h>
#include <toss/import/VelodyneImport.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/RawlogWriter.h>

#include "VelodyneModel.h"
#include "VelodynePackets.h"
#include "VelodynePosition.h"
#include "VelodyneRevolution.h"
#include "VelodyneSurvey.h"

namespace toss {
namespace {

double seconds(std::int64_t nanoseconds) {
  return 1e-9 * static_cast<double>(nanoseconds);
}

/// Writes the observations of one capture.
class VelodyneLog {
 public:
  VelodyneLog(const std::filesystem::path& rawlog, const VelodyneImportOptions& options,
              const VelodyneSurvey& survey, const mrpt::obs::VelodyneCalibration& calibration)
      : options_(options), survey_(survey), writer_(rawlog, options.gz) {
    scan_.calibration = calibration;
    scan_.sensorLabel = options.label;
    scan_.sensorPose = toMrpt(options.robotFromSensor);
  }

  void add(const UdpPacket& packet) {
    if (isChosenData(packet, options_)) {
      if (const auto packets = revolution_.add({velodyneRawPacket(packet), packet.captureTime}))
        writeScan(*packets);
    } else if (isFromSource(packet, options_) && isVelodynePosition(packet)) {
      writePosition(packet);
    }
  }

  void finish() {
    const std::vector<TimedPacket> rest = revolution_.rest();
    if (!rest.empty()) writeScan(rest);
    writer_.commit();
  }

  VelodyneImportResult result;

 private:
  double timeOf(std::uint32_t microseconds, std::int64_t captureTime) const {
    return survey_.clock ? survey_.clock->timeOf(microseconds, captureTime) : seconds(captureTime);
  }

  void writeScan(const std::vector<TimedPacket>& packets) {
    const TimedPacket& first = packets.front();
    scan_.timestamp = toMrptTime(timeOf(first.raw.gps_timestamp(), first.captureTime));
    scan_.originalReceivedTimestamp = toMrptTime(seconds(first.captureTime));
    scan_.has_satellite_timestamp = survey_.clock.has_value();
    scan_.scan_packets.clear();
    for (const TimedPacket& packet : packets) scan_.scan_packets.push_back(packet.raw);
    writer_.write(scan_);
    ++result.scans;
    result.packets += packets.size();
  }

  void writePosition(const UdpPacket& packet) {
    const auto position = readVelodynePosition(packet);
    if (!position) return;
    mrpt::obs::CObservationGPS gps;
    gps.sensorLabel = options_.label + "_GPS";
    gps.sensorPose = scan_.sensorPose;
    gps.timestamp = toMrptTime(timeOf(position->microseconds, packet.captureTime));
    gps.originalReceivedTimestamp = toMrptTime(seconds(packet.captureTime));
    gps.has_satellite_timestamp = survey_.clock.has_value();
    gps.setMsg(position->sentence);
    writer_.write(gps);
    ++result.positions;
  }

  const VelodyneImportOptions& options_;
  const VelodyneSurvey& survey_;
  RawlogWriter writer_;
  VelodyneRevolution revolution_;
  mrpt::obs::CObservationVelodyneScan scan_;
};

std::vector<std::string> warningsOf(const VelodyneSurvey& survey, const UdpPacketReader& reader,
                                    const std::string& file) {
  std::vector<std::string> warnings = reader.warnings();
  if (survey.disagreeing > 0)
    warnings.push_back(file + ": the sensor's clock is not set by its GPS receiver (" +
                       std::to_string(survey.disagreeing) +
                       " sentences disagree with it); scans have the time of capture");
  else if (survey.sentences > 0 && survey.validSentences == 0)
    warnings.push_back(file + ": its GPS receiver had no fix; scans have the time of capture");
  return warnings;
}

}  // namespace

VelodyneImportResult importVelodyne(const std::filesystem::path& capture,
                                    const std::filesystem::path& rawlog,
                                    const VelodyneImportOptions& options) {
  const VelodyneModel& model = velodyneModelByName(options.model);
  const VelodyneSurvey survey = surveyCapture(capture, options);
  checkSurvey(survey, capture, options, model);
  VelodyneLog log(rawlog, options, survey, readCalibration(options.calibration, model));
  UdpPacketReader reader(capture);
  UdpPacket packet;
  while (reader.next(packet)) {
    log.add(packet);
    if (options.progress) options.progress(reader.progress());
  }
  log.finish();
  log.result.satelliteTime = survey.clock.has_value();
  log.result.dualReturn = model.name != "HDL64" && survey.dual > 0;
  log.result.warnings = warningsOf(survey, reader, capture.string());
  return log.result;
}

}  // namespace toss
