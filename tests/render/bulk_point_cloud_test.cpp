// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <string>

#include "BulkPointCloud.h"

namespace toss::test {
namespace {

std::string written(const mrpt::opengl::CPointCloudColoured& cloud) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream).WriteObject(cloud);
  return {static_cast<const char*>(stream.getRawBufferData()),
          static_cast<std::size_t>(stream.getTotalBytesCount())};
}

PointBatch someBatch(int count) {
  PointBatch batch;
  for (int i = 0; i < count; ++i) {
    const auto value = static_cast<float>(i);
    batch.positions.emplace_back(value, -0.5f * value, 1e6f + value);
    batch.colors.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 1});
  }
  return batch;
}

TEST(BulkPointCloudTest, WritesWhatMrptWrites) {
  for (const int count : {0, 1, 2, 200}) {
    const PointBatch batch = someBatch(count);
    BulkPointCloud bulk;
    mrpt::opengl::CPointCloudColoured plain;
    for (mrpt::opengl::CPointCloudColoured* cloud :
         {static_cast<mrpt::opengl::CPointCloudColoured*>(&bulk), &plain}) {
      cloud->setName("a cloud");
      cloud->setPointSize(3.0f);
      cloud->setLocation(1, 2, 3);
    }
    bulk.assign(batch);
    for (std::size_t i = 0; i < batch.colors.size(); ++i) {
      const Color& color = batch.colors[i];
      plain.insertPoint({batch.positions[i].x(), batch.positions[i].y(), batch.positions[i].z(),
                         color.red, color.green, color.blue, 255});
    }
    EXPECT_TRUE(written(bulk) == written(plain)) << count;
    EXPECT_EQ(bulk.size(), batch.colors.size());
  }
}

}  // namespace
}  // namespace toss::test
