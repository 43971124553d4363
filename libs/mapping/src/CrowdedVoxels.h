// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <tsl/robin_map.h>

namespace toss {

/// Limits what one scan and owner may add to a voxel. Few voxels are so crowded that it matters:
/// first all returns are counted in places that voxels share, then those are looked at more closely
/// whose place is over the limit.
class CrowdedVoxels {
 public:
  CrowdedVoxels() : counts_(std::size_t{1} << kPlaceBits) {}

  /// Begins a new scan, of which a voxel may take `cap` returns from each owner.
  void clear(std::uint32_t cap);
  void count(const VoxelRun& run) {
    std::uint32_t& count = counts_[placeOf(run)];
    count += static_cast<std::uint32_t>(run.count());
    any_ |= count > cap_;
  }
  /// Whether some voxel may be crowded, and whether that of a run may be.
  bool any() const { return any_; }
  bool has(const VoxelRun& run) const { return counts_[placeOf(run)] > cap_; }

  /// Takes a return while there is room for it.
  void add(const VoxelRun& single);
  /// Calls `visit(const VoxelRun&)` for the runs of what was taken.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const VoxelRun& run : full_) visit(run);
    for (const auto& [name, taken] : taken_)
      if (taken.run.count() > 0) visit(taken.run);
  }

 private:
  static constexpr int kPlaceBits = 16;
  /// Voxel and owner.
  using Name = std::pair<VoxelKey, std::size_t>;
  struct Hash {
    std::size_t operator()(const Name& name) const { return hash(name.first, name.second); }
  };
  struct Taken {
    std::uint32_t count = 0;
    /// The last of them, as many as fit into a run.
    VoxelRun run;
  };

  static std::size_t hash(VoxelKey key, std::size_t owner) {
    const std::uint64_t mixed = (key + (std::uint64_t{owner} << 37)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(mixed ^ mixed >> 32);
  }
  static std::size_t placeOf(const VoxelRun& run) {
    return hash(run.key, run.owner()) & ((std::size_t{1} << kPlaceBits) - 1);
  }

  std::uint32_t cap_ = 1;
  bool any_ = false;
  std::vector<std::uint32_t> counts_;
  tsl::robin_map<Name, Taken, Hash> taken_;
  std::vector<VoxelRun> full_;
};

}  // namespace toss
