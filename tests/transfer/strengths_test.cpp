#include "transfer/strengths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bearing/kinematics.hpp"
#include "bearing/load_zone.hpp"
#include "bearing/strikes.hpp"
#include "support/checkpoints.hpp"
#include "support/errors.hpp"

namespace piae::transfer {
namespace {

const bearing::Geometry skf_6205{.balls = 9,
                                 .ball_diameter_mm = 7.94,
                                 .pitch_diameter_mm = 39,
                                 .inner_raceway_mm = 31.06,
                                 .outer_raceway_mm = 46.94,
                                 .contact_angle_deg = 0};

Struck struck_at(bearing::Defect kind, double rpm) {
  return {.geometry = skf_6205,
          .kind = kind,
          .shaft_speed_rpm = rpm,
          .period_s = 1 / bearing::strike_frequency_hz(skf_6205, kind, rpm)};
}

std::vector<double> strengths_of(bearing::Defect kind, const StrengthOptions& options,
                                 std::size_t count) {
  Stream random("strengths");
  return load_zone_strengths(struck_at(kind, 1200), count, options, random);
}

TEST(Strengths, OfAnOuterRaceAreAlikeUnderALoadThatStays) {
  for (const double one : strengths_of(bearing::Defect::outer, {}, 30)) EXPECT_EQ(one, 1);
}

TEST(Strengths, OfAnInnerRacePassTheLoadZoneOnceATurn) {
  const StrengthOptions half{.least_extent = 0.5, .largest_extent = 0.5};
  const std::vector<double> all = strengths_of(bearing::Defect::inner, half, 5000);
  // BPFI is 5.415 times the shaft's speed; half a turn is loaded, so half of the strikes are heard.
  const auto heard = std::ranges::count_if(all, [](double one) { return one > 0; });
  EXPECT_NEAR(static_cast<double>(heard) / 5000, 0.5, 0.01);
  // The mean of cos^1.5 over half a turn, by a whole one: Beta(1.25, 0.5) / (2 pi) = 0.2782.
  double sum = 0;
  for (const double one : all) sum += one;
  EXPECT_NEAR(sum / 5000, 0.2782, 0.005);
  // From strike to strike the defect has turned by 360 / 5.415 degrees.
  const auto top = std::ranges::max_element(all);
  EXPECT_GT(*top, 0.99);
}

TEST(Strengths, OfABallPassItWithTheCageOneRaceLouderThanTheOther) {
  const StrengthOptions all_round{.least_extent = 500, .largest_extent = 500};
  const std::vector<double> all = strengths_of(bearing::Defect::roller, all_round, 40);
  for (std::size_t i = 2; i < all.size(); ++i) EXPECT_NEAR(all[i], all[i - 2], 0.01);
  EXPECT_NEAR(all[0], 1, 0.01);
  EXPECT_LT(all[1], 1);
  EXPECT_GE(all[1], 0);
}

TEST(Strengths, OfAnOuterRaceComeAndGoWithALoadThatTurns) {
  StrengthOptions turning;
  turning.rotating = 1;
  const std::vector<double> all = strengths_of(bearing::Defect::outer, turning, 3000);
  // 1 + m cos(shaft): the mean is 1, and a turn of the shaft is 3.585 strikes.
  double sum = 0;
  double with_shaft = 0;
  double against_shaft = 0;
  const double shaft_per_strike = 2 * std::acos(-1.0) / 3.585;
  for (std::size_t i = 0; i < all.size(); ++i) {
    sum += all[i];
    with_shaft += all[i] * std::cos(shaft_per_strike * static_cast<double>(i));
    against_shaft += all[i] * std::sin(shaft_per_strike * static_cast<double>(i));
  }
  EXPECT_NEAR(sum / 3000, 1, 0.01);
  const double m = std::hypot(with_shaft, against_shaft) / 1500;
  const double seen = (*std::ranges::max_element(all) - *std::ranges::min_element(all)) / 2;
  EXPECT_GT(seen, 0.05);
  EXPECT_NEAR(m, seen, 0.2 * seen);
}

TEST(Strengths, ScatterByTheirLogarithm) {
  StrengthOptions scattered;
  scattered.scatter = 1;
  double most = 0;
  for (int w = 0; w < 200; ++w) {
    Stream random("window " + std::to_string(w));
    const std::vector<double> all =
        load_zone_strengths(struck_at(bearing::Defect::outer, 1200), 400, scattered, random);
    double squares = 0;
    for (const double one : all) squares += std::log(one) * std::log(one);
    most = std::max(most, std::sqrt(squares / 400));
  }
  EXPECT_NEAR(most, 1, 0.12);  // the largest of 200 that are uniform up to 1
}

TEST(Strengths, OfAKnownWindowFollowEachOtherAsThere) {
  Stream random("known");
  const std::vector<double> known{0.5, 1, 1.5};
  const std::vector<double> all = repeated_strengths(known, 20, random);
  ASSERT_EQ(all.size(), 20U);
  std::size_t at = 0;
  while (known[at] != all[0]) ++at;
  for (const double one : all) EXPECT_EQ(one, known[at++ % 3]);
}

TEST(Strengths, OfAShortWindowOutsideTheZoneAreNotSilent) {
  const StrengthOptions narrow{.least_extent = 0.05, .largest_extent = 0.05};
  for (int w = 0; w < 50; ++w) {
    Stream random("short " + std::to_string(w));
    const std::vector<double> all =
        load_zone_strengths(struck_at(bearing::Defect::inner, 1200), 1, narrow, random);
    EXPECT_GT(all[0], 0);
  }
}

TEST(StrengthOptions, OfAZoneThatEndsBeforeItBeginsAreRefused) {
  artefact::Writer writer("model");
  write(writer, StrengthOptions{.least_extent = 0.8, .largest_extent = 0.4});
  const std::filesystem::path path = scratch_file("zone.h5");
  writer.save(path, {});
  EXPECT_ERROR(read_strength_options(artefact::Reader(path, "model")), Exit::bad_input,
               "least extent is above the largest");
}

}  // namespace
}  // namespace piae::transfer
