#include "twin/contact.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "bearing/kinematics.hpp"
#include "twin/example_physics.hpp"

namespace piae::twin {
namespace {

using bearing::Defect;

/// Returns the 6205 of the paper's Table 1 at 1797 rpm.
signal::DatasetInfo paper_bearing() {
  signal::DatasetInfo info;
  info.sample_rate_hz = 12000;
  info.shaft_speed_rpm = 1797;
  info.bearing = {.balls = 9,
                  .ball_diameter_mm = 7.94,
                  .pitch_diameter_mm = 39,
                  .inner_raceway_mm = 31.06,
                  .outer_raceway_mm = 46.94};
  return info;
}

Contact contact_of(Defect defect, ContactInterpretation interpretation, double size_mm = 0.5334,
                   std::int64_t samples = 12000) {
  TwinOptions options;
  options.contact = interpretation;
  return make_contact(paper_bearing(), {"class", defect, defect == Defect::none ? 0 : size_mm},
                      samples, options);
}

TEST(Contact, StandingUsesClearanceAndDepthThroughout) {
  const Contact contact = contact_of(Defect::inner, ContactInterpretation::standing);
  EXPECT_NEAR(contact.inside_m, 2e-6 + 8.97e-6, 1e-8);  // eq. 10 at 21 mil
  EXPECT_EQ(contact.at_rest, 1);
  EXPECT_TRUE(contact.passing.empty());
}

TEST(Contact, DefectAloneIgnoresClearance) {
  EXPECT_NEAR(contact_of(Defect::outer, ContactInterpretation::defect_alone).inside_m, 8.97e-6,
              1e-8);
  EXPECT_EQ(contact_of(Defect::none, ContactInterpretation::defect_alone).inside_m, 0);
}

TEST(Contact, HealthyBearingIsAtItsClearance) {
  for (const auto interpretation :
       {ContactInterpretation::passing, ContactInterpretation::expected}) {
    const Contact healthy = contact_of(Defect::none, interpretation);
    EXPECT_EQ(healthy.outside_m, 2e-6);
    EXPECT_EQ(healthy.at_rest, 0);
    EXPECT_TRUE(healthy.passing.empty());
  }
}

/// Returns the number of times that the fraction of time in the defect rises from 0.
int passages(const Contact& contact) {
  int count = contact.passing.front() > 0 ? 1 : 0;
  for (std::size_t i = 1; i < contact.passing.size(); ++i) {
    if (contact.passing[i] > 0 && contact.passing[i - 1] == 0) ++count;
  }
  return count;
}

// The number in one second equals the fault frequency: 107.3, 162.2 and 141.0.
TEST(Contact, PassingOccursAtTheFaultFrequency) {
  const auto info = paper_bearing();
  const auto hz = bearing::fault_frequencies(info.bearing, info.shaft_speed_rpm);
  EXPECT_NEAR(passages(contact_of(Defect::outer, ContactInterpretation::passing)), hz.bpfo_hz, 1);
  EXPECT_NEAR(passages(contact_of(Defect::inner, ContactInterpretation::passing)), hz.bpfi_hz, 1);
  EXPECT_NEAR(passages(contact_of(Defect::roller, ContactInterpretation::passing)), 2 * hz.bsf_hz,
              1);
}

TEST(Contact, ExpectedIsThePassingShareOfTheTime) {
  for (const Defect defect : {Defect::outer, Defect::inner, Defect::roller}) {
    const std::vector<double> passing = contact_of(defect, ContactInterpretation::passing).passing;
    const double mean =
        std::accumulate(passing.begin(), passing.end(), 0.0) / static_cast<double>(passing.size());
    const double expected = contact_of(defect, ContactInterpretation::expected).at_rest;
    EXPECT_NEAR(mean, expected, 0.02 * expected);
  }
}

TEST(ContactForce, FollowsHertzInsideAndOutside) {
  EXPECT_DOUBLE_EQ(contact_force(4e-6, -1, 0, 1e9).force_n, 1e9 * 8e-9);
  EXPECT_DOUBLE_EQ(contact_force(4e-6, -1, 0.25, 1e9).force_n, 0.75 * 1e9 * 8e-9);
  EXPECT_DOUBLE_EQ(contact_force(4e-6, 1e-6, 1, 1e9).force_n, 1e9 * 1e-9);
  EXPECT_DOUBLE_EQ(contact_force(4e-6, -1, 0, 1e9).stiffness_n_per_m, 1.5 * 1e9 * 2e-3);
}

// W / (delta 1e8 N/m) = 1.0 / 1.097e-5 / 1e5: 0.91 at 21 mil, 5 at the clearance of 2 um.
TEST(ContactAtRest, IsOpenAboveTheStiffnessAtWhichTheSpringCarriesTheLoad) {
  Physics physics = example_physics();
  const Contact standing = contact_of(Defect::inner, ContactInterpretation::standing);
  EXPECT_FALSE(is_open_at_rest(0.90e8, standing, physics));
  EXPECT_TRUE(is_open_at_rest(0.92e8, standing, physics));
  const Contact expected = contact_of(Defect::inner, ContactInterpretation::expected);
  EXPECT_FALSE(is_open_at_rest(4.9e8, expected, physics));
  EXPECT_TRUE(is_open_at_rest(5.1e8, expected, physics));
}

}  // namespace
}  // namespace piae::twin
