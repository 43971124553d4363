// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/VelodyneImport.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "VelodyneModel.h"

namespace toss {

/// The difference between satellite time and the time of capture, for turning the sensor's clock,
/// which begins anew each hour, into time.
struct SatelliteClock {
  /// Satellite time minus time of capture [s].
  double offset = 0.0;

  /// Time [s] of a packet. `microseconds`: sensor's clock; `captureTime`: [ns].
  double timeOf(std::uint32_t microseconds, std::int64_t captureTime) const;
};

/// What a capture holds, as far as it is told before its packets are written.
struct VelodyneSurvey {
  /// Data packets that were chosen, and of them those with two returns per firing and with blocks
  /// of the lower bank.
  std::uint64_t packets = 0, dual = 0, lowerBank = 0;
  /// Data packets by sender's address and port they were sent to.
  std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint64_t> byOrigin;
  /// Data packets by their last byte.
  std::map<std::uint8_t, std::uint64_t> byFactoryByte;
  /// Other datagrams, by size.
  std::map<std::size_t, std::uint64_t> others;
  /// Position packets with a sentence; of them those whose receiver is sure, and those which do not
  /// agree with the sensor's clock.
  std::uint64_t sentences = 0, validSentences = 0, disagreeing = 0;
  /// Where the sentences are to be trusted.
  std::optional<SatelliteClock> clock;
};

/// Looks through a capture. Throws UserError where it can't be read.
VelodyneSurvey surveyCapture(const std::filesystem::path& capture,
                             const VelodyneImportOptions& options);

/// Throws UserError where the packets are none, of several sensors, or of another model.
void checkSurvey(const VelodyneSurvey& survey, const std::filesystem::path& capture,
                 const VelodyneImportOptions& options, const VelodyneModel& model);

}  // namespace toss
