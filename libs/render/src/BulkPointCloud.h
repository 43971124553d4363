// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/CPointCloudColoured.h>

#include <string>

#include "OffscreenRenderer.h"

namespace toss {

/// A coloured cloud of MRPT that takes and writes its points all at once: MRPT locks it for each of
/// them, and writes number by number. What is written is the same.
class BulkPointCloud : public mrpt::opengl::CPointCloudColoured {
 public:
  /// Replaces the points by those of the batch.
  void assign(const PointBatch& batch);

 protected:
  using CPointCloudColoured::serializeTo;
  void serializeTo(mrpt::serialization::CArchive& out) const override;

 private:
  /// What MRPT writes of this cloud with its first `count` points alone.
  std::string written(std::size_t count) const;
};

}  // namespace toss
