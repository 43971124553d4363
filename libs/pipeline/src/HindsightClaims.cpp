// SPDX-License-Identifier: BSD-3-Clause
#include "HindsightClaims.h"

#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>

#include <algorithm>
#include <array>

#include "ClaimGrid.h"

namespace toss {
namespace {

/// Stretch of a trace's path by which it is followed back, and what is too short for that [s].
constexpr double kPath = 1.0, kShortestPath = 0.4;
/// Below this [m/s] a trace has no way to follow.
constexpr double kSlowest = 0.1;
constexpr double kTimeTolerance = 1e-3;

using Samples = std::vector<TrackSample>;

Samples::const_iterator firstFrom(const Samples& samples, TrackId track) {
  return std::lower_bound(samples.begin(), samples.end(), track,
                          [](const TrackSample& sample, TrackId id) { return sample.track < id; });
}

/// Mean velocity of a trace over the first stretch of its path that is long enough, zero where
/// there is none.
Eigen::Vector3d firstVelocity(const std::deque<ScanRecord>& records, std::size_t birth,
                              const TrackSample& first) {
  const double start = records[birth].time;
  std::size_t end = birth;
  while (end + 1 < records.size() && records[end].time < start + kPath - kTimeTolerance) ++end;
  for (; records[end].time > start + kShortestPath - kTimeTolerance; --end) {
    const auto sample = firstFrom(records[end].tracks, first.track);
    if (sample != records[end].tracks.end() && sample->track == first.track)
      return (sample->box.center - first.box.center) / (records[end].time - start);
  }
  return Eigen::Vector3d::Zero();
}

/// Marks the returns above ground. The compiler vectorises this only as a function of arrays that
/// are known not to overlap.
TOSS_ALSO_FOR_AVX2
void findObjects(const PointClass* __restrict pointClass, std::size_t n,
                 std::uint8_t* __restrict object) {
  for (std::size_t i = 0; i < n; ++i)
    object[i] = static_cast<std::uint8_t>((pointClass[i] == PointClass::Unclustered) |
                                          (pointClass[i] == PointClass::Instance));
}

}  // namespace

HindsightClaims::HindsightClaims(const DecisionOptions& options, const MappingOptions& mapping,
                                 const TraceBook& traces)
    : claiming_(options.claims && options.hindsightTime > 0.0 && options.residueMargin > 0.0 &&
                mapping.voxelSize > 0.0),
      birthTime_(options.hindsightTime),
      margin_(static_cast<float>(options.residueMargin)),
      traces_(traces),
      boxes_({options.residueMargin, 0.0}, 0.0) {}

void HindsightClaims::add(Records& records, std::size_t index, bool last,
                          std::vector<bool>& moving) {
  if (!claiming_) return;
  findClaimants(records, index, last);
  if (claimants_.empty()) return;
  ScanRecord& record = records[index];
  claimReturns(moving, record);
  for (std::size_t o = moving.size(); o < record.owners.size(); ++o)
    moving.push_back(isDynamic(traces_.finalClass(record.owners[o].track, last)));
  std::vector<std::int32_t> all;
  all.reserve(record.residue.size() + claimed_.size());
  std::set_union(record.residue.begin(), record.residue.end(), claimed_.begin(), claimed_.end(),
                 std::back_inserter(all));
  record.residue.swap(all);
}

void HindsightClaims::findClaimants(const Records& records, std::size_t index, bool last) {
  claimants_.clear(), trackOf_.clear();
  const ScanRecord& scan = records[index];
  for (const TrackSample& sample : scan.tracks)
    if (traces_.mayMove(sample.track, last)) addClaimant(sample.track, sample.box);
  for (std::size_t birth = index + 1; birth < records.size(); ++birth) {
    if (records[birth].time > scan.time + birthTime_ + kTimeTolerance) break;
    followBack(records, birth, scan.time, last);
  }
}

void HindsightClaims::followBack(const Records& records, std::size_t birth, double time,
                                 bool last) {
  const Samples& tracks = records[birth].tracks;
  for (auto first = firstFrom(tracks, records[birth].firstNewTrack); first != tracks.end();
       ++first) {
    if (!traces_.mayMove(first->track, last)) continue;
    const Eigen::Vector3d velocity = firstVelocity(records, birth, *first);
    if (velocity.head<2>().norm() < kSlowest) continue;
    Box before = first->box;
    before.center -= (records[birth].time - time) * velocity;
    addClaimant(first->track, before);
  }
}

void HindsightClaims::addClaimant(TrackId track, const Box& box) {
  claimants_.push_back({box, BoxClaims::Claimant::Takes::Nothing});
  trackOf_.push_back(track);
}

void HindsightClaims::claimReturns(const std::vector<bool>& moving, ScanRecord& record) {
  boxes_.take(claimants_, record.sensorPosition);
  markSquares(record.sensorPosition);
  owners_.start(claimants_.size(), record.owners.size());
  claimed_.clear();
  visitNearby(record, [&](std::size_t i) {
    if (moving[record.owner[i]]) return;
    const LevelPoints& level = record.level;
    const std::int32_t claimant = boxes_.boxAround({level.x[i], level.y[i], level.z[i]}, -1);
    if (claimant >= 0) claim(i, claimant, record);
  });
}

void HindsightClaims::markSquares(const Eigen::Vector3d& sensorPosition) {
  marks_.assign(static_cast<std::size_t>(ClaimGrid::kSquares) * ClaimGrid::kSquares, 0);
  for (const BoxClaims::Claimant& claimant : claimants_) {
    const Eigen::AlignedBox2f area =
        ClaimFootprint(claimant.box, sensorPosition, 0.0).extent(margin_ + ClaimGrid::kRounding);
    const std::int32_t lastRow = ClaimGrid::along(area.max().x());
    const std::int32_t begin = ClaimGrid::along(area.min().y());
    const std::int32_t end = ClaimGrid::along(area.max().y()) + 1;
    for (std::int32_t row = ClaimGrid::along(area.min().x()); row <= lastRow; ++row)
      std::fill_n(marks_.begin() + row * ClaimGrid::kSquares + begin, end - begin, 1);
  }
}

template <typename Visit>
void HindsightClaims::visitNearby(const ScanRecord& record, Visit&& visit) const {
  constexpr std::size_t kBlock = 4 * kMarksInBlock;
  std::array<std::int32_t, kBlock> square;
  std::array<std::uint8_t, kBlock> wanted{};
  const std::size_t n = record.owner.size();
  for (std::size_t begin = 0; begin < n; begin += kBlock) {
    const std::size_t size = std::min(kBlock, n - begin);
    findObjects(record.pointClass.data() + begin, size, wanted.data());
    std::fill(wanted.begin() + size, wanted.end(), std::uint8_t{0});
    // Many blocks hold nothing but ground.
    if (std::find(wanted.begin(), wanted.end(), std::uint8_t{1}) == wanted.end()) continue;
    ClaimGrid::findSquares(record.level.x.data() + begin, record.level.y.data() + begin, size,
                           square.data());
    for (std::size_t i = 0; i < size; ++i) wanted[i] &= marks_[static_cast<std::size_t>(square[i])];
    visitMarks(wanted.data(), kBlock, [&](std::size_t i) { visit(begin + i); });
  }
}

void HindsightClaims::claim(std::size_t point, std::int32_t claimant, ScanRecord& record) {
  const Owner& before = record.owners[record.owner[point]];
  const std::int32_t host = before.instance ? std::int32_t{record.owner[point]} : before.host;
  claimed_.push_back(static_cast<std::int32_t>(point));
  const auto [owner, isNew] = owners_.ownerOf({claimed_.back(), claimant, host, true});
  if (isNew)
    record.owners.push_back(
        Owner::ofClaim(trackOf_[static_cast<std::size_t>(claimant)], host, true));
  record.owner[point] = ScanRecord::ownerIndex(owner);
}

}  // namespace toss
