// SPDX-License-Identifier: BSD-3-Clause
#include "SensorOfInput.h"

#include "ScanRange.h"

namespace toss {

SensorChoice sensorOfInput(const std::filesystem::path& input,
                           const RunConfiguration& configuration, std::uint64_t from,
                           std::uint64_t to) {
  if (const std::string& wanted = configuration.sensor.model; wanted != "auto")
    return {sensorByName(wanted), wanted, wanted};
  ScanRange scans(input, configuration.input, from, to);
  PosedScan scan;
  do {
    if (!scans.next(scan))
      throw UserError(input.string(), "no scan in the chosen range has returns and a pose",
                      "look at it with toss info");
  } while (scan.points.empty());
  return chooseSensor(scan);
}

}  // namespace toss
