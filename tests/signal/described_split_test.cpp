#include "signal/described_split.hpp"

#include <gtest/gtest.h>

#include "signal/conditions_text.hpp"
#include "signal/description.hpp"
#include "signal/simulation.hpp"
#include "support/description_text.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

const std::string nothing_known = "[split]\nknown-per-class = 0\n";
const std::string healthy_record =
    "[[record]]\nclass = \"ok\"\ncondition = \"900 rpm\"\nfile = \"a.csv\"\nvariable = \"1\"\n"
    "sample_rate_hz = 8000\n[[record]]\nclass = \"ok\"\ncondition = \"1200 rpm\"\n"
    "shaft_speed_rpm = 1200\nfile = \"b.csv\"\nvariable = \"1\"\nsample_rate_hz = 8000\n";
const std::string geometry =
    "[bearing]\nballs = 8\nball_diameter_mm = 7\npitch_diameter_mm = 33.5\n"
    "contact_angle_deg = 0\n";

std::string made_bearing(const std::string& split) {
  return described_bearing("made") + described_normal + described_ir007 +
         described_simulation("2", "0.5") + split;
}

TEST(DescribedSplit, MayBeGivenForSimulatedDataSets) {
  const Folder folder;
  EXPECT_NO_THROW((void)read_simulation(folder.write("a.toml", made_bearing(nothing_known))));
  EXPECT_ERROR(
      read_simulation(folder.write("b.toml", made_bearing("[split]\nknown-per-class = 1.5\n"))),
      Exit::bad_input, "split.known-per-class must be a whole number");
}

/// Data to diagnose a machine that has never failed.
TEST(DescribedSplit, NeedsHealthyRecordsGeometryAndSpeedWithoutKnownFaults) {
  struct Lack {
    std::string part;
    std::string line;
  };
  for (const Lack& lack :
       {Lack{healthy_record, "class ok has no [[record]]"}, Lack{geometry, "bearing is missing"},
        Lack{"shaft_speed_rpm = 900\n", "shaft_speed_rpm is missing"}}) {
    const Folder folder;
    const std::string text = replaced(two_speeds, lack.part, "") + nothing_known;
    EXPECT_ERROR(read_description(folder.write("rig.toml", text)), Exit::bad_input, lack.line);
  }
}

}  // namespace
}  // namespace piae::signal
