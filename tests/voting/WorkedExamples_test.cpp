// SPDX-License-Identifier: BSD-3-Clause
// The worked examples E1 to E11 of spec section 7.3, with tau = 1 m and 10 scans per second. The
// table is reproduced where (a) the own trace is static evidence while its class is static and
// never while it is dynamic, (b) column R2 turns boxes without votes dynamic.
#include <gtest/gtest.h>

#include "VotingScene.h"

namespace toss {
namespace {

using test::VotingScene;

struct Example {
  VotingScene scene;
  std::size_t voted = 0;

  Example(const VotingScene& s, TrackId track, int frame) : scene(s), voted(s.find(track, frame)) {}
};

constexpr MotionClass kWeak = MotionClass::Weak;

Example orphanBoxOfFastCar() {
  VotingScene s;
  s.drive(1, 0, 9, 10, {0, 0, 10, 8});
  s.add(2, 10, {0, 0, 10, 0});
  s.drive(1, 11, 20, 10, {0, 0, 10, 8});
  s.classOf = {{1, kWeak}};
  return {s, 2, 10};
}

Example parkedCar() {
  VotingScene s;
  s.stand(1, 0, 79, {});
  return {s, 1, 40};
}

Example parkedCarSeenBriefly() {
  VotingScene s;
  s.stand(1, 0, 7, {});
  return {s, 1, 3};
}

Example bushWithOneDynamicPiece() {
  VotingScene s;
  s.stand(1, 0, 55, {});
  s.stand(2, 56, 64, {});
  s.stand(3, 65, 120, {});
  s.classOf = {{2, kWeak}};
  return {s, 2, 60};
}

Example bushOfDynamicPieces() {
  VotingScene s;
  for (int piece = 0; piece < 5; ++piece) {
    const auto track = static_cast<TrackId>(piece + 1);
    s.stand(track, 40 * piece, 40 * piece + 9, {0, 0, 10, 0.2});
    s.classOf[track] = kWeak;
  }
  return {s, 3, 85};
}

Example laneWithFourCars() {
  VotingScene s;
  for (int car = 0; car < 4; ++car) {
    const auto track = static_cast<TrackId>(car + 1);
    s.drive(track, 50 * car, 50 * car + 20, 50 * car + 10, {0, 0, 10, 8});
    s.classOf[track] = kWeak;
  }
  return {s, 2, 60};
}

Example singleStaticBox() {
  VotingScene s;
  s.add(1, 10, {});
  return {s, 1, 10};
}

Example waitingPedestrian() {
  VotingScene s;
  s.drive(1, 40, 59, 60, {0, 0, 1, 1.5});
  s.stand(1, 60, 120, {0, 0, 1, 0});
  s.drive(1, 121, 140, 120, {0, 0, 1, 1.5});
  s.classOf = {{1, kWeak}};
  return {s, 1, 90};
}

Example parkedCarBesideMover() {
  VotingScene s;
  s.stand(1, 0, 79, {});
  s.drive(2, 30, 50, 40, {0, 0.8, 10, 8});
  s.classOf = {{2, kWeak}};
  return {s, 1, 40};
}

Example walkerAtBigObject() {
  VotingScene s;
  s.stand(1, 0, 59, {0, 0, 60, 0});
  s.drive(2, 20, 59, 40, {0, 0, 0.8, 1.5});
  s.classOf = {{2, kWeak}};
  return {s, 2, 40};
}

Example falselyDynamicSign() {
  VotingScene s;
  s.stand(1, 0, 7, {0, 0, 1, 0.2});
  s.classOf = {{1, kWeak}};
  return {s, 1, 3};
}

Example queue() {
  VotingScene s;
  s.stand(1, 0, 60, {});
  s.drive(1, 61, 80, 60, {0, 0, 10, 12});
  s.stand(2, 100, 162, {});
  s.classOf = {{1, kWeak}, {2, kWeak}};
  return {s, 2, 131};
}

struct Expected {
  VotingMode mode;
  EmptyVote emptyVote;
  int dynamic, stationary;
  bool isDynamic;
};

VotingOptions optionsOf(const Expected& expected) {
  VotingOptions options;
  options.mode = expected.mode;
  options.emptyVote = expected.emptyVote;
  options.tauMin = options.tauMax = 1.0;
  options.horizon = 0.0;
  return options;
}

void check(const Example& example, const Expected& expected) {
  SCOPED_TRACE(static_cast<int>(expected.mode));
  const VotingOptions options = optionsOf(expected);
  DsVoting voting(options);
  for (const auto& [track, motion] : example.scene.classOf) voting.setTrackClass(track, motion);
  BoxId voted = 0;
  for (const auto& [number, scan] : example.scene.scans()) {
    const BoxId first = voting.addScan(scan.boxes);
    const auto place = std::find(scan.places.begin(), scan.places.end(), example.voted);
    if (place != scan.places.end()) {
      voted = first + static_cast<BoxId>(place - scan.places.begin());
    }
  }
  EXPECT_EQ(voting.votes(voted).dynamic, expected.dynamic);
  EXPECT_EQ(voting.votes(voted).stationary, expected.stationary);
  EXPECT_EQ(voting.isDynamic(voted), expected.isDynamic);
  const auto offline = voteOffline(example.scene.boxes, example.scene.classes(), options);
  EXPECT_EQ(offline[example.voted], expected.isDynamic);
}

/// Columns R1, R2, R3 and R5 of the table.
struct Row {
  struct Entry {
    int dynamic, stationary;
    char label;
  };
  Entry literal, dynamicOnly, classwise, guarded;
};

void check(const Example& example, const Row& row) {
  const auto entry = [&](VotingMode mode, EmptyVote empty, const Row::Entry& e) {
    check(example, Expected{mode, empty, e.dynamic, e.stationary, e.label == 'D'});
  };
  entry(VotingMode::Literal, EmptyVote::ByMode, row.literal);
  entry(VotingMode::DynamicOnly, EmptyVote::Dynamic, row.dynamicOnly);
  entry(VotingMode::Classwise, EmptyVote::ByMode, row.classwise);
  entry(VotingMode::Guarded, EmptyVote::ByMode, row.guarded);
}

TEST(WorkedExamples, E1OrphanBoxOfFastCar) {
  check(orphanBoxOfFastCar(), Row{{3, 0, 'D'}, {2, 0, 'D'}, {2, 0, 'D'}, {2, 0, 'D'}});
}

TEST(WorkedExamples, E2ParkedCar) {
  check(parkedCar(), Row{{11, 41, 'S'}, {0, 0, 'D'}, {0, 41, 'S'}, {0, 41, 'S'}});
}

TEST(WorkedExamples, E3ParkedCarSeenBriefly) {
  check(parkedCarSeenBriefly(), Row{{8, 0, 'D'}, {0, 0, 'D'}, {0, 0, 'D'}, {0, 0, 'S'}});
}

TEST(WorkedExamples, E4aBushWithOneDynamicPiece) {
  check(bushWithOneDynamicPiece(), Row{{11, 82, 'S'}, {9, 0, 'D'}, {9, 82, 'S'}, {9, 82, 'S'}});
}

TEST(WorkedExamples, E4bBushOfDynamicPieces) {
  check(bushOfDynamicPieces(), Row{{10, 40, 'S'}, {10, 40, 'S'}, {10, 0, 'D'}, {10, 40, 'S'}});
}

TEST(WorkedExamples, E5LaneWithFourCars) {
  check(laneWithFourCars(), Row{{3, 9, 'S'}, {3, 9, 'S'}, {3, 0, 'D'}, {3, 0, 'D'}});
}

TEST(WorkedExamples, E6SingleStaticBox) {
  check(singleStaticBox(), Row{{1, 0, 'D'}, {0, 0, 'D'}, {0, 0, 'D'}, {0, 0, 'S'}});
}

TEST(WorkedExamples, E7WaitingPedestrian) {
  check(waitingPedestrian(), Row{{11, 34, 'S'}, {11, 34, 'S'}, {11, 0, 'D'}, {11, 0, 'D'}});
}

TEST(WorkedExamples, E8ParkedCarBesideMover) {
  check(parkedCarBesideMover(), Row{{11, 41, 'S'}, {1, 0, 'D'}, {1, 41, 'S'}, {1, 41, 'S'}});
}

TEST(WorkedExamples, E9WalkerAtBigObject) {
  check(walkerAtBigObject(), Row{{11, 21, 'S'}, {11, 0, 'D'}, {11, 21, 'S'}, {11, 0, 'D'}});
}

TEST(WorkedExamples, E10FalselyDynamicSign) {
  check(falselyDynamicSign(), Row{{8, 0, 'D'}, {8, 0, 'D'}, {8, 0, 'D'}, {8, 0, 'D'}});
}

TEST(WorkedExamples, E11Queue) {
  check(queue(), Row{{11, 85, 'S'}, {11, 85, 'S'}, {11, 0, 'D'}, {11, 61, 'S'}});
}

TEST(WorkedExamples, StrongCarsAreNoStaticEvidence) {
  Example example = queue();
  example.scene.classOf[1] = MotionClass::Strong;
  check(example, Expected{VotingMode::Guarded, EmptyVote::ByMode, 11, 0, true});
}

TEST(WorkedExamples, StrongCarIsNotVotedBack) {
  Example example = queue();
  example.scene.classOf[2] = MotionClass::Strong;
  check(example, Expected{VotingMode::Guarded, EmptyVote::ByMode, 11, 61, true});
}

TEST(WorkedExamples, DynamicOnlyKeepsTheCoarseClassWithoutVotes) {
  for (const Example& example : {parkedCar(), parkedCarSeenBriefly(), singleStaticBox()}) {
    check(example, Expected{VotingMode::DynamicOnly, EmptyVote::ByMode, 0, 0, false});
  }
}

TEST(WorkedExamples, OffGivesTheCoarseClass) {
  check(queue(), Expected{VotingMode::Off, EmptyVote::ByMode, 0, 0, true});
  check(parkedCarBesideMover(), Expected{VotingMode::Off, EmptyVote::ByMode, 0, 0, false});
}

}  // namespace
}  // namespace toss
