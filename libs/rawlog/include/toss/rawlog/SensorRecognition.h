// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/geometry/SensorModel.h>

#include <string>

namespace toss {

/// Name of the sensor model, one of knownSensors(), that made the scan: as the input tells it (its
/// beams included), else by the sensor's label ("hdl64", "OS1-64"), else by the elevations of the
/// returns. "" if unknown.
std::string recognizeSensor(const PosedScan& scan);

/// The known model whose name is in the text, however it is written ("hdl64", "My OS1-64"); "" if
/// none is.
std::string sensorNamedIn(const std::string& given);

/// How well the returns of a scan agree with the beams of a model, shares from 0 to 1.
struct BeamAgreement {
  /// Returns that lie between the beams of the model, half a beam spacing beyond them included.
  double inside = 0.0;
  /// Of these, returns nearer to a beam than to the middle between two: 0.5 where beams and returns
  /// have nothing to do with each other.
  double nearBeam = 0.0;
  /// Beams that have returns.
  double beamsUsed = 0.0;

  double score() const { return inside * nearBeam * beamsUsed; }
};

/// Judges returns that are at least 5 m away: nearer ones show that beams do not start in one
/// point.
BeamAgreement beamAgreement(const PointCloud& points, const SensorModel& sensor);

}  // namespace toss
