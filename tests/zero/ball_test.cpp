#include "zero/ball.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace piae::zero {
namespace {

using Train = std::vector<impacts::Impact>;

constexpr double every_10_ms = 0.01;  // period in s
constexpr double ball_cage_hz = 12;

Train train_of(std::size_t count) {
  Train train(count);
  for (std::size_t i = 0; i < count; ++i) train[i].time_s = 0.01 * static_cast<double>(i);
  return train;
}

TEST(Ball, HitsBothRacesInTurnOneMoreWeakly) {
  for (int i = 0; i < 50; ++i) {
    Train train = train_of(20);
    Stream random("races " + std::to_string(i));
    alternate_races({.other_race = 0.2}, random, train);
    const double weaker = std::min(train[0].strength, train[1].strength);
    EXPECT_GE(weaker, 0.2);
    EXPECT_EQ(std::max(train[0].strength, train[1].strength), 1);
    for (std::size_t k = 2; k < 20; ++k) EXPECT_EQ(train[k].strength, train[k - 2].strength);
  }
  Train alike = train_of(4);
  Stream random("alike");
  alternate_races({.other_race = 1}, random, alike);
  for (const auto& strike : alike) EXPECT_EQ(strike.strength, 1);
}

TEST(Ball, IsStrictlyPeriodicWithoutRandomTurns) {
  const Prior rigid{.other_race = 1, .new_phase = 0, .random_impacts = 0, .least_on_track = 1};
  Train train = train_of(300);
  Stream random("rigid");
  alternate_races(rigid, random, train);
  turn_between_passes(every_10_ms, ball_cage_hz, rigid, random, train);
  scatter_in_time(3, rigid, random, train);
  leave_track(every_10_ms, ball_cage_hz, 3, rigid, random, train);
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(train[i].time_s, 0.01 * static_cast<double>(i));
    EXPECT_EQ(train[i].strength, 1);
  }
}

TEST(Ball, ChangesItsPhaseOncePerCageTurn) {
  Train train = train_of(3000);
  Stream random("phase");
  turn_between_passes(every_10_ms, ball_cage_hz, {.new_phase = 1}, random, train);
  Stream same("phase");
  const double probability = same.uniform(0, 1);
  int changes = 0;
  double last = 0;
  for (std::size_t i = 0; i < train.size(); ++i) {
    const double offset = train[i].time_s - 0.01 * static_cast<double>(i);
    EXPECT_LE(std::abs(offset), 0.005 + 1e-12);
    changes += std::abs(offset - last) > 1e-9 ? 1 : 0;
    last = offset;
  }
  // 30 s hold 360 turns of the cage.
  EXPECT_NEAR(changes, 360 * probability, 4 * std::sqrt(360 * 0.25));
  EXPECT_GT(changes, 10);
}

TEST(Ball, HasADrawnShareOfImpactsAtRandomTimes) {
  for (int i = 0; i < 5; ++i) {
    Train train = train_of(2000);
    const std::string name = "moments " + std::to_string(i);
    Stream random(name);
    scatter_in_time(20, {.random_impacts = 0.5}, random, train);
    Stream same(name);
    const double share = same.uniform(0, 1) * 0.5;
    std::vector<double> moved;
    for (std::size_t k = 0; k < 2000; ++k) {
      const double time_s = train[k].time_s;
      if (time_s != 0.01 * static_cast<double>(k)) moved.push_back(time_s / 20);
    }
    const auto count = static_cast<double>(moved.size());
    EXPECT_NEAR(count, 2000 * share, 4 * std::sqrt(2000 * 0.25));
    double sum = 0;
    for (const double part : moved) sum += part;
    if (count > 50) {
      EXPECT_NEAR(sum / count, 0.5, 4 / std::sqrt(12 * count));
    }
  }
}

TEST(Ball, MeetsItsTrackForADrawnShareOfTheTime) {
  double difference = 0;
  for (int i = 0; i < 40; ++i) {
    Train train = train_of(20000);
    const std::string name = "track " + std::to_string(i);
    Stream random(name);
    leave_track(every_10_ms, ball_cage_hz, 200, {.least_on_track = 0.1}, random, train);
    Stream same(name);
    (void)same.uniform(0, 1);  // draws the memory first
    const double share = 0.1 + 0.9 * same.uniform(0, 1);
    int on_it = 0;
    for (const auto& strike : train) {
      ASSERT_TRUE(strike.strength == 1 || strike.strength == off_track);
      on_it += strike.strength == 1 ? 1 : 0;
    }
    difference += on_it / 20000.0 - share;
  }
  EXPECT_NEAR(difference / 40, 0, 0.02);
}

TEST(Ball, LeavesItsTrackForLongerThanAnImpact) {
  // The memory is at least half a turn of the cage, here 4 impacts, so most neighbours are equal.
  Train train = train_of(20000);
  Stream random("memory");
  leave_track(every_10_ms, ball_cage_hz, 200, {.least_on_track = 0.1}, random, train);
  int changes = 0;
  for (std::size_t i = 1; i < train.size(); ++i) {
    changes += train[i].strength != train[i - 1].strength ? 1 : 0;
  }
  // A process with the correlation r from impact to impact crosses its median with the probability
  // acos(r) / pi, and any other threshold less often. r is at least exp(-0.01 12 / 0.5) = 0.787.
  EXPECT_LT(changes, 20000 * std::acos(0.787) / 3.14159);
  EXPECT_GT(changes, 0);
}

}  // namespace
}  // namespace piae::zero
