// Tests on the real recordings, if the environment variable DATA_DIR is set. Others have seen such
// warnings, too: Smith and Randall (2015) could not diagnose some records of CWRU from their own
// lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

/// Returns the warnings of a data set; nothing if its recordings are missing.
std::optional<std::vector<std::string>> warnings_of(const std::string& dataset) {
  const char* folder = std::getenv("DATA_DIR");
  if (folder == nullptr) return std::nullopt;
  const auto description = signal::read_description(descriptions / (dataset + ".toml"));
  const DatasetCheck found = check(description, folder);
  if (found.exit != Exit::done) return std::nullopt;
  return inspection::warnings_of(description, found);
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

/// 13 and 9 samples of 262144 lie on 9.999, the end of a range of 10 V. No other of the 32 records
/// is clipped, repeats, or has a spike.
TEST(RealRecordings, OfUestcAreClippedInTwoRecords) {
  auto warnings = warnings_of("uestc-speeds");
  if (!warnings) GTEST_SKIP() << "DATA_DIR does not have the recordings";
  std::erase_if(*warnings, [](const std::string& line) {
    return line.find("the line of its class") != std::string::npos ||
           line.find("healthy, but") != std::string::npos;
  });
  EXPECT_THAT(*warnings,
              ElementsAre(AllOf(HasSubstr("I_1400_1.mat"), HasSubstr("clipped: 13 samples"),
                                HasSubstr("(9.999)")),
                          AllOf(HasSubstr("I_1400_2.mat"), HasSubstr("clipped: 9 samples"))));
}

}  // namespace
}  // namespace piae::inspection
