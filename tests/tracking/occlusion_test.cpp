// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/tracking/Occlusion.h>

#include <algorithm>
#include <string>

namespace toss {
namespace {

/// A range image written as text: per pixel '.' = empty, 'g' = ground at 10 m, '#' = occluder at
/// 5 m, digit = instance of that number at 10 m.
struct Picture {
  explicit Picture(const std::vector<std::string>& rows) {
    image.rows = static_cast<int>(rows.size());
    image.columns = static_cast<int>(rows.front().size());
    for (const std::string& row : rows) {
      for (const char pixel : row) add(pixel);
    }
    detections.resize(static_cast<std::size_t>(segmentation.instanceCount));
    for (std::size_t i = 0; i < detections.size(); ++i) {
      detections[i].instance = static_cast<std::int32_t>(i) + 1;
    }
    measureOcclusion(image, segmentation, detections);
  }

  void add(char pixel) {
    if (pixel == '.') return image.representative.push_back(RangeImage::kNone);
    image.representative.push_back(static_cast<std::int32_t>(image.range.size()));
    image.range.push_back(pixel == '#' ? 5.0f : 10.0f);
    const std::int32_t instance = pixel >= '1' && pixel <= '9' ? pixel - '0' : 0;
    segmentation.instance.push_back(instance);
    segmentation.instanceCount = std::max(segmentation.instanceCount, instance);
  }

  RangeImage image;
  Segmentation segmentation;
  std::vector<Detection> detections;
};

TEST(Occlusion, ViewThroughAnOpeningIsHiddenOnBothSides) {
  const Picture picture({"gg##11##gg", "gg##11##gg"});
  EXPECT_EQ(picture.detections[0].occludedLeft, 1.0f);
  EXPECT_EQ(picture.detections[0].occludedRight, 1.0f);
}

TEST(Occlusion, KnowsLeftFromRightAndCountsRows) {
  const Picture picture({"gg##11gggg", "ggg.11gggg"});
  EXPECT_EQ(picture.detections[0].occludedLeft, 0.5f);
  EXPECT_EQ(picture.detections[0].occludedRight, 0.0f);
}

TEST(Occlusion, OccluderIsNotHiddenByWhatItHides) {
  Picture picture({"gg11##22gg"});
  EXPECT_EQ(picture.detections[0].occludedRight, 1.0f);
  EXPECT_EQ(picture.detections[1].occludedLeft, 1.0f);
  const Picture level({"gg1122gggg"});
  EXPECT_EQ(level.detections[0].occludedRight, 0.0f);
  EXPECT_EQ(level.detections[1].occludedLeft, 0.0f);
}

TEST(Occlusion, SkipsSmallGapsAndTakesLargeOnesAsOpen) {
  const Picture small({"##..11..##gggg"}), large({"##.....11.....##"});
  EXPECT_EQ(small.detections[0].occludedLeft, 1.0f);
  EXPECT_EQ(small.detections[0].occludedRight, 1.0f);
  EXPECT_EQ(large.detections[0].occludedLeft, 0.0f);
  EXPECT_EQ(large.detections[0].occludedRight, 0.0f);
}

TEST(Occlusion, RowsCloseAtTheRear) {
  const Picture picture({"11gggggg##", "1#gggg##11"});
  EXPECT_EQ(picture.detections[0].occludedLeft, 1.0f);
  EXPECT_EQ(picture.detections[0].occludedRight, 0.5f);
  const Picture empty({"....", "...."});
  EXPECT_TRUE(empty.detections.empty());
}

}  // namespace
}  // namespace toss
