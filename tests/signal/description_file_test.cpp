#include "signal/description_file.hpp"

#include <gtest/gtest.h>

#include "signal/conditions_text.hpp"
#include "signal/description.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

TEST(DescriptionFile, CompletesItselfFromItsModel) {
  const Folder folder;
  folder.write("rig.toml", two_speeds);
  const auto file = folder.write("rig-1200.toml",
                                 "name = \"rig-1200\"\nlike = \"rig\"\nsample_rate_hz = 4000\n"
                                 "[bearing]\nballs = 9\n" +
                                     from_900_to_1200);
  const Description d = read_description(file);
  EXPECT_EQ(d.info.name, "rig-1200");
  EXPECT_EQ(d.info.sample_rate_hz, 4000);
  EXPECT_EQ(d.info.shaft_speed_rpm, 900);
  EXPECT_EQ(d.info.bearing.balls, 9);
  EXPECT_EQ(d.info.bearing.pitch_diameter_mm, 33.5);
  EXPECT_EQ(d.records.size(), 4U);
  EXPECT_TRUE(is_transfer(d.info.conditions));
}

TEST(DescriptionFile, TakesListsWhole) {
  const Folder folder;
  folder.write("a.toml", "name = \"a\"\n[[class]]\nname = \"x\"\n[[class]]\nname = \"y\"\n");
  const auto file = folder.write("b.toml", "name = \"b\"\nlike = \"a\"\n[[class]]\nname = \"z\"\n");
  const toml::table b = read_description_file(file);
  ASSERT_EQ(b["class"].as_array()->size(), 1U);
  EXPECT_EQ(b["class"][0]["name"].value<std::string>(), "z");
  EXPECT_FALSE(b.contains("like"));
}

TEST(DescriptionFile, AllowsAModelWithAModel) {
  const Folder folder;
  folder.write("a.toml", "name = \"a\"\nfirst = 1\nsecond = 1\nthird = 1\n");
  folder.write("b.toml", "name = \"b\"\nlike = \"a\"\nsecond = 2\nthird = 2\n");
  const toml::table c =
      read_description_file(folder.write("c.toml", "name = \"c\"\nlike = \"b\"\nthird = 3\n"));
  EXPECT_EQ(c["name"].value<std::string>(), "c");
  EXPECT_EQ(c["first"].value<int>(), 1);
  EXPECT_EQ(c["second"].value<int>(), 2);
  EXPECT_EQ(c["third"].value<int>(), 3);
}

TEST(DescriptionFile, TakesABearingByItsDesignation) {
  const Folder folder;
  folder.write("bearings.csv",
               "designation,balls,ball_diameter_mm,pitch_diameter_mm,contact_angle_deg,bpfo,bpfi,"
               "bsf,ftf,source\nSKF 6205,9,7.94,39,0,,,,,the paper\n");
  const auto described = [&](const std::string& bearing) {
    return read_description_file(
        folder.write("datasets/a.toml", "name = \"a\"\n[bearing]\n" + bearing));
  };
  const toml::table own = described("designation = \"skf6205\"\ninner_raceway_mm = 31\n");
  EXPECT_EQ(own["bearing"]["balls"].value<int>(), 9);
  EXPECT_EQ(own["bearing"]["ball_diameter_mm"].value<double>(), 7.94);
  EXPECT_EQ(own["bearing"]["pitch_diameter_mm"].value<double>(), 39);
  EXPECT_FALSE(own["bearing"].as_table()->contains("designation"));
  for (const std::string key : {"balls", "ball_diameter_mm", "pitch_diameter_mm",
                                "contact_angle_deg", "bpfo", "bpfi", "bsf", "ftf"}) {
    EXPECT_ERROR(described("designation = \"6205\"\n" + key + " = 5\n"), Exit::bad_input,
                 "a.toml, line 4: bearing." + key +
                     " is given, but designation decides it; remove one of the two");
  }
  EXPECT_ERROR(described("designation = \"6311\"\n"), Exit::bad_input,
               "a.toml, line 3: bearing.designation '6311' has no row in " +
                   (folder / "bearings.csv").string());
  EXPECT_ERROR(described("designation = 6205\n"), Exit::bad_input,
               "line 3: bearing.designation must be a text in quotes");
}

TEST(DescriptionFile, ReplacesTheBearingOfItsModelByADesignation) {
  const Folder folder;
  folder.write("bearings.csv",
               "designation,balls,ball_diameter_mm,pitch_diameter_mm,contact_angle_deg,bpfo,bpfi,"
               "bsf,ftf,source\nSKF 6205,9,7.94,39,0,,,,,the paper\n");
  folder.write("datasets/rig.toml", two_speeds);
  const auto file = folder.write(
      "datasets/b.toml", "name = \"b\"\nlike = \"rig\"\n[bearing]\ndesignation = \"SKF 6205\"\n");
  const toml::table description = read_description_file(file);
  EXPECT_EQ(description["bearing"]["balls"].value<int>(), 9);
  EXPECT_EQ(description["bearing"]["pitch_diameter_mm"].value<double>(), 39);
}

TEST(DescriptionFile, ReplacesTheDesignationOfItsModel) {
  const Folder folder;
  folder.write("bearings.csv",
               "designation,balls,ball_diameter_mm,pitch_diameter_mm,contact_angle_deg,bpfo,bpfi,"
               "bsf,ftf,source\nSKF 6205,9,7.94,39,0,,,,,the paper\n");
  folder.write("datasets/rig.toml", two_speeds);
  folder.write("datasets/named.toml",
               "name = \"named\"\nlike = \"rig\"\n[bearing]\ndesignation = \"SKF 6205\"\n"
               "inner_raceway_mm = 31\n");
  const auto file_with = [&](const std::string& bearing, const std::string& model) {
    return folder.write("datasets/c.toml",
                        "name = \"c\"\nlike = \"" + model + "\"\n[bearing]\n" + bearing);
  };
  const auto bearing = [&](const std::string& text, const std::string& model) {
    return *read_description_file(file_with(text, model))["bearing"].as_table();
  };
  const std::string dimensions =
      "balls = 8\nball_diameter_mm = 6\npitch_diameter_mm = 30\ncontact_angle_deg = 5\n";
  const toml::table own = bearing(dimensions, "named");
  EXPECT_EQ(own.size(), 4U);
  EXPECT_EQ(own["balls"].value<int>(), 8);
  EXPECT_EQ(own["pitch_diameter_mm"].value<double>(), 30);
  // Orders replace a designation and dimensions.
  for (const std::string model : {"named", "rig"}) {
    const toml::table orders = bearing("bpfo = 3.5\nbpfi = 5.5\n", model);
    EXPECT_EQ(orders.size(), 2U) << model;
    EXPECT_EQ(orders["bpfi"].value<double>(), 5.5) << model;
  }
  // A raceway alone leaves the designation.
  const toml::table raceway = bearing("inner_raceway_mm = 30\n", "named");
  EXPECT_EQ(raceway["balls"].value<int>(), 9);
  EXPECT_EQ(raceway["inner_raceway_mm"].value<double>(), 30);
  // A dimension of the same kind still replaces only itself.
  EXPECT_EQ(bearing("balls = 8\n", "rig").size(), 4U);
  // Some dimensions are not enough without the designation.
  const auto few = file_with("balls = 8\n", "named");
  EXPECT_ERROR(read_description(few), Exit::bad_input, few.string());
  // Within one file they contradict each other.
  const auto both = file_with("designation = \"SKF 6205\"\n" + dimensions, "rig");
  EXPECT_ERROR(read_description_file(both), Exit::bad_input,
               both.string() + ", line 5: bearing.balls is given, but designation decides it");
  const auto mixed = file_with("bpfo = 3.5\nbpfi = 5.5\nballs = 8\n", "named");
  EXPECT_ERROR(read_description(mixed), Exit::bad_input,
               mixed.string() + ", line 6: bearing.balls is given, but so is an order");
}

TEST(DescriptionFile, NamesTheFileOfAnError) {
  const Folder folder;
  const auto model = folder.write("rig.toml", two_speeds + "colour = 1\n");
  const auto file = folder.write("b.toml", "name = \"b\"\nlike = \"rig\"\n");
  EXPECT_ERROR(read_description(file), Exit::bad_input,
               model.string() + ", line 44: record.colour");
  const auto other = folder.write("c.toml", "name = \"c\"\nlike = \"rig\"\n[bearing]\nballs = 0\n");
  EXPECT_ERROR(read_description(other), Exit::bad_input,
               other.string() + ", line 4: bearing.balls must be from 3");
}

TEST(DescriptionFile, RefusesInvalidModels) {
  const Folder folder;
  const auto refused = [&](const std::string& text, Exit exit, const std::string& message) {
    const auto file = folder.write("b.toml", text);
    EXPECT_ERROR(read_description_file(file), exit, file.string() + ", line 2: like " + message);
  };
  folder.write("a.toml", "name = \"a\"\nlike = \"b\"\n");
  EXPECT_ERROR(read_description_file(folder.write("b.toml", "name = \"b\"\nlike = \"a\"\n")),
               Exit::bad_input, "forms a cycle");
  refused("name = \"b\"\nlike = \"b\"\n", Exit::bad_input, "forms a cycle");
  refused("name = \"b\"\nlike = \"none\"\n", Exit::input_missing, "= 'none', but there is no ");
  refused("name = \"b\"\nlike = 3\n", Exit::bad_input, "must be the name of a description");
  refused("name = \"b\"\nlike = \"../a\"\n", Exit::bad_input, "must be the name of a description");
  refused("balls = 3\nlike = \"a\"\n", Exit::bad_input, "is there, but name is missing");
}

}  // namespace
}  // namespace piae::signal
