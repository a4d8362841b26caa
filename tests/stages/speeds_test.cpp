#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "scoring/diagnosis_record.hpp"
#include "stages/program.hpp"
#include "support/description_text.hpp"
#include "support/drifting_shaft.hpp"
#include "support/turning_shaft.hpp"

/// Speeds that were recorded with the signal, or that a stream shows.
namespace piae::stages {
namespace {

using testing::HasSubstr;
using testing::Not;

class Speeds : public testing::Test {
 protected:
  /// Writes a healthy and a faulty machine whose speed drifts, and the pulses of the shaft.
  void write_machine() const {
    folder_.write("data/healthy.csv", column_of(shaft_.impacts(3.585, 0, 12000, 1)));
    folder_.write("data/outer.csv", column_of(shaft_.impacts(3.585, 20, 12000, 2)));
    folder_.write("data/turns.csv", column_of(shaft_.times_s(1)));
    const auto record = [](const std::string& name, const std::string& label) {
      return "[[record]]\nclass = \"" + label + "\"\nfile = \"" + name +
             ".csv\"\nvariable = \"1\"\nsample_rate_hz = 12000\nshaft_speed_rpm = { file = "
             "\"turns.csv\", variable = \"1\" }\n";
    };
    folder_.write("rig.toml", described_bearing("rig") + described_normal + described_or021 +
                                  record("healthy", "Normal") + record("outer", "OR021"));
  }
  [[nodiscard]] Outcome ingest(const Arguments& more) const {
    Arguments all{"--description", "rig.toml", "--data-dir", "data"};
    all.insert(all.end(), more.begin(), more.end());
    return run(folder_.path(), "ingest", all);
  }
  void run_well(const std::string& stage, const Arguments& arguments) const {
    const Outcome outcome = run(folder_.path(), stage, arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  /// Watches 50 s of a shaft that turns at 1797 rpm, as raw.f32; the first 18 s are healthy.
  [[nodiscard]] Outcome monitor(const std::string& speed_rpm, const Arguments& more) const {
    std::string bytes;
    for (const double sample : turning_shaft(1797, 600000, 12000)) {
      const auto x = static_cast<float>(sample);
      bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
    folder_.write("raw.f32", bytes);
    folder_.write("fan.toml", described_bearing("fan") + described_normal +
                                  "[[record]]\nclass = \"Normal\"\nfile = \"a.csv\"\nvariable = "
                                  "\"1\"\nsample_rate_hz = 12000\n");
    Arguments all{"--input", "raw.f32",       "--sample-rate-hz", "12000",       "--healthy",
                  "0.005",   "--description", "fan.toml",         "--speed-rpm", speed_rpm};
    all.insert(all.end(), more.begin(), more.end());
    return run(folder_.path(), "monitor", all);
  }
  const DriftingShaft shaft_;
  const Folder folder_;
};

TEST_F(Speeds, OfPulsesLeadToADiagnosis) {
  write_machine();
  const Outcome made = ingest({"--output", "records.h5"});
  ASSERT_EQ(made.status, 0) << made.err;
  const artefact::Reader records(folder_ / "records.h5", "records");
  EXPECT_EQ(records.numbers<double>("/speeds/OR021", {0}).values.size(), 1000U);
  EXPECT_NEAR(records.real("/records/OR021", "shaft_speed_rpm"), 1500, 0.1);
  const auto inputs = records.strings(std::string(artefact::provenance_group) + "/inputs");
  EXPECT_TRUE(std::ranges::any_of(
      inputs, [](const std::string& input) { return input.starts_with("recording turns.csv "); }));
  run_well("split", {"--records", "records.h5", "--seed", "0", "--window", "4096",
                     "--windows-per-class", "100", "--test-per-class", "20", "--output-dir", "."});
  run_well("verify", {"records.h5", "A.h5", "B.h5", "C.h5", "D.h5"});
  run_well("diagnose",
           {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio", "100to1", "--seed",
            "0", "--classifier", "nearest-orders", "--output", "diagnosis.h5"});
  const artefact::Reader reader(folder_ / "diagnosis.h5", "diagnosis");
  EXPECT_EQ(scoring::read_diagnosis(reader).accuracy(), 1);
}

TEST_F(Speeds, OfPulsesAreShownByTheCheck) {
  write_machine();
  const Outcome outcome = ingest({"--check"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nOR021   1500"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("the shaft seems to turn")));
}

TEST_F(Speeds, OfDamagedPulsesAreRefused) {
  write_machine();
  folder_.write("data/turns.csv", "0\n0.04\n0.08\n0.08\n");
  expect_refusal(ingest({"--output", "records.h5"}), "ingest", 65,
                 {"turns.csv (record Normal)", "time 4 of the pulses"});
  EXPECT_FALSE(fs::exists(folder_ / "records.h5"));
  fs::remove(folder_ / "data/turns.csv");
  expect_refusal(ingest({"--output", "records.h5"}), "ingest", 66, {"turns.csv", "no such file"});
  EXPECT_FALSE(fs::exists(folder_ / "records.h5"));
}

TEST_F(Speeds, OfAStreamAreReportedAndUsed) {
  const Outcome right = monitor("1797", {});
  ASSERT_EQ(right.status, 0) << right.err;
  EXPECT_THAT(right.err, Not(HasSubstr("the shaft seems to turn")));
  const Outcome wrong = monitor("1700", {});
  EXPECT_THAT(wrong.err, HasSubstr("raw.f32: the shaft seems to turn at 1797 rpm, 5.7 % above 1700 "
                                   "rpm; --speed-search-percent takes the speed from the signal"));
  const Outcome found = monitor("1700", {"--speed-search-percent", "10"});
  EXPECT_THAT(found.err, HasSubstr("this speed is used from 20 s on"));
  EXPECT_NE(found.out, wrong.out);
}

TEST_F(Speeds, OfAStreamNeedLines) {
  folder_.write("raw.f32", "");
  const Arguments search{"--speed-search-percent", "10", "--healthy", "1"};
  Arguments stream = search;
  stream.insert(stream.end(), {"--input", "raw.f32", "--sample-rate-hz", "12000"});
  expect_refusal(run(folder_.path(), "monitor", stream), "monitor", 2,
                 {"--speed-search-percent needs fault lines"});
  Arguments records = search;
  records.insert(records.end(), {"--records", "raw.f32"});
  expect_refusal(run(folder_.path(), "monitor", records), "monitor", 2,
                 {"--speed-search-percent is for streams"});
}

}  // namespace
}  // namespace piae::stages
