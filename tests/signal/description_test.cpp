#include "signal/description.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/description_text.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;

const std::string bearing_table =
    "[bearing]\nballs = 8\nball_diameter_mm = 7\npitch_diameter_mm = 33.5\n"
    "inner_raceway_mm = 26.5\nouter_raceway_mm = 40.5\ncontact_angle_deg = 15\n";

/// Line 2 is the rate; the text after the bearing starts at line 14.
const std::string head =
    "name = \"rig\"\nsample_rate_hz = 8000\nshaft_speed_rpm = 900\n\n" + bearing_table + "\n\n";

const std::string good = head + R"([[class]]
name = "ok"
defect = "none"
[[class]]
name = "cracked"
defect = "outer"
defect_size_mm = 0.5

[[record]]
class = "cracked"
file = "rig/b.csv"
variable = "2"
sample_rate_hz = 16000
[[record]]
class = "ok"
file = "rig/a.mat"
variable = "x"
sample_rate_hz = 8000
shaft_speed_rpm = 905.5
url = "https://example.org/a.mat"
[[record]]
class = "cracked"
file = "rig/c.csv"
variable = "2"
sample_rate_hz = 8000
)";

TEST(Description, IsReadAsItStands) {
  const Folder folder;
  const Description d = read_description(folder.write("rig.toml", good));
  EXPECT_EQ(d.info.name, "rig");
  EXPECT_EQ(d.info.sample_rate_hz, 8000);
  EXPECT_EQ(d.info.shaft_speed_rpm, 900);
  EXPECT_EQ(d.info.unit_m_per_s2, 1);
  EXPECT_EQ(d.info.bearing.balls, 8);
  EXPECT_EQ(d.info.bearing.contact_angle_deg, 15);
  ASSERT_EQ(d.info.classes.size(), 2U);
  EXPECT_EQ(d.info.classes[1].name, "cracked");
  EXPECT_EQ(d.info.classes[1].defect, Defect::outer);
  EXPECT_EQ(d.info.classes[1].defect_size_mm, 0.5);
  EXPECT_EQ(d.info.healthy_label(), 0);
}

/// Returns `good` with another defect and size, with or without its bearing.
std::string described_fault(const std::string& defect, const std::string& size, bool bearing) {
  std::string text = good;
  text.replace(text.find("\"outer\"\ndefect_size_mm = 0.5\n"), 30, '"' + defect + "\"\n" + size);
  if (!bearing) text.replace(text.find(bearing_table), bearing_table.size(), "");
  return text;
}

TEST(Description, NeedsNeitherSizeNorBearingForOtherFaults) {
  const Folder folder;
  const Description d =
      read_description(folder.write("rig.toml", described_fault("other", "", false)));
  EXPECT_EQ(d.info.classes[1].defect, Defect::other);
  EXPECT_EQ(d.info.classes[1].defect_size_mm, 0);
  EXPECT_FALSE(d.info.has_bearing);
  EXPECT_EQ(d.info.fault_labels(), std::vector<Label>{1});
  EXPECT_TRUE(read_description(folder.write("b.toml", described_fault("other", "", true)))
                  .info.has_bearing);
  EXPECT_ERROR(read_description(folder.write("c.toml", described_fault("outer", "", false))),
               Exit::bad_input,
               "bearing is missing: it determines the impact rate of class cracked");
  EXPECT_ERROR(read_description(folder.write(
                   "d.toml", described_fault("other", "defect_size_mm = 0.5\n", true))),
               Exit::bad_input, "class.defect_size_mm is not possible if the defect is 'other'");
}

TEST(Description, MayHaveUnknownDefectSizes) {
  const Folder folder;
  const Description d =
      read_description(folder.write("rig.toml", described_fault("outer", "", true)));
  EXPECT_EQ(d.info.classes[1].defect, Defect::outer);
  EXPECT_EQ(d.info.classes[1].defect_size_mm, 0);
  std::string some = described_fault("outer", "", true);
  some.insert(some.find("file = \"rig/b.csv\""), "defect_size_mm = 0.5\n");
  EXPECT_ERROR(read_description(folder.write("b.toml", some)), Exit::bad_input,
               "class.defect_size_mm is missing: only some of its records have one");
  EXPECT_ERROR(read_description(
                   folder.write("c.toml", described_fault("outer", "defect_size_mm = 0\n", true))),
               Exit::bad_input, "class.defect_size_mm is refused");
}

TEST(Description, NamesRecordsAfterTheirClassAndSortsThem) {
  const Folder folder;
  const Description d = read_description(folder.write("rig.toml", good));
  std::vector<std::string> names;
  for (const RecordSource& r : d.records) names.push_back(r.name + "=" + r.file_text());
  EXPECT_THAT(names, ElementsAre("cracked-01=rig/b.csv", "cracked-02=rig/c.csv", "ok=rig/a.mat"));
  EXPECT_EQ(d.records[0].label, 1);
  EXPECT_EQ(d.records[0].sample_rate_hz, 16000);
  EXPECT_EQ(d.records[0].shaft_speed_rpm, 900);
  EXPECT_EQ(d.records[2].shaft_speed_rpm, 905.5);
  EXPECT_EQ(d.records[2].url, "https://example.org/a.mat");
  EXPECT_EQ(d.records[2].sha256, "");
}

TEST(Description, KeepsTheUnit) {
  const Folder folder;
  const std::string text = replaced(good, "[bearing]", "unit_m_per_s2 = 9.80665\n[bearing]");
  EXPECT_EQ(read_description(folder.write("rig.toml", text)).info.unit_m_per_s2, 9.80665);
}

TEST(Description, AllowsAUnitForEachRecord) {
  const Folder folder;
  const std::string text = replaced(good, "file = \"rig/a.mat\"",
                                    "file = \"rig/a.mat\"\nunit_m_per_s2 = 0.01\noffset = 2048");
  const Description d = read_description(folder.write("rig.toml", text));
  EXPECT_EQ(d.records[2].unit_m_per_s2, 0.01);
  EXPECT_EQ(d.records[2].offset, 2048);
  EXPECT_EQ(d.records[0].unit_m_per_s2, std::nullopt);
  EXPECT_EQ(d.records[0].offset, 0);
}

TEST(Description, AllowsSnapshotsInARecordOfManyFiles) {
  const Folder folder;
  const auto read = [&](const std::string& file, const std::string& interval_s) {
    const std::string lines = "file = " + file + "\nsnapshot_interval_s = " + interval_s;
    const std::string text = replaced(good, "file = \"rig/b.csv\"", lines);
    return read_description(folder.write("rig.toml", text));
  };
  const Description d = read("\"rig/b_*.csv\"", "10");
  EXPECT_EQ(d.records[0].snapshot_interval_s, 10);
  EXPECT_EQ(d.records[2].snapshot_interval_s, std::nullopt);
  EXPECT_EQ(read("[\"rig/b.csv\", \"rig/c.csv\"]", "0.5").records[0].snapshot_interval_s, 0.5);
  EXPECT_ERROR(read("\"rig/b.csv\"", "10"), Exit::bad_input, "this record has only one");
  EXPECT_ERROR(read("\"rig/b_*.csv\"", "0"), Exit::bad_input, "snapshot_interval_s");
  EXPECT_ERROR(read("\"rig/b_*.csv\"", "nan"), Exit::bad_input, "snapshot_interval_s");
}

TEST(Description, AllowsARecordedSpeed) {
  const Folder folder;
  const auto read = [&](const std::string& speed) {
    const std::string text =
        replaced(good, "shaft_speed_rpm = 905.5", "shaft_speed_rpm = " + speed);
    return read_description(folder.write("rig.toml", text)).records[2];
  };
  EXPECT_EQ(read("905.5").speed, std::nullopt);
  const RecordSource channel = read("\"n\"");
  ASSERT_TRUE(channel.speed);
  EXPECT_EQ(channel.speed->variable, "n");
  EXPECT_EQ(channel.speed->file, "");
  EXPECT_EQ(channel.tacho_file(), std::nullopt);
  EXPECT_EQ(channel.shaft_speed_rpm, 900);  // the data set's, until the channel is read
  const RecordSource tacho = read(R"({ file = "t.csv", variable = "1", pulses_per_turn = 60 })");
  EXPECT_EQ(tacho.tacho_file(), "t.csv");
  EXPECT_EQ(tacho.speed->pulses_per_turn, 60);
  EXPECT_EQ(read(R"({ file = "t.csv", variable = "1" })").speed->pulses_per_turn, 1);
  const auto expect_refused = [&](const std::string& speed, const std::string& text) {
    EXPECT_ERROR(read(speed), Exit::bad_input, text);
  };
  expect_refused("\"\"", "record.shaft_speed_rpm is empty");
  expect_refused("[900]", "record.shaft_speed_rpm must be a finite number");
  expect_refused("{ file = \"t.csv\" }", "shaft_speed_rpm.variable is missing");
  expect_refused("{ variable = \"1\" }", "shaft_speed_rpm.file is missing");
  expect_refused(R"({ file = "../t.csv", variable = "1" })",
                 "shaft_speed_rpm.file must be a path below the data folder");
  expect_refused(R"({ file = "t.csv", variable = "1", pulses_per_turn = 0 })",
                 "shaft_speed_rpm.pulses_per_turn must be from 0.01");
  expect_refused(R"({ file = "t.csv", variable = "1", pulses = 60 })", "shaft_speed_rpm.pulses is");
}

TEST(Description, ListsFilesOfPulses) {
  const Folder folder;
  const auto file = folder.write(
      "rig.toml", replaced(good, "shaft_speed_rpm = 905.5",
                           R"(shaft_speed_rpm = { file = "rig/t.csv", variable = "1" })"));
  EXPECT_THAT(recordings_of(read_description(file), folder.path()),
              ElementsAre("rig/b.csv", "rig/c.csv", "rig/a.mat", "rig/t.csv"));
  EXPECT_NE(list_of_sources(file, folder.path()).find("-  rig/t.csv  -\n"), std::string::npos);
}

TEST(Description, AllowsManyFilesInARecord) {
  const Folder folder;
  const std::string text =
      replaced(good, "file = \"rig/b.csv\"", "file = [\"rig/b.csv\", \"rig/b_*.csv\"]");
  const Description d = read_description(folder.write("rig.toml", text));
  EXPECT_THAT(d.records[0].files, ElementsAre("rig/b.csv", "rig/b_*.csv"));
  EXPECT_EQ(d.records[0].file_text(), "rig/b.csv, rig/b_*.csv");
  EXPECT_THAT(d.records[2].files, ElementsAre("rig/a.mat"));
}

/// Describes the bearing by orders, such as those on CWRU's page for the drive end.
std::string described_by_orders(const std::string& orders) {
  std::string text = replaced(good, "defect_size_mm = 0.5\n", "");
  return text.replace(text.find(bearing_table), bearing_table.size(), "[bearing]\n" + orders);
}

/// Uses CWRU's lines at 1797 rpm, 29.95 Hz.
TEST(Description, RefusesFrequenciesInHzAsOrders) {
  const Folder folder;
  const auto at = [](const std::string& rpm, const std::string& orders) {
    return replaced(described_by_orders(orders), "shaft_speed_rpm = 900",
                    "shaft_speed_rpm = " + rpm);
  };
  const std::string why =
      "bearing.bpfo = 107.3 and bpfi = 162.2 seem to be in Hz, not in multiples of the shaft "
      "frequency, 29.95 Hz; write 3.583 and 5.416, or add ftf if they are multiples";
  for (const char* more : {"", "bsf = 70.6\nftf = 11.93\n"}) {
    const std::string text = at("1797", std::string("bpfo = 107.3\nbpfi = 162.2\n") + more);
    EXPECT_ERROR(read_description(folder.write("rig.toml", text)), Exit::bad_input, why);
  }
  // A slewing bearing has this many balls.
  const std::string many = "bpfo = 49\nbpfi = 51\n";
  EXPECT_ERROR(read_description(folder.write("rig.toml", at("600", many))), Exit::bad_input,
               "seem to be in Hz");
  const auto file = folder.write("rig.toml", at("600", many + "ftf = 0.49\n"));
  EXPECT_EQ(read_description(file).info.bearing.balls, 100);
}

TEST(Description, AcceptsOrdersAloneIfNoSizeIsKnown) {
  const Folder folder;
  const std::string orders = "bpfo = 3.5848\nbpfi = 5.4152\nbsf = 2.357\n";
  const Description d = read_description(folder.write("rig.toml", described_by_orders(orders)));
  EXPECT_TRUE(d.info.has_bearing);
  EXPECT_EQ(d.info.bearing.balls, 9);
  EXPECT_NEAR(d.info.bearing.ball_diameter_mm / d.info.bearing.pitch_diameter_mm, 0.2034, 1e-3);
  EXPECT_EQ(d.info.classes[1].defect_size_mm, 0);
  const auto refused = [&](const std::string& text, const std::string& why) {
    EXPECT_ERROR(read_description(folder.write("b.toml", text)), Exit::bad_input, why);
  };
  refused(described_by_orders("bpfo = 3.5\nbpfi = 5.9\n"),
          "bearing.bpfo and the other orders are refused: bpfo + bpfi is 9.4");
  refused(described_by_orders("bpfo = 3.5\n"), "bearing.bpfi is missing");
  for (const std::string dimension :
       {"balls = 9", "ball_diameter_mm = 7.94", "pitch_diameter_mm = 39", "contact_angle_deg = 0",
        "inner_raceway_mm = 31", "outer_raceway_mm = 47"}) {
    const std::string key = dimension.substr(0, dimension.find(' '));
    refused(
        described_by_orders(orders + dimension + '\n'),
        "bearing." + key + " is given, but so is an order; give dimensions or orders, not both");
  }
  refused(replaced(described_by_orders(orders), "defect = \"outer\"",
                   "defect = \"outer\"\ndefect_size_mm = 0.5"),
          "class.defect_size_mm needs a bearing with dimensions");
  refused(replaced(described_by_orders(orders), "file = \"rig/b.csv\"",
                   "file = \"rig/b.csv\"\ndefect_size_mm = 0.5"),
          "record.defect_size_mm needs a bearing with dimensions");
}

TEST(Description, DerivesMissingRaceways) {
  const Folder folder;
  const std::string without_inner = replaced(good, "inner_raceway_mm = 26.5\n", "");
  const bearing::Geometry b =
      read_description(
          folder.write("rig.toml", replaced(without_inner, "outer_raceway_mm = 40.5\n", "")))
          .info.bearing;
  EXPECT_DOUBLE_EQ(b.inner_raceway_mm, 33.5 - 7);
  EXPECT_DOUBLE_EQ(b.outer_raceway_mm, 33.5 + 7);
  const std::string another = replaced(without_inner, "= 40.5", "= 40.4");
  EXPECT_EQ(read_description(folder.write("rig.toml", another)).info.bearing.outer_raceway_mm,
            40.4);
}

TEST(Description, TakesTheCommonRateOfTheRecordsByDefault) {
  const Folder folder;
  std::string text = replaced(good, "sample_rate_hz = 8000\n", "");
  text = replaced(text, "16000", "8000");
  EXPECT_EQ(read_description(folder.write("rig.toml", text)).info.sample_rate_hz, 8000);
}

TEST(Description, NamesTheMissingFile) {
  EXPECT_ERROR(read_description("/nowhere/rig.toml"), Exit::input_missing, "/nowhere/rig.toml");
}

struct Damage {
  const char* from;
  const char* to;
  const char* message;
};

class DamagedDescription : public testing::TestWithParam<Damage> {};

TEST_P(DamagedDescription, GivesOneLineWithFileLineAndKey) {
  const Folder folder;
  const Damage& damage = GetParam();
  const auto file = folder.write("rig.toml", replaced(good, damage.from, damage.to));
  EXPECT_ERROR(read_description(file), Exit::bad_input, file.string());
  EXPECT_ERROR(read_description(file), Exit::bad_input, damage.message);
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedDescription,
    testing::Values(
        Damage{"= \"rig\"", "= \"rig", "line 1: not valid TOML"},
        Damage{"= \"rig\"", "= 3", "line 1: name must be a text"},
        Damage{"= \"rig\"", "= \"\"", "line 1: name is empty"},
        Damage{"= \"rig\"", "= \"a/b\"", "line 1: name 'a/b' may hold"},
        Damage{"= 8000", "= \"8 kHz\"", "line 2: sample_rate_hz must be a finite number"},
        Damage{"= 8000", "= nan", "line 2: sample_rate_hz must be a finite number"},
        Damage{"= 8000", "= 0", "line 2: sample_rate_hz must be from 1 to 1e+07 Hz"},
        Damage{"= 8000", "= 1e300", "line 2: sample_rate_hz must be from 1 to 1e+07 Hz"},
        Damage{"= \"rig\"", "= \"a\\nb\"", "line 1: name holds a control character"},
        Damage{"sample_rate_hz", "rate", "line 2: rate is unknown; write sample_rate_hz"},
        Damage{"sample_rate_hz = 8000\n", "", "rig/b.csv and rig/a.mat have different rates"},
        Damage{"shaft_speed_rpm = 900", "", "shaft_speed_rpm is missing"},
        Damage{"balls = 8", "balls = 8.5", "line 6: bearing.balls must be a whole number"},
        Damage{"balls = 8", "balls = 0", "line 6: bearing.balls must be from 3 to 1000"},
        Damage{"balls = 8", "Designation = \"SKF 6205\"",
               "line 6: bearing.Designation is unknown; write designation"},
        Damage{"balls = 8", "type = \"SKF 6205\"", "bearing.type is unknown; write designation"},
        Damage{"balls = 8", "balls = 8\nbsf = 2.3", "bearing.balls is given, but so is an order"},
        Damage{"balls = 8", "BPFO = 3.5", "line 6: bearing.BPFO is unknown; write bpfo"},
        Damage{"balls = 8", "bpfo_order = 3.5", "bearing.bpfo_order is unknown; write bpfo"},
        Damage{"balls = 8", "colour = 3",
               "bearing.colour is unknown; known keys are ball_diameter_mm, balls, bpfi, bpfo"},
        Damage{"[[record]]\nclass = \"ok\"", "[[records]]\nclass = \"ok\"",
               "class ok has no [[record]]; instead of records, write record"},
        Damage{"= \"outer\"", "= \"Outer\"", "roller, other; write 'outer'"},
        Damage{"variable = \"x\"", "variable = \"x\"\nunit_g = 1",
               "record.unit_g is unknown; write unit_m_per_s2, 9.80665 times the value"},
        Damage{"pitch_diameter_mm = 33.5", "", "line 5: bearing.pitch_diameter_mm is missing"},
        Damage{"pitch_diameter_mm = 33.5", "pitch_diameter_mm = 3.5", "bearing is refused: "},
        Damage{"defect_size_mm = 0.5", "defect_size_mm = 50",
               "class.defect_size_mm is refused: defect size 50"},
        Damage{"= 15", "= 90", "bearing.contact_angle_deg must be from 0 to 89.999 degrees"},
        Damage{"= \"none\"", "= \"gear\"",
               "class.defect holds an unknown defect 'gear'; known defects: none, outer, inner, "
               "roller, other"},
        Damage{"= \"outer\"", "= \"ball\"",
               "'ball'; known defects: none, outer, inner, roller, other; write 'roller'"},
        Damage{"shaft_speed_rpm = 900", "shaft_speed_hz = 15",
               "shaft_speed_rpm is missing; instead of shaft_speed_hz, write shaft_speed_rpm, 60 "
               "times the value"},
        Damage{"variable = \"x\"", "column = 2",
               "record.variable is missing; instead of column, write variable"},
        Damage{"variable = \"x\"", "variable = \"x\"\ncomment = \"new\"",
               "record.comment is unknown; known keys are class, defect_size_mm"},
        Damage{"file = \"rig/a.mat\"", "file = [\"rig/a.mat\", \"../b.mat\"]",
               "record.file must be a path below"},
        Damage{"file = \"rig/a.mat\"", "file = []", "record.file must be a list of one or more"},
        Damage{"file = \"rig/a.mat\"", "file = \"rig/*.mat\"",
               "record.url is the address of one file, but this record has several"},
        Damage{"= \"none\"", "= \"none\"\ndefect_size_mm = 1",
               "class.defect_size_mm is not possible"},
        Damage{"= \"none\"", "= \"inner\"\ndefect_size_mm = 1", "no class has defect 'none'"},
        Damage{"name = \"cracked\"", "name = \"ok\"", "class.name 'ok' is given twice"},
        Damage{"class = \"ok\"", "class = \"okay\"", "record.class 'okay' is not a [[class]]"},
        Damage{"class = \"ok\"", "class = \"cracked\"", "class ok has no [[record]]"},
        Damage{"\"rig/a.mat\"", "\"../a.mat\"", "record.file must be a path below"},
        Damage{"\"rig/a.mat\"", "\"/a.mat\"", "record.file must be a path below"},
        Damage{"variable = \"x\"", "channel = \"x\"", "record.variable is missing"},
        Damage{"url", "sha256", "record.sha256 must be 64 hexadecimal digits"},
        Damage{"url", "link", "record.link is unknown"},
        Damage{"https://example.org/a.mat", "file:///etc/passwd",
               "record.url must begin with http"},
        Damage{"https://example.org/a.mat", "-o/tmp/x", "record.url must begin with http"},
        Damage{"https://example.org/a.mat", "https://a.org/ -o x", "record.url must begin with"},
        Damage{"example.org/a.mat", "a.org/a\\n0  ../x  https://b.org",
               "record.url holds a control character"},
        Damage{"\"rig/a.mat\"", "\"-rf.mat\"", "line 29: record.file must not begin with '-'"},
        Damage{"\"rig/a.mat\"", "\"a\\nb.mat\"", "record.file holds a control character"},
        Damage{"\"rig/a.mat\"", "\"a\\u009b2J.mat\"", "record.file holds a control character"},
        Damage{"\"rig/a.mat\"", "\"a\\u202etam.mat\"", "record.file holds a control character"},
        Damage{"\"rig/a.mat\"", "\"rig/\"", "record.file must end with the name of a file"},
        Damage{"\"rig/a.mat\"", "\".\"", "record.file must end with the name of a file"},
        Damage{"shaft_speed_rpm = 900", "shaft_speed_rpm = 1e-300",
               "line 3: shaft_speed_rpm must be from 0.01 to 1e+06 rpm"},
        Damage{"name = \"ok\"", "name = \"ok\"\n\"a\\nb\" = 1", "class.a?b is unknown"},
        Damage{"name = \"ok\"", "name = \"ok\"\ncolour = 1", "class.colour is unknown"}));

TEST(Description, RefusesClassesThatWouldShareARecordName) {
  const Folder folder;
  const std::string more =
      "[[class]]\nname = \"cracked-01\"\ndefect = \"inner\"\ndefect_size_mm = 1\n"
      "[[record]]\nclass = \"cracked-01\"\nfile = \"d.csv\"\nvariable = \"1\"\n"
      "sample_rate_hz = 8000\n";
  EXPECT_ERROR(read_description(folder.write("rig.toml", good + more)), Exit::bad_input,
               "two records would have the name cracked-01");
}

}  // namespace
}  // namespace piae::signal
