// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/FastAtan2.h>

namespace toss {
namespace {

TEST(FastAtan2, IsWithinItsBoundAllAround) {
  for (int i = -180000; i <= 180000; ++i) {
    const double angle = i * M_PI / 180000.0;
    for (const double radius : {1e-3, 1.0, 80.0}) {
      const auto y = static_cast<float>(radius * std::sin(angle));
      const auto x = static_cast<float>(radius * std::cos(angle));
      const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
      ASSERT_NEAR(exact, static_cast<double>(fastAtan2(y, x)), 1e-6) << "angle " << angle;
    }
  }
}

TEST(FastAtan2, KnowsTheAxes) {
  EXPECT_EQ(0.0f, fastAtan2(0.0f, 0.0f));
  EXPECT_EQ(0.0f, fastAtan2(0.0f, 2.0f));
  EXPECT_FLOAT_EQ(static_cast<float>(M_PI), fastAtan2(0.0f, -2.0f));
  EXPECT_FLOAT_EQ(static_cast<float>(M_PI_2), fastAtan2(2.0f, 0.0f));
  EXPECT_FLOAT_EQ(static_cast<float>(-M_PI_2), fastAtan2(-2.0f, 0.0f));
}

}  // namespace
}  // namespace toss
