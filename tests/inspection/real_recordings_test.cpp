// Tests on the real recordings, if the environment variable DATA_DIR is set. Others have seen such
// warnings, too: Smith and Randall (2015) could not diagnose some records of CWRU from their own
// lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "bearing/impact_frequency.hpp"
#include "inspection/warnings.hpp"

namespace piae::inspection {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

const fs::path descriptions =
    fs::path(__FILE__).parent_path().parent_path().parent_path() / "pipeline" / "datasets";

/// Returns the check of a data set; nothing if its recordings are missing.
std::optional<DatasetCheck> checked(const signal::Description& description) {
  const char* folder = std::getenv("DATA_DIR");
  if (folder == nullptr) return std::nullopt;
  DatasetCheck found = check(description, folder);
  if (found.exit == Exit::input_missing) return std::nullopt;
  EXPECT_EQ(found.exit, Exit::done);
  return found;
}

std::optional<std::vector<std::string>> warnings_of(const std::string& dataset) {
  const auto description = signal::read_description(descriptions / (dataset + ".toml"));
  const auto found = checked(description);
  return found ? std::optional(inspection::warnings_of(description, *found)) : std::nullopt;
}

TEST(RealRecordings, OfCwruHaveThreeFaultsWithoutClearLines) {
  const auto warnings = warnings_of("cwru");
  if (!warnings) GTEST_SKIP() << "DATA_DIR does not have the recordings";
  const auto about = [](const char* name, const char* own) {
    return AllOf(HasSubstr(name), HasSubstr(own), HasSubstr("the line of its class"));
  };
  EXPECT_THAT(*warnings, UnorderedElementsAre(about("B007 (", "2BSF"), about("B021 (", "2BSF"),
                                              about("OR014 (", "BPFO")));
}

/// The amplitude scale differs from file to file.
TEST(RealRecordings, OfHitSmHaveAHealthyLineAndAnotherScale) {
  const auto warnings = warnings_of("hit-sm");
  if (!warnings) GTEST_SKIP() << "DATA_DIR does not have the recordings";
  EXPECT_THAT(*warnings,
              UnorderedElementsAre(
                  AllOf(HasSubstr("Normal ("), HasSubstr("BPFI"), HasSubstr("healthy, but")),
                  AllOf(HasSubstr("IR2 ("), HasSubstr("526 times that of the healthy records"),
                        HasSubstr("(the same holds for IR5, IR8, OR2, OR5, OR8)"))));
}

/// CWRU's files hold the speed of each record, but 3001 to 3008 do not, and 158 shows 1796 instead
/// of 1773 rpm in both spectra. Speeds are searched about the nominal ones of the loads.
TEST(RealRecordings, OfCwruShowTheirSpeeds) {
  auto description = signal::read_description(descriptions / "cwru-blind.toml");
  const std::array nominal{1797.0, 1772.0, 1750.0, 1730.0};
  std::vector<double> truths;
  for (signal::RecordSource& source : description.records) {
    truths.push_back(source.shaft_speed_rpm);
    source.shaft_speed_rpm = *std::ranges::min_element(
        nominal, {}, [&](double rpm) { return std::abs(rpm - truths.back()); });
  }
  const auto found = checked(description);
  if (!found) GTEST_SKIP() << "DATA_DIR does not have the recordings";
  int certain = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const RecordCheck& record = found->records[i];
    const std::string& file = record.source.files.front();
    const bool has_truth = file.find("/30") == std::string::npos && file != "cwru/158.mat";
    if (!has_truth || !record.shaft->is_certain()) continue;
    ++certain;
    EXPECT_NEAR(record.shaft->rpm / truths[i], 1, 0.005) << file;
  }
  EXPECT_GE(certain, 50);
}

/// 13 and 9 samples of 262144 lie on 9.999, the end of a range of 10 V. No other of the 32 records
/// is clipped, repeats, or has a spike.
TEST(RealRecordings, OfUestcAreClippedInTwoRecords) {
  auto warnings = warnings_of("uestc-speeds");
  if (!warnings) GTEST_SKIP() << "DATA_DIR does not have the recordings";
  std::erase_if(*warnings, [](const std::string& line) {
    return line.find("the line of its class") != std::string::npos ||
           line.find("healthy, but") != std::string::npos ||
           line.find("the shaft seems to turn") != std::string::npos;
  });
  EXPECT_THAT(*warnings,
              ElementsAre(AllOf(HasSubstr("I_1400_1.mat"), HasSubstr("clipped: 13 samples"),
                                HasSubstr("(9.999)")),
                          AllOf(HasSubstr("I_1400_2.mat"), HasSubstr("clipped: 9 samples"))));
}

/// Counts of named lines, by their truth: the order within 1 %, and the fault type.
struct Named {
  int records = 0;
  int visible = 0;  ///< records whose true line, at the speed used, exceeds 8 dB
  int order = 0;    ///< of these, orders within 1 %
  int type = 0;     ///< of these, the right type, too
  int high = 0;     ///< of all records, those named with high confidence
  int wrong_high = 0;
  int fair = 0;
  int wrong_fair = 0;
};

Likeness true_likeness(signal::Defect fault_type) {
  switch (fault_type) {
    case signal::Defect::outer:
      return Likeness::outer;
    case signal::Defect::inner:
      return Likeness::inner;
    case signal::Defect::roller:
      return Likeness::ball;
    default:
      return Likeness::nothing;
  }
}

/// Returns the highest comb within 1 % of an order.
double comb_near(const OrderExcess& excess, double order) {
  double highest = 0;
  for (int i = -20; i <= 20; ++i) {
    highest = std::max(highest, excess.comb_db(order * (1 + 0.0005 * i), 10).value_or(0));
  }
  return highest;
}

/// Names the lines of a data set as if its bearing were unknown. Empty without the recordings.
std::optional<Named> named_without_bearing(const std::string& dataset) {
  auto description = signal::read_description(descriptions / (dataset + ".toml"));
  const bearing::Geometry geometry = description.info.bearing;
  description.info.has_bearing = false;
  const auto found = checked(description);
  if (!found) return std::nullopt;
  Named named;
  for (const RecordCheck& record : found->records) {
    if (!record.unknown_line) continue;
    const UnknownLine& line = *record.unknown_line;
    const signal::Defect fault_type = description.info.class_of(record.source.label).defect;
    const double truth = bearing::impact_frequency_hz(geometry, fault_type, 60);
    const bool is_near = std::abs(line.order / truth - 1) < 0.01;
    const bool is_right = is_near && line.likeness == true_likeness(fault_type);
    const bool is_fair = line.likeness != Likeness::nothing && !line.is_certain;
    ++named.records;
    named.high += line.is_certain ? 1 : 0;
    named.wrong_high += line.is_certain && !is_right ? 1 : 0;
    named.fair += is_fair ? 1 : 0;
    named.wrong_fair += is_fair && !is_right ? 1 : 0;
    const RecordCheck& healthy =
        *healthy_record_for(record, *found, description.info.healthy_label());
    const OrderExcess excess(record.order_lines, healthy.order_lines,
                             record.shown_speed_rpm() / 60);
    if (comb_near(excess, truth) < 8) continue;
    ++named.visible;
    named.order += is_near ? 1 : 0;
    named.type += is_right ? 1 : 0;
  }
  std::cout << dataset << ": records " << named.records << ", visible " << named.visible
            << ", order within 1 % " << named.order << ", and type " << named.type << "; high "
            << named.high << " (wrong " << named.wrong_high << "), fair " << named.fair
            << " (wrong " << named.wrong_fair << ")\n";
  return named;
}

/// docs/own-machine.md shows these numbers.
TEST(RealRecordings, ShowTheirLinesWithoutTheirBearing) {
  const auto cwru = named_without_bearing("cwru-blind");
  const auto hit_sm = named_without_bearing("hit-sm-types-zero");
  const auto uestc = named_without_bearing("uestc-true-types-zero");
  const auto nominal = named_without_bearing("uestc-types-zero");
  if (!cwru || !hit_sm || !uestc || !nominal)
    GTEST_SKIP() << "DATA_DIR does not have the recordings";
  for (const Named& named : {*cwru, *hit_sm, *uestc, *nominal}) {
    EXPECT_EQ(named.wrong_high, 0);
    EXPECT_GE(named.order, 0.9 * named.visible);
  }
  EXPECT_GE(cwru->visible, 38);
  EXPECT_GE(hit_sm->visible, 18);
  EXPECT_GE(uestc->visible, 10);
  EXPECT_GE(cwru->high + hit_sm->high, 25);
}

}  // namespace
}  // namespace piae::inspection
