// `ingest --check` on good recordings, and on each mistake that it should find.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/kinematics.hpp"
#include "stages/tiny.hpp"
#include "support/description_text.hpp"
#include "support/made_recordings.hpp"

namespace piae::stages {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double rate_hz = 12000;
constexpr double seconds = 6;

std::string record_of(const std::string& name) {
  return "[[record]]\nclass = \"" + name + "\"\nfile = \"" + name +
         ".csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 12000\n";
}

/// CWRU's bearing at 1797 rpm: healthy, with an inner and an outer race defect.
const std::string good_description = described_bearing("rig") + described_normal + described_ir007 +
                                     described_or021 + record_of("Normal") + record_of("IR007") +
                                     record_of("OR021");

std::vector<double> good_samples(const std::string& name) {
  const bearing::FaultFrequencies f = bearing::fault_frequencies({}, 1797);
  const double impacts_hz = name == "IR007" ? f.bpfi_hz : name == "OR021" ? f.bpfo_hz : 0;
  return impact_recording(rate_hz, seconds, impacts_hz, "ingest --check/" + name);
}

/// Returns a column of times and one of samples.
std::string csv_of(const std::vector<double>& samples) {
  std::string text = "time,acceleration\n";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    text +=
        std::to_string(static_cast<double>(i) / rate_hz) + ',' + std::to_string(samples[i]) + '\n';
  }
  return text;
}

class IngestCheck : public testing::Test {
 protected:
  IngestCheck() {
    describe(good_description);
    for (const std::string name : {"Normal", "IR007", "OR021"}) write(name, good_samples(name));
  }
  void describe(const std::string& text) const { folder_.write("rig.toml", text); }
  void write(const std::string& name, const std::vector<double>& samples) const {
    folder_.write("data/" + name + ".csv", csv_of(samples));
  }
  [[nodiscard]] Outcome run(const Arguments& more = {}) const {
    Arguments arguments{"--check", "--description", "rig.toml", "--data-dir", "data"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return stages::run(folder_.path(), "ingest", arguments);
  }

  /// Expects exactly one warning, with all these words, and exit code 0.
  void expect_one_warning(const std::vector<std::string>& words) const {
    const Outcome outcome = run();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<std::string> warnings = warnings_in(outcome.out);
    ASSERT_EQ(warnings.size(), 1U) << outcome.out;
    for (const std::string& word : words) EXPECT_THAT(warnings.front(), HasSubstr(word));
    EXPECT_THAT(outcome.out, HasSubstr("warnings: 1\n"));
  }
  [[nodiscard]] static std::vector<std::string> warnings_in(const std::string& out) {
    std::istringstream lines(out);
    std::vector<std::string> warnings;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("warning: ")) warnings.push_back(line);
    }
    return warnings;
  }

  Folder folder_;
};

TEST_F(IngestCheck, ShowsGoodRecordingsAndWarnsOfNothing) {
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(warnings_in(outcome.out), IsEmpty()) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("107.34"));
  EXPECT_TRUE(outcome.out.ends_with("checked 3 records of 3 classes, warnings: 0\n"));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 102U) << line;
  EXPECT_FALSE(fs::exists(folder_ / "records.h5"));
}

/// BPFO is 3.584 and BPFI 5.416 times the shaft's speed. The impacts do not vary with its angle, so
/// both look like those of an outer race. They fill every turn alike, so the shaft does not show.
TEST_F(IngestCheck, NamesTheLinesOfAnUnknownBearing) {
  std::string text = good_description;
  const std::size_t bearing = text.find("[bearing]");
  text.erase(bearing, text.find("[[class]]") - bearing);
  for (const char* defect :
       {"\"inner\"\ndefect_size_mm = 0.1778", "\"outer\"\ndefect_size_mm = 0.5334"}) {
    text = replaced(text, defect, "\"other\"");
  }
  describe(text);
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("IR007 +outer race +fair +- +1797 +5\\.4[0-9]+"));
  EXPECT_THAT(outcome.out, ContainsRegex("OR021 +outer race +fair +- +1797 +3\\.5[89][0-9]"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("BPFO")));
}

TEST_F(IngestCheck, DerivesRacewaysThatAreNotGiven) {
  describe(replaced(replaced(good_description, "inner_raceway_mm = 31.06\n", ""),
                    "outer_raceway_mm = 46.94\n", ""));
  EXPECT_EQ(run().out.find("warning: "), std::string::npos);
}

TEST_F(IngestCheck, WarnsOfATimeColumn) {
  describe(replaced(good_description, "IR007.csv\"\nvariable = \"acceleration\"",
                    "IR007.csv\"\nvariable = \"time\""));
  expect_one_warning({"IR007 (IR007.csv, variable time)", "a time"});
}

TEST_F(IngestCheck, WarnsOfARateInKHz) {
  describe(replaced(good_description,
                    "IR007.csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 12",
                    "IR007.csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 0.012 # 12"));
  expect_one_warning({"IR007 (IR007.csv", "sample_rate_hz = 0.012", "hours"});
}

/// The class is then too short for its windows, which is an error; the warning explains why.
TEST_F(IngestCheck, WarnsOfARateThatIsTooHigh) {
  describe(replaced(good_description,
                    "IR007.csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 12",
                    "IR007.csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 12000"));
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 65);
  const std::vector<std::string> warnings = warnings_in(outcome.out);
  ASSERT_EQ(warnings.size(), 1U) << outcome.out;
  EXPECT_THAT(warnings.front(), HasSubstr("sample_rate_hz = 1.2e+07 are 0.006 s"));
  EXPECT_THAT(outcome.out, HasSubstr("\ndata set rig, class IR007: 600 windows of 1024"));
}

TEST_F(IngestCheck, WarnsOfSmallStrides) {
  std::vector<double> samples = good_samples("OR021");
  samples.resize(24000);
  write("OR021", samples);
  expect_one_warning({"class OR021", "start every 38", "96.3 %", "PROTOCOL=random"});
}

/// 1.3 s are too short for 600 windows, but give 150 at a sensible stride.
TEST_F(IngestCheck, GoesByTheDescriptionsOwnSplit) {
  for (const std::string name : {"Normal", "IR007", "OR021"}) {
    std::vector<double> samples = good_samples(name);
    samples.resize(1500);
    write(name, samples);
  }
  const Outcome refused = run();
  EXPECT_EQ(refused.status, 65);
  EXPECT_THAT(refused.out, HasSubstr("at most 477 fit, at stride 1: lower windows-per-class (and "
                                     "test-per-class) or window, in [split] of the description"));
  EXPECT_EQ(refused.err,
            "ingest: data set rig has problems, see above; correct its description or its files\n");
  describe(good_description +
           "[split]\nwindows-per-class = 60\ntest-per-class = 20\nwindow = 512\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("windows of 512 samples"));
  EXPECT_THAT(outcome.out, HasSubstr("start every 16"));  // (1500 - 512) / 59
  describe(good_description + "[split]\nwindows-per-class = 60\n");
  expect_refusal(run(), "ingest", 65,
                 {"rig.toml", "windows-per-class (60) must exceed test-per-class", "[split]"});
}

/// Files that the program opens then get the numbers of the closed streams.
TEST_F(IngestCheck, ReadsRecordingsWhereInputAndOutputAreClosed) {
  for (const std::string closed : {"<&-", "<&- >&-", "<&- >&- 2>&-", ">&- 2>&-"}) {
    const std::string command = "cd " + folder_.path().string() + " && " + PIAE_BIN +
                                "/ingest --description rig.toml --data-dir data --output r.h5 " +
                                closed;
    EXPECT_EQ(std::system(command.c_str()), 0) << closed;
  }
}

/// An error in a recording names only its file, not the description, too.
TEST_F(IngestCheck, AMessageHasOnePlace) {
  folder_.write("data/IR007.csv", "acceleration\n1\nx\n");
  const Outcome outcome =
      stages::run(folder_.path(), "ingest",
                  {"--description", "rig.toml", "--data-dir", "data", "--output", "records.h5"});
  EXPECT_EQ(
      outcome.err,
      "ingest: data/IR007.csv, line 3: column acceleration holds 'x', not a number; remove the "
      "line, or get the file again\n");
}

TEST_F(IngestCheck, WarnsOfClippedSamples) {
  std::vector<double> samples = good_samples("OR021");
  for (double& x : samples) x = std::clamp(x, -0.4, 0.4);
  write("OR021", samples);
  expect_one_warning({"OR021 (OR021.csv, variable acceleration): clipped", "0.4"});
}

/// Noise exceeds the limit only for single samples.
TEST_F(IngestCheck, WarnsOfPeaksThatAreCutToOneSample) {
  std::vector<double> samples = good_samples("Normal");
  for (double& x : samples) x = std::clamp(x, -0.3, 0.3);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (std::abs(samples[i]) == 0.3 && std::abs(samples[i - 1]) == 0.3) samples[i] = 0.1;
  }
  write("Normal", samples);
  expect_one_warning({"Normal (Normal.csv, variable acceleration): clipped", "(0.3)", "(-0.3)"});
}

TEST_F(IngestCheck, WarnsOfADeadSensor) {
  std::vector<double> samples = good_samples("OR021");
  for (double& x : samples) x = std::clamp(std::round(x / 0.1), -2.0, 1.0);
  write("OR021", samples);
  expect_one_warning({"OR021 (OR021.csv, variable acceleration): has only 4 distinct values"});
}

TEST_F(IngestCheck, WarnsOfAHalfThatRepeatsTheOther) {
  std::vector<double> samples = good_samples("IR007");
  std::copy_n(samples.begin(), 36000, samples.begin() + 36000);
  write("IR007", samples);
  expect_one_warning(
      {"IR007 (IR007.csv, variable acceleration): samples 36000 to 71999 repeat "
       "samples 0 to 35999 exactly, 50 % of the record",
       "PROTOCOL=blocked"});
}

TEST_F(IngestCheck, WarnsOfASpike) {
  std::vector<double> samples = good_samples("Normal");
  samples[1000] = 300;
  write("Normal", samples);
  expect_one_warning(
      {"Normal (Normal.csv, variable acceleration): sample 1000 (300) is an isolated spike"});
}

TEST_F(IngestCheck, WarnsOfCounts) {
  std::vector<double> samples = good_samples("OR021");
  for (double& x : samples) x = std::round(x * 3e4);
  write("OR021", samples);
  expect_one_warning({"OR021 (OR021.csv, variable acceleration): its RMS, ", "unit or scale"});
}

TEST_F(IngestCheck, WarnsOfARecordOfALowerRate) {
  describe(replaced(good_description,
                    "OR021.csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 12000",
                    "OR021.csv\"\nvariable = \"acceleration\"\nsample_rate_hz = 6000"));
  const std::vector<std::string> warnings = warnings_in(run().out);
  ASSERT_FALSE(warnings.empty());
  EXPECT_THAT(warnings.front(), HasSubstr("OR021 (OR021.csv, variable acceleration): "
                                          "sample_rate_hz = 6000 is below the data set's 12000: "
                                          "nothing above 3000 Hz"));
}

TEST_F(IngestCheck, WarnsOfMissingSamples) {
  const std::string text = csv_of(good_samples("Normal"));
  const std::size_t from = text.find("\n2.000000,");
  const std::size_t to = text.find("\n2.100000,");
  folder_.write("data/Normal.csv", text.substr(0, from) + text.substr(to));
  expect_one_warning(
      {"Normal (Normal.csv, variable acceleration): the times in column 1 jump 1 "
       "time: 1200 samples are missing",
       "follows sample 23999"});
}

TEST_F(IngestCheck, WarnsOfStretchesOfZeros) {
  std::vector<double> samples = good_samples("Normal");
  std::fill_n(samples.begin() + 30000, 2000, 0.0);
  write("Normal", samples);
  expect_one_warning({"Normal (Normal.csv", "constant at 0 for 2000 samples", "from sample 30000"});
}

TEST_F(IngestCheck, WarnsOfASpeedInHz) {
  describe(replaced(good_description, "= 1797", "= 29.95"));
  expect_one_warning({"shaft_speed_rpm = 29.95", "1797 rpm"});
}

TEST_F(IngestCheck, WarnsOfBoreAndOutsideDiameter) {
  describe(replaced(replaced(good_description, "= 31.06", "= 25"), "= 46.94", "= 52"));
  expect_one_warning({"inner_raceway_mm = 25", "outer_raceway_mm = 52", "bore"});
}

TEST_F(IngestCheck, WarnsOfSwappedLabels) {
  write("OR021", good_samples("IR007"));
  write("IR007", good_samples("OR021"));
  const std::vector<std::string> warnings = warnings_in(run().out);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_THAT(warnings[0], HasSubstr("IR007 (IR007.csv"));
  EXPECT_THAT(warnings[0], HasSubstr("; BPFO (107.3 Hz"));
  EXPECT_THAT(warnings[1], HasSubstr("OR021 (OR021.csv"));
  EXPECT_THAT(warnings[1], HasSubstr("; BPFI (162.2 Hz"));
}

TEST_F(IngestCheck, WarnsOfAHealthyRecordThatShowsAFault) {
  std::vector<double> samples = good_samples("OR021");
  for (double& x : samples) x *= 0.5;
  write("Normal", samples);
  expect_one_warning({"Normal (Normal.csv", "healthy, but BPFO"});
}

TEST_F(IngestCheck, WarnsOfAWrongSpeed) {
  describe(replaced(good_description, "= 1797", "= 1650"));
  const std::vector<std::string> warnings = warnings_in(run().out);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_THAT(warnings[0], HasSubstr("IR007 (IR007.csv, variable acceleration): BPFI"));
  EXPECT_THAT(warnings[1], HasSubstr("OR021 (OR021.csv, variable acceleration): BPFO"));
}

TEST_F(IngestCheck, GoesOnAfterWhatCannotBeRead) {
  fs::remove(folder_ / "data/IR007.csv");
  const Outcome outcome = run({"--picture", "rig.svg"});
  EXPECT_EQ(outcome.status, 66);
  EXPECT_THAT(outcome.out, HasSubstr("data/IR007.csv: no such file"));
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  const std::string picture = bytes_of(folder_ / "rig.svg");
  EXPECT_THAT(picture, HasSubstr("OR021.csv"));
  EXPECT_THAT(picture, Not(HasSubstr("IR007.csv")));
}

TEST_F(IngestCheck, DrawsTheSamePictureEachTime) {
  EXPECT_EQ(run({"--picture", "one.svg"}).status, 0);
  EXPECT_EQ(run({"--picture", "two.svg"}).status, 0);
  const std::string picture = bytes_of(folder_ / "one.svg");
  EXPECT_EQ(picture, bytes_of(folder_ / "two.svg"));
  EXPECT_TRUE(picture.starts_with("<svg "));
  EXPECT_THAT(picture, HasSubstr("OR021 (OR021.csv), BPFO 107.3 Hz"));
}

TEST_F(IngestCheck, ReplacesNothingThatIsRead) {
  const std::string recording = bytes_of(folder_ / "data/IR007.csv");
  for (const std::string file : {"rig.toml", "data/IR007.csv", "./data/../data/IR007.csv"}) {
    expect_refusal(run({"--picture", file}), "ingest", 2, {file, "is an input"});
    expect_refusal(
        stages::run(folder_.path(), "ingest",
                    {"--description", "rig.toml", "--data-dir", "data", "--output", file}),
        "ingest", 2, {file, "is an input"});
  }
  EXPECT_TRUE(bytes_of(folder_ / "rig.toml") == good_description);
  EXPECT_TRUE(bytes_of(folder_ / "data/IR007.csv") == recording);
}

TEST_F(IngestCheck, APictureNeedsACheck) {
  const Outcome outcome = stages::run(folder_.path(), "ingest",
                                      {"--description", "rig.toml", "--data-dir", "data",
                                       "--output", "records.h5", "--picture", "rig.svg"});
  expect_refusal(outcome, "ingest", 2, {"--picture", "--check"});
  EXPECT_FALSE(fs::exists(folder_ / "records.h5"));
}

}  // namespace
}  // namespace piae::stages
