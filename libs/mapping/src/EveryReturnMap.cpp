// SPDX-License-Identifier: BSD-3-Clause
#include "EveryReturnMap.h"

#include <toss/mapping/MapOffset.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace toss {

EveryReturnMap::EveryReturnMap(const MappingOptions& options, const Eigen::Vector3d& origin)
    : origin_(mapOffset(origin)) {
  options.check();
}

EveryReturnMap::GroupIndex EveryReturnMap::addGroup(const ScanReturns& scan, IndexSpan indices,
                                                    bool kept) {
  if (!scan.sensorPosition.allFinite()) {
    throw UserError("pose of the sensor", "is not finite", "check the poses");
  }
  Group group;
  group.kept = kept;
  group.points.reserve(indices.count);
  for (const std::int32_t index : indices) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3d level(scan.level.x[i], scan.level.y[i], scan.level.z[i]);
    const Eigen::Vector3f p = (level + (scan.sensorPosition - origin_)).cast<float>();
    const float intensity = scan.intensity.empty() ? 0.0f : scan.intensity[i];
    if (!p.allFinite()) continue;
    group.points.push_back({p.x(), p.y(), p.z(), std::isfinite(intensity) ? intensity : 0.0f});
  }
  leftOut_ += indices.count - group.points.size();
  if (kept) size_ += group.points.size();
  groups_.push_back(std::move(group));
  return groups_.size() - 1;
}

EveryReturnMap::Boxes::iterator EveryReturnMap::find(BoxId box) {
  const auto found = ofBox_.find(box);
  if (found == ofBox_.end()) {
    throw std::logic_error("EveryReturnMap: box " + std::to_string(box) + " is unknown or settled");
  }
  return found;
}

void EveryReturnMap::keep(GroupIndex index, bool kept) {
  Group& group = groups_[index];
  if (group.kept == kept) return;
  group.kept = kept;
  size_ = kept ? size_ + group.points.size() : size_ - group.points.size();
}

void EveryReturnMap::settle(GroupIndex index) {
  if (!groups_[index].kept) groups_[index].points = std::vector<MapPoint>();
}

void EveryReturnMap::addPermanent(const ScanReturns& scan, IndexSpan indices) {
  addGroup(scan, indices, true);
}

void EveryReturnMap::addBox(BoxId box, TrackId track, const ScanReturns& scan, IndexSpan indices,
                            bool dynamic) {
  const auto [place, isNew] = ofBox_.try_emplace(box);
  if (!isNew) throw std::logic_error("EveryReturnMap: box " + std::to_string(box) + " comes twice");
  place.value() = {track, addGroup(scan, indices, !dynamic)};
}

void EveryReturnMap::addToTrack(TrackId track, const ScanReturns& scan, IndexSpan indices) {
  const GroupIndex group = addGroup(scan, indices, true);
  if (track != 0) ofTrack_[track].push_back(group);
}

void EveryReturnMap::setDynamic(BoxId box, bool dynamic) {
  keep(find(box)->second.group, !dynamic);
}

void EveryReturnMap::fold(BoxId box) {
  const auto place = find(box);
  const auto [track, group] = place->second;
  if (groups_[group].kept && track != 0) ofTrack_[track].push_back(group);
  settle(group);
  ofBox_.erase(place);
}

void EveryReturnMap::revokeTrack(TrackId track) {
  const auto place = ofTrack_.find(track);
  if (place == ofTrack_.end()) return;
  for (const GroupIndex group : place->second) {
    keep(group, false);
    settle(group);
  }
  ofTrack_.erase(place);
}

void EveryReturnMap::settleBox(BoxId box) {
  const auto place = find(box);
  settle(place->second.group);
  ofBox_.erase(place);
}

void EveryReturnMap::finish() {
  for (const auto& [box, entry] : ofBox_) settle(entry.group);
  ofBox_.clear();
  ofTrack_.clear();
}

void EveryReturnMap::visitPoints(const Eigen::Vector3d& offset,
                                 const std::function<void(const MapPoint&)>& visit) const {
  const Eigen::Vector3d shift = origin_ - offset;
  for (const Group& group : groups_) {
    if (!group.kept) continue;
    for (const MapPoint& point : group.points) {
      const Eigen::Vector3f p = (Eigen::Vector3d(point.x, point.y, point.z) + shift).cast<float>();
      visit({p.x(), p.y(), p.z(), point.intensity});
    }
  }
}

std::size_t EveryReturnMap::ledgerBytes() const {
  std::size_t bytes = ofBox_.bucket_count() * sizeof(Boxes::value_type);
  for (const auto& [box, entry] : ofBox_) {
    const Group& group = groups_[entry.group];
    if (!group.kept) bytes += group.points.capacity() * sizeof(MapPoint);
  }
  for (const auto& [track, groups] : ofTrack_) bytes += groups.capacity() * sizeof(GroupIndex);
  return bytes;
}

}  // namespace toss
