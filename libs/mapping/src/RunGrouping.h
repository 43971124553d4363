// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VoxelRuns.h"

namespace toss {

/// Groups runs by their owner and the brick of their voxel. Keeps its buffers from call to call.
class RunGrouping {
 public:
  /// The runs of one group, in order of their coming.
  struct Group {
    const VoxelRun *begin, *end;
  };

  /// By ascending owner, and key of the brick; valid until the next call.
  const std::vector<Group>& byOwnerAndBrick(const std::vector<VoxelRun>& runs);

 private:
  /// What runs of one group share.
  struct Name {
    std::uint32_t owner;
    VoxelKey brick;

    bool operator==(const Name& o) const { return brick == o.brick && owner == o.owner; }
    bool operator<(const Name& o) const {
      return owner != o.owner ? owner < o.owner : brick < o.brick;
    }
  };
  static std::size_t hash(const Name& name) {
    const std::uint64_t mixed = name.brick + (std::uint64_t{name.owner} << 32);
    return static_cast<std::size_t>(mixed * 0x9e3779b97f4a7c15u >> 40);
  }

  /// Numbers the groups in order of their coming: fills groupOfRun_ and names_.
  void numberGroups(const std::vector<VoxelRun>& runs);
  std::uint32_t numberOf(const Name& name);
  void growTable();
  /// Fills rank_: the place of each group by ascending name.
  void rankGroups();

  std::vector<Name> names_;
  std::vector<std::uint32_t> groupOfRun_, order_, rank_, place_;
  /// The runs once more: written in any order, they are read one after another. Never shrinks.
  std::vector<VoxelRun> runsByGroup_;
  std::vector<Group> groups_;
  /// Open addressing: number of a group + 1, 0 = free. The size is a power of two.
  std::vector<std::uint32_t> table_;
};

}  // namespace toss
