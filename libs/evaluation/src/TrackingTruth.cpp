// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/TrackingTruth.h>
#include <toss/rawlog/LabelFile.h>

#include <algorithm>
#include <map>
#include <utility>

namespace toss {
namespace {

using Overlaps = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t>;

/// Returns of objects and tracks in one scan, and of their intersections.
struct ReturnCounts {
  /// By true label (class and instance), of moving objects.
  std::map<std::uint32_t, std::uint64_t> object;
  /// By number of the track: annotated returns, and all.
  std::map<std::uint32_t, std::uint64_t> annotated, track;
  Overlaps overlap;
};

ReturnCounts countReturns(const std::vector<std::uint32_t>& truth,
                          const std::vector<std::uint32_t>& called, bool ignoreUnlabelled) {
  ReturnCounts counts;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool object = label::isMoving(truth[i]) && label::instance(truth[i]) != 0;
    const bool track = label::isMoving(called[i]) && label::instance(called[i]) != 0;
    const bool annotated = !ignoreUnlabelled || label::semantic(truth[i]) != 0;
    const std::uint32_t number = label::instance(called[i]);
    if (object) ++counts.object[truth[i]];
    if (track) ++counts.track[number];
    if (track && annotated) ++counts.annotated[number];
    if (track && object) ++counts.overlap[{truth[i], number}];
  }
  return counts;
}

/// Takes objects that are too small out of the counts: as if they were not annotated.
void dropSmallObjects(std::uint64_t minReturns, ReturnCounts& counts) {
  for (auto it = counts.overlap.begin(); it != counts.overlap.end();) {
    const bool small = counts.object[it->first.first] < minReturns;
    if (small) counts.annotated[it->first.second] -= it->second;
    it = small ? counts.overlap.erase(it) : std::next(it);
  }
  for (auto it = counts.object.begin(); it != counts.object.end();) {
    it = it->second < minReturns ? counts.object.erase(it) : std::next(it);
  }
}

template <typename Map, typename Key>
std::int32_t placeOf(const Map& map, const Key& key) {
  return static_cast<std::int32_t>(std::distance(map.begin(), map.find(key)));
}

void addPairs(const ReturnCounts& counts, double gate, TrackingScan& scan) {
  for (const auto& [pair, common] : counts.overlap) {
    const std::uint64_t sum = counts.object.at(pair.first) + counts.annotated.at(pair.second);
    const double similarity = static_cast<double>(common) / static_cast<double>(sum - common);
    if (similarity < gate) continue;
    scan.pairs.push_back(
        {placeOf(counts.object, pair.first), placeOf(counts.track, pair.second), similarity});
  }
}

using RowsByScan = std::map<std::uint64_t, std::vector<const TrackRow*>>;

RowsByScan movingRows(const std::vector<TrackRow>& rows) {
  RowsByScan byScan;
  for (const TrackRow& row : rows) {
    if (row.sample.moving) byScan[row.scan].push_back(&row);
  }
  return byScan;
}

/// Similarity of two boxes, negative where they don't pass the gate.
double boxSimilarity(const Box& a, const Box& b, const EvaluationOptions& options) {
  if (options.boxMatch == BoxMatch::Distance) {
    const double distance = (a.center - b.center).head<2>().norm();
    return 1.0 - distance / options.boxDistance;
  }
  const double overlap = intersectionOverUnion(a, b);
  return overlap < options.boxOverlap ? -1.0 : overlap;
}

TrackingScan scanFromRows(const std::vector<const TrackRow*>& truth,
                          const std::vector<const TrackRow*>& called,
                          const EvaluationOptions& options) {
  TrackingScan scan;
  for (const TrackRow* row : truth) scan.objects.push_back(row->sample.track);
  for (const TrackRow* row : called) scan.tracks.push_back(row->sample.track);
  scan.excused.assign(called.size(), false);
  for (std::size_t o = 0; o < truth.size(); ++o) {
    for (std::size_t t = 0; t < called.size(); ++t) {
      const double similarity = boxSimilarity(truth[o]->sample.box, called[t]->sample.box, options);
      if (similarity < 0.0) continue;
      scan.pairs.push_back(
          {static_cast<std::int32_t>(o), static_cast<std::int32_t>(t), similarity});
    }
  }
  return scan;
}

}  // namespace

TrackingScan trackingScanFromLabels(const std::vector<std::uint32_t>& truth,
                                    const std::vector<std::uint32_t>& called, bool ignoreUnlabelled,
                                    const EvaluationOptions& options) {
  ReturnCounts counts = countReturns(truth, called, ignoreUnlabelled);
  const auto minReturns = static_cast<std::uint64_t>(options.trackingMinReturns);
  dropSmallObjects(minReturns, counts);
  TrackingScan scan;
  for (const auto& [object, returns] : counts.object) scan.objects.push_back(object);
  for (const auto& [track, returns] : counts.track) {
    scan.tracks.push_back(track);
    const std::uint64_t annotated = counts.annotated[track];
    scan.excused.push_back(2 * annotated < returns || annotated < minReturns);
  }
  addPairs(counts, options.trackingOverlap, scan);
  return scan;
}

std::vector<TrackingScan> trackingScansFromBoxes(const std::vector<TrackRow>& truth,
                                                 const std::vector<TrackRow>& called,
                                                 const std::vector<std::uint64_t>& scans,
                                                 const EvaluationOptions& options) {
  const RowsByScan objects = movingRows(truth), tracks = movingRows(called);
  static const std::vector<const TrackRow*> none;
  const auto rowsOf = [](const RowsByScan& rows, std::uint64_t scan) -> const auto& {
    const auto found = rows.find(scan);
    return found == rows.end() ? none : found->second;
  };
  std::vector<TrackingScan> result;
  for (const std::uint64_t scan : scans) {
    result.push_back(scanFromRows(rowsOf(objects, scan), rowsOf(tracks, scan), options));
  }
  return result;
}

}  // namespace toss
