#include "signal/bearing_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "bearing/orders.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

using testing::ElementsAre;
using testing::Pair;

const std::string table_head =
    "designation,balls,ball_diameter_mm,pitch_diameter_mm,contact_angle_deg,bpfo,bpfi,bsf,ftf,"
    "source\n";
const std::string some_rows = table_head +
                              "SKF 6205-2RS JEM,9,7.94,39.04,0,3.5848,5.4152,2.357,0.39828,a page\n"
                              "KG 6205,9,7.938,39,0,,,,,a paper\n"
                              "FAG NU2205,13,7.5,38.5,0,,,,,another\n"
                              "MB ER-16K,9,7.9375,38.5064,0,,,,,a readme\n"
                              "NTN 6201,,,,,2.55,4.45,,,orders alone\n"
                              "NTN 6201 wide,,,,,3.1,4.9,2.0,0.38,others\n";

TEST(BearingTable, GivesAGeometryByTheWholeDesignation) {
  const Folder folder;
  const auto table = folder.write("bearings.csv", some_rows);
  EXPECT_THAT(bearing_called("MB ER-16K", table),
              ElementsAre(Pair("ball_diameter_mm", 7.9375), Pair("balls", 9),
                          Pair("contact_angle_deg", 0), Pair("pitch_diameter_mm", 38.5064)));
  EXPECT_EQ(bearing_called("kg6205", table).at("pitch_diameter_mm"), 39);
}

TEST(BearingTable, GivesAGeometryBySomeOfTheWords) {
  const Folder folder;
  const auto table = folder.write("bearings.csv", some_rows);
  EXPECT_EQ(bearing_called("6205-2RS", table).at("pitch_diameter_mm"), 39.04);
  EXPECT_EQ(bearing_called("SKF 6205", table).at("pitch_diameter_mm"), 39.04);
  EXPECT_EQ(bearing_called("ER16K", table).at("balls"), 9);
  EXPECT_EQ(bearing_called("6205", table).at("pitch_diameter_mm"), 39.04);  // the first of two
}

TEST(BearingTable, IgnoresSealsAndClearance) {
  const Folder folder;
  const auto table = folder.write("bearings.csv", some_rows + "NSK 6203ZZ,8,6.77,28.5,0,,,,,one\n");
  for (const char* suffix :
       {"Z",      "ZZ",     "-2Z",    " 2Z",     "RS",    "-RS",      " 2RS",  "/C3",
        " C3",    "-ZZ/C3", "-2Z-C3", "ZZC3",    "-2RS1", "-2RSH/C3", "-2RSR", "-2RSL",
        "-2RZ",   "LLU",    "LLB/C4", " DDU",    "VV",    "RZ",       "-RS1",  "RSH",
        "/C2",    "C4",     "-CN",    "-LLU/CN", "-2RS2", "-RSD",     "-2HRS", "-2BRS",
        "LLH/C5", "LU",     "DU",     "-2NSE",   "-2RU",  " 2RS C3",  "ZZCM"}) {
    EXPECT_EQ(bearing_called("NU2205" + std::string(suffix), table).at("balls"), 13) << suffix;
    EXPECT_EQ(bearing_called("fag nu2205" + std::string(suffix), table).at("balls"), 13) << suffix;
    EXPECT_EQ(bearing_called("6203" + std::string(suffix), table).at("balls"), 8) << suffix;
  }
  EXPECT_EQ(bearing_called("6203", table).at("pitch_diameter_mm"), 28.5);
  for (const char* other :
       {"NU2205K", "NU2205 ECP", "NSK NU2205ZZ", "C3", "2Z", "ZZ", "2RS1", "2RS-C3"}) {
    EXPECT_ERROR(bearing_called(other, table), Exit::bad_input, "' has no row");
  }
}

TEST(BearingTable, IgnoresASealWrittenWithoutADash) {
  const Folder folder;
  const auto table =
      folder.write("bearings.csv", some_rows +
                                       "X 6202,8,6,25,0,,,,,a\nX 6220,8,25,140,0,,,,,b\n"
                                       "X 16005,9,6,36,0,,,,,c\nX 22212,16,12,85,10,,,,,d\n");
  for (const char* seal :
       {"2RS", "2RS1", "2RSH", "2RSR", "2Z", "2RZ", "2RSC3", "2Z/C3", "2RS C3", "-2RSC3", "-2ZRC3",
        "-2RUC3", "-2ZC3", "DD", "DDU", "-2RS P6", "ZZ/C3 P5"}) {
    EXPECT_EQ(bearing_called("6205" + std::string(seal), table).at("pitch_diameter_mm"), 39.04);
    EXPECT_EQ(bearing_called("KG6205" + std::string(seal), table).at("pitch_diameter_mm"), 39);
    EXPECT_EQ(bearing_called("6202" + std::string(seal), table).at("pitch_diameter_mm"), 25);
    EXPECT_EQ(bearing_called("16005" + std::string(seal), table).at("pitch_diameter_mm"), 36);
  }
  EXPECT_EQ(bearing_called("6202Z", table).at("pitch_diameter_mm"), 25);
  EXPECT_EQ(bearing_called("22212RS", table).at("pitch_diameter_mm"), 85);
  EXPECT_EQ(bearing_called("NSK 6804DDU",
                           folder.write("dd.csv", table_head + "NSK 6804DD,13,3.5,26,0,,,,,a\n"))
                .at("balls"),
            13);
  // 62202RS is a 62202 with RS or a 6220 with 2RS; 6205 has no clearance 2C3.
  for (const char* other : {"62202RS", "62202Z", "62052", "62052C3", "620522RS"}) {
    EXPECT_ERROR(bearing_called(other, table), Exit::bad_input, "' has no row");
  }
}

/// Inserts are deep groove bearings with a wide inner ring (FBJ's catalogue).
TEST(BearingTable, NamesTheDeepGrooveBearingOfAnInsert) {
  const Folder folder;
  const auto table = folder.write("bearings.csv", some_rows);
  for (const char* insert : {"UC205", "ASAHI UCP205", "UC 205"}) {
    EXPECT_ERROR(bearing_called(insert, table), Exit::bad_input, "' has no row in ");
  }
  for (const std::string insert : {"UC205", "UCP205", "UC205-16"}) {
    EXPECT_ERROR(bearing_called(insert, table), Exit::bad_input,
                 "; similar are SKF 6205-2RS JEM, KG 6205; an insert usually has the rolling "
                 "elements of the deep groove bearing 6205; give balls, ball_diameter_mm");
  }
  EXPECT_ERROR(bearing_called("UC201", table), Exit::bad_input, table.string() + "; give balls");
}

/// d / D = 7.94 / 39.04 = 0.20338: 4.5 (1 - 0.20338), 4.5 (1 + 0.20338), 1 / 0.20338 - 0.20338.
TEST(BearingTable, ListsTheLinesOfAllCompleteRows) {
  const Folder folder;
  const auto lines = lines_of_bearings(
      folder.write("bearings.csv", some_rows + "half,9,7.9,,0,,,,,a\nnothing,,,,,,,,,b\n"));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0].designation, "SKF 6205-2RS JEM");
  EXPECT_NEAR(lines[0].bpfo, 3.5848, 1e-4);
  EXPECT_NEAR(lines[0].bpfi, 5.4152, 1e-4);
  EXPECT_NEAR(lines[0].twice_bsf.value(), 4.7135, 1e-3);
  EXPECT_EQ(lines[4].bpfo, 2.55);
  EXPECT_FALSE(lines[4].twice_bsf);
  EXPECT_EQ(lines[5].twice_bsf.value(), 4.0);
  EXPECT_TRUE(lines_of_bearings(folder / "none.csv").empty());
}

TEST(BearingTable, GivesOrdersIfTheGeometryIsUnknown) {
  const Folder folder;
  EXPECT_THAT(bearing_called("NTN 6201", folder.write("bearings.csv", some_rows)),
              ElementsAre(Pair("bpfi", 4.45), Pair("bpfo", 2.55)));
}

TEST(BearingTable, ListsSimilarBearings) {
  const Folder folder;
  const auto table = folder.write("bearings.csv", some_rows);
  const auto refused = [&](const std::string& designation, const std::string& why) {
    EXPECT_ERROR(bearing_called(designation, table), Exit::bad_input, why);
  };
  refused("NSK 6205", "'NSK 6205' has no row in " + table.string() +
                          "; similar are SKF 6205-2RS JEM, KG 6205; give balls, ball_diameter_mm");
  for (const std::string part : {"JEM", "2RS", "SKF"}) {
    refused(part,
            "'" + part + "' has no row in " + table.string() + "; similar are SKF 6205-2RS JEM");
  }
  for (const std::string part : {"NU 2205 ECP", "NU2205-ECP", "NSK NU2205ZZ"}) {
    refused(part, "'" + part + "' has no row in " + table.string() + "; similar are FAG NU2205;");
  }
  for (const std::string part : {"6311-2RS", "6311 2RS C3", "SKF 6311"}) {  // a seal is not enough
    refused(part, "'" + part + "' has no row in " + table.string() + "; give balls");
  }
  refused("6311", "'6311' has no row in " + table.string() + "; give balls");
  refused("620", "'620' has no row");  // part of a word is not enough
  refused("6201", "'6201' may mean NTN 6201, NTN 6201 wide, whose fault lines differ");
}

TEST(BearingTable, IsRefusedIfDamaged) {
  const Folder folder;
  const auto with = [&](const std::string& text) {
    return bearing_called("6205", folder.write("bearings.csv", text));
  };
  EXPECT_ERROR(with("designation,balls\n6205,9\n"), Exit::bad_input,
               "bearings.csv, line 1: is not the header");
  EXPECT_ERROR(with(table_head + "6205,9,7.94,39,0,,,,,a page, b\n"), Exit::bad_input,
               "bearings.csv, line 2: has 11 fields");
  EXPECT_ERROR(with(table_head + "6205,nine,7.94,39,0,,,,,a page\n"), Exit::bad_input,
               "bearings.csv, line 2: 'nine' is not a number");
  EXPECT_ERROR(bearing_called("6205", folder / "none.csv"), Exit::input_missing, "none.csv: ");
}

/// Returns the rows of the project's own table, by an independent reader.
std::vector<std::vector<std::string>> own_rows() {
  std::istringstream in(bytes_of(std::filesystem::path(PIAE_SOURCE) / "pipeline/bearings.csv"));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    auto& fields = rows.emplace_back();
    std::istringstream of_line(line + ',');
    for (std::string field; std::getline(of_line, field, ',');) fields.push_back(field);
  }
  rows.erase(rows.begin());
  return rows;
}

TEST(OwnBearings, AreValidAndHaveASource) {
  const std::filesystem::path table = std::filesystem::path(PIAE_SOURCE) / "pipeline/bearings.csv";
  const auto rows = own_rows();
  EXPECT_GE(rows.size(), 40U);
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 10U) << row[0];
    EXPECT_GT(row[9].size(), 20U) << row[0];
    const auto keys = bearing_called(row[0], table);
    if (keys.contains("bpfo")) {
      const auto bsf = keys.find("bsf");
      bearing::Orders orders{.bpfo = keys.at("bpfo"), .bpfi = keys.at("bpfi")};
      if (bsf != keys.end()) orders.bsf = bsf->second;
      EXPECT_NO_THROW(bearing::validate(bearing::geometry_of(orders))) << row[0];
    } else {
      EXPECT_EQ(keys.at("pitch_diameter_mm"), std::stod(row[3])) << row[0];
    }
  }
}

/// Compares with Harris' formulae, at one turn a second.
TEST(OwnBearings, HaveThePublishedOrders) {
  std::size_t compared = 0;
  for (const auto& row : own_rows()) {
    if (row[1].empty()) continue;
    const double n = std::stod(row[1]);
    const double d = std::stod(row[2]);
    const double pitch = std::stod(row[3]);
    const double gamma = d / pitch * std::cos(std::stod(row[4]) * std::numbers::pi / 180);
    const std::array expected{n / 2 * (1 - gamma), n / 2 * (1 + gamma),
                              pitch / (2 * d) * (1 - gamma * gamma), (1 - gamma) / 2};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (row[5 + i].empty()) continue;
      EXPECT_NEAR(std::stod(row[5 + i]), expected.at(i), 0.01 * expected.at(i)) << row[0];
      ++compared;
    }
  }
  EXPECT_GE(compared, 20U);
}

}  // namespace
}  // namespace piae::signal
