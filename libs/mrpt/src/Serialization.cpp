// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/stl_serialization.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>

#include "MapState.h"

IMPLEMENTS_SERIALIZABLE(CDynamicFilteredPointsMap, CMetricMap, toss)

namespace toss {

std::uint8_t CDynamicFilteredPointsMap::serializeGetVersion() const {
  return 0;
}

void CDynamicFilteredPointsMap::serializeTo(mrpt::serialization::CArchive& out) const {
  finish();
  const std::lock_guard<std::mutex> lock(state_->mutex);
  out << genericMapParams << *state_->kept;
  out << insertionOptions.configuration << insertionOptions.settings;
  likelihoodOptions.writeToStream(out);
}

void CDynamicFilteredPointsMap::serializeFrom(mrpt::serialization::CArchive& in,
                                              std::uint8_t version) {
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  auto points = mrpt::maps::CPointsMapXYZI::Create();
  in >> genericMapParams >> *points;
  in >> insertionOptions.configuration >> insertionOptions.settings;
  likelihoodOptions.readFromStream(in);
  const std::lock_guard<std::mutex> lock(state_->mutex);
  state_->reset(points);
}

}  // namespace toss
