// Tests on the real recordings, if the environment variable DATA_DIR is set. Others have seen such
// warnings, too: Smith and Randall (2015) could not diagnose some records of CWRU from their own
// lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

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
  if (found.exit != Exit::done) return std::nullopt;
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

}  // namespace
}  // namespace piae::inspection
