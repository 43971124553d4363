// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/TileStore.h>
#include <toss/rawlog/AtomicFolder.h>

#include <filesystem>
#include <memory>

namespace toss {

/// Tiles of a map as temporary files, one each. The folder is made with the first tile, and it and
/// everything in it is gone with this object.
class TileFolder : public TileStore {
 public:
  /// `folder`: name beside which the temporary folder is made.
  explicit TileFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void store(std::uint64_t tile, const std::vector<std::uint8_t>& bytes) override;
  void load(std::uint64_t tile, std::vector<std::uint8_t>& bytes) override;

  /// Tiles stored and loaded so far, those of several times counted each time.
  std::uint64_t stored() const { return stored_; }
  std::uint64_t loaded() const { return loaded_; }

 private:
  std::filesystem::path fileOf(std::uint64_t tile) const;

  std::filesystem::path folder_;
  std::unique_ptr<AtomicFolder> temporary_;
  std::uint64_t stored_ = 0, loaded_ = 0;
};

}  // namespace toss
