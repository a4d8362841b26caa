#include "signal/meant_key.hpp"

#include <gtest/gtest.h>

#include <cctype>

namespace piae::signal {
namespace {

const std::set<std::string> of_a_record{
    "class",  "condition",       "defect_size_mm", "file", "sample_rate_hz",
    "sha256", "shaft_speed_rpm", "unit_m_per_s2",  "url",  "variable"};
const std::set<std::string> of_a_bearing{
    "balls", "ball_diameter_mm", "pitch_diameter_mm", "contact_angle_deg", "designation", "bpfo"};

TEST(MeantKey, RecognisesAnotherUnit) {
  EXPECT_EQ(meant_key("shaft_speed_hz", of_a_record), "write shaft_speed_rpm, 60 times the value");
  EXPECT_EQ(meant_key("sample_rate_khz", of_a_record),
            "write sample_rate_hz, 1000 times the value");
  EXPECT_EQ(meant_key("defect_size_mil", of_a_record),
            "write defect_size_mm, 0.0254 times the value");
  EXPECT_EQ(meant_key("ball_diameter_in", of_a_bearing),
            "write ball_diameter_mm, 25.4 times the value");
  EXPECT_EQ(meant_key("contact_angle_rad", of_a_bearing),
            "write contact_angle_deg, 57.2958 times the value");
}

TEST(MeantKey, RecognisesStandardGravity) {
  EXPECT_EQ(meant_key("unit_g", of_a_record), "write unit_m_per_s2, 9.80665 times the value");
}

TEST(MeantKey, RecognisesAMissingUnit) {
  EXPECT_EQ(meant_key("sample_rate", of_a_record), "write sample_rate_hz");
  EXPECT_EQ(meant_key("contact_angle", of_a_bearing), "write contact_angle_deg");
}

TEST(MeantKey, RecognisesSynonyms) {
  EXPECT_EQ(meant_key("column", of_a_record), "write variable");
  EXPECT_EQ(meant_key("Channel", of_a_record), "write variable");
  EXPECT_EQ(meant_key("fs", of_a_record), "write sample_rate_hz");
  EXPECT_EQ(meant_key("rolling-elements", of_a_bearing), "write balls");
  EXPECT_EQ(meant_key("column", of_a_bearing), "");  // a bearing has no key `variable`
}

TEST(MeantKey, RecognisesOtherCaseAndHyphens) {
  EXPECT_EQ(meant_key("Designation", of_a_bearing), "write designation");
  EXPECT_EQ(meant_key("BPFO", of_a_bearing), "write bpfo");
  EXPECT_EQ(meant_key("URL", of_a_record), "write url");
  EXPECT_EQ(meant_key("windows_per_class", {"windows-per-class"}), "write windows-per-class");
}

TEST(MeantKey, RecognisesAWordThatAddsNothing) {
  EXPECT_EQ(meant_key("bpfo_order", of_a_bearing), "write bpfo");
  EXPECT_EQ(meant_key("class_name", of_a_record), "write class");
  EXPECT_EQ(meant_key("type", of_a_bearing), "write designation");
  EXPECT_EQ(meant_key("name", of_a_bearing), "write designation");
}

TEST(MeantKey, RecognisesOneOrTwoWrongLetters) {
  EXPECT_EQ(meant_key("varaible", of_a_record), "write variable");
  EXPECT_EQ(meant_key("shaft_speeds_rpm", of_a_record), "write shaft_speed_rpm");
  EXPECT_EQ(meant_key("ur", of_a_record), "");  // too short to guess
  EXPECT_EQ(meant_key("comment", of_a_record), "");
}

TEST(MeantDefect, RecognisesSynonyms) {
  EXPECT_EQ(meant_defect("ball"), "roller");
  EXPECT_EQ(meant_defect("Inner_Race"), "inner");
  EXPECT_EQ(meant_defect("OR"), "outer");
  EXPECT_EQ(meant_defect("normal"), "none");
  EXPECT_EQ(meant_defect("cage"), "other");
  for (const char* word : {"none", "outer", "inner", "roller", "other"}) {
    std::string capital = word;
    capital[0] = static_cast<char>(std::toupper(capital[0]));
    EXPECT_EQ(meant_defect(capital), word);
  }
  EXPECT_EQ(meant_defect("gear"), "");
}

}  // namespace
}  // namespace piae::signal
