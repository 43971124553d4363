// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/tracking/KalmanFilter.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace toss {
namespace {

using State = Eigen::Matrix<double, 10, 1>;
using Covariance = Eigen::Matrix<double, 10, 10>;
using Measurement = Eigen::Matrix<double, 7, 1>;

/// The textbook filter on [x y z theta l w h vx vy vz]: the paper's, with full matrices.
class DenseFilter {
 public:
  DenseFilter(const Measurement& first, const KalmanNoise& noise) {
    state_ << first, Eigen::Vector3d::Zero();
    covariance_.setZero();
    covariance_.diagonal() << Eigen::Vector3d::Constant(noise.initialPosition), noise.initialYaw,
        Eigen::Vector3d::Constant(noise.initialSize),
        Eigen::Vector3d::Constant(noise.initialVelocity);
  }

  void predict(const KalmanNoise& noise) {
    Covariance transition = Covariance::Identity(), process = Covariance::Zero();
    process.diagonal() << Eigen::Vector3d::Constant(noise.position), noise.yaw,
        Eigen::Vector3d::Constant(noise.size), Eigen::Vector3d::Constant(noise.velocity);
    for (int axis = 0; axis < 3; ++axis) {
      transition(axis, 7 + axis) = noise.step;
      process(axis, 7 + axis) = process(7 + axis, axis) = noise.positionVelocity;
    }
    state_ = transition * state_;
    covariance_ = transition * covariance_ * transition.transpose() + process;
  }

  void update(const Measurement& measured, const KalmanNoise& noise) {
    Eigen::Matrix<double, 7, 10> observe = Eigen::Matrix<double, 7, 10>::Zero();
    observe.leftCols<7>().setIdentity();
    Measurement variances;
    variances << Eigen::Vector3d::Constant(noise.measuredPosition), noise.measuredYaw,
        Eigen::Vector3d::Constant(noise.measuredSize);
    const Eigen::Matrix<double, 7, 7> innovation =
        observe * covariance_ * observe.transpose() +
        Eigen::Matrix<double, 7, 7>(variances.asDiagonal());
    const Eigen::Matrix<double, 10, 7> gain =
        covariance_ * observe.transpose() * innovation.inverse();
    state_ += gain * (measured - observe * state_);
    covariance_ = (Covariance::Identity() - gain * observe) * covariance_;
  }

  const State& state() const { return state_; }
  const Covariance& covariance() const { return covariance_; }

 private:
  State state_;
  Covariance covariance_;
};

State stateOf(const KalmanFilter& filter) {
  const Box& box = filter.box();
  State state;
  state << box.center, box.yaw, box.length, box.width, box.height, filter.velocity();
  return state;
}

Measurement measurementOf(const Box& box) {
  Measurement measurement;
  measurement << box.center, box.yaw, box.length, box.width, box.height;
  return measurement;
}

class KalmanFilterAgainstDense : public testing::TestWithParam<KalmanNoiseModel> {};

TEST_P(KalmanFilterAgainstDense, AgreesOverRandomSequencesWithMissesAndUnevenSteps) {
  KalmanOptions options;
  options.noise = GetParam();
  std::mt19937 random(3);
  std::normal_distribution<double> jitter(0.0, 0.2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int sequence = 0; sequence < 20; ++sequence) {
    Box box;
    box.center = {1000.0 * unit(random), -500.0 * unit(random), 1.0};
    box.yaw = 0.5 * unit(random), box.length = 4.0, box.width = 2.0, box.height = 1.5;
    const KalmanNoise first = kalmanNoise(options, 0.1);
    KalmanFilter filter(box, first);
    DenseFilter dense(measurementOf(box), first);
    for (int scan = 0; scan < 60; ++scan) {
      const KalmanNoise noise = kalmanNoise(options, 0.05 + 0.3 * unit(random));
      filter.predict(noise);
      dense.predict(noise);
      if (unit(random) < 0.7) {
        box.center += Eigen::Vector3d(1.0 + jitter(random), jitter(random), jitter(random));
        box.yaw = 0.25 + jitter(random), box.length = 4.0 + jitter(random);
        filter.update(box, noise);
        dense.update(measurementOf(box), noise);
      }
      ASSERT_LT((stateOf(filter) - dense.state()).norm(), 1e-8) << sequence << ", scan " << scan;
      ASSERT_NEAR(filter.positionVariance(), dense.covariance()(1, 1), 1e-8);
      ASSERT_NEAR(filter.velocityVariance(), dense.covariance()(8, 8), 1e-8);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(NoiseModels, KalmanFilterAgainstDense,
                         testing::Values(KalmanNoiseModel::Metric, KalmanNoiseModel::Paper));

TEST(KalmanFilter, PaperNoiseHasTheGainsOfTheReference) {
  KalmanOptions options;
  options.noise = KalmanNoiseModel::Paper;
  const KalmanNoise noise = kalmanNoise(options, 0.1);
  Box box;
  KalmanFilter filter(box, noise);
  filter.predict(noise);
  box.center.x() = 1.0;
  filter.update(box, noise);
  EXPECT_NEAR(filter.velocity().x(), 0.999, 1e-3);  // spec section 5.1: the last displacement
  for (int scan = 0; scan < 500; ++scan) {
    filter.predict(noise);
    filter.update(filter.box(), noise);
  }
  filter.predict(noise);
  const double place = filter.box().center.x(), velocity = filter.velocity().x();
  box = filter.box();
  box.center.x() += 1.0;
  filter.update(box, noise);
  EXPECT_NEAR(filter.box().center.x() - place, 0.653, 1e-3);
  EXPECT_NEAR(filter.velocity().x() - velocity, 0.059, 1e-3);
}

TEST(KalmanFilter, LearnsTheSpeedOfAnObjectWhateverTheTimeBetweenScans) {
  for (const double seconds : {0.05, 0.1, 0.2}) {
    const KalmanNoise noise = kalmanNoise(KalmanOptions{}, seconds);
    Box box;
    KalmanFilter filter(box, noise);
    for (int scan = 1; scan <= 40; ++scan) {
      filter.predict(noise);
      box.center.x() = 12.0 * seconds * scan;
      filter.update(box, noise);
    }
    EXPECT_NEAR(filter.velocity().x(), 12.0, 0.05) << seconds;
  }
}

TEST(KalmanFilter, YawStaysBetweenTheTwoDescriptionsOfABox) {
  const KalmanNoise noise = kalmanNoise(KalmanOptions{}, 0.1);
  Box box;
  box.yaw = 1.5, box.length = 4.0, box.width = 2.0;
  KalmanFilter filter(box, noise);
  filter.predict(noise);
  box.yaw = 1.6 - M_PI;  // the same direction as 1.6
  filter.update(box, noise);
  EXPECT_NEAR(std::abs(std::remainder(filter.box().yaw - 1.55, M_PI)), 0.0, 0.06);
  filter.predict(noise);
  box.yaw = 1.55 - M_PI / 2, box.length = 2.0, box.width = 4.0;  // a quarter turn, sides exchanged
  filter.update(box, noise);
  EXPECT_NEAR(filter.box().length, 4.0, 1e-9);
  EXPECT_NEAR(filter.box().width, 2.0, 1e-9);
}

}  // namespace
}  // namespace toss
