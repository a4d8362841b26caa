#include "inspection/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/random.hpp"
#include "support/folder.hpp"

namespace piae::inspection {
namespace {

using signal::Defect;
using signal::Description;
using signal::RecordSource;

/// Returns two classes, one of two files, one of one.
Description description() {
  Description d;
  d.info.name = "rig";
  d.info.sample_rate_hz = 1000;
  d.info.classes = {{"ok", Defect::none, 0}, {"bad", Defect::outer, 1}};
  d.records = {{"bad", 1, {"bad.csv"}, "1", 1000, 600, "", ""},
               {"ok-01", 0, {"ok1.csv"}, "1", 1000, 600, "", ""},
               {"ok-02", 0, {"ok2.csv"}, "1", 1000, 600, "", ""}};
  return d;
}

/// Writes `samples` numbers first, -first, first, ... with RMS `first`, so that each file differs.
void write_signal(const Folder& folder, const std::string& file, std::size_t samples, int first) {
  std::string text;
  for (std::size_t i = 0; i < samples; ++i) {
    text += std::to_string(i % 2 == 0 ? first : -first) + "\n";
  }
  folder.write(file, text);
}

// 600 windows of 1024 in 1024 + 599 * 3 = 2821 samples: stride 3. Two records of 1324 give 301
// windows each at stride 1, and too few at stride 2.
TEST(Check, FindsSamplesLevelsAndStrides) {
  const Folder folder;
  write_signal(folder, "bad.csv", 2821, 3);
  write_signal(folder, "ok1.csv", 1324, 1);
  write_signal(folder, "ok2.csv", 1324, 2);
  const Description d = description();
  const DatasetCheck found = check(d, folder.path());
  EXPECT_EQ(found.exit, Exit::done);
  ASSERT_EQ(found.records.size(), 3U);
  EXPECT_EQ(found.records[0].pieces, std::vector<std::size_t>{2821});
  EXPECT_EQ(found.records[0].file_samples, 2821U);
  ASSERT_TRUE(found.records[0].level && found.records[2].level);
  EXPECT_NEAR(found.records[0].level->rms, 3, 1e-5);
  EXPECT_NEAR(found.records[2].level->rms, 2, 1e-9);
  EXPECT_EQ(found.records[0].beginning.size(), 200U);
  ASSERT_EQ(found.classes.size(), 2U);
  EXPECT_EQ(found.classes[0].records, 2U);
  EXPECT_EQ(found.classes[0].stride, 1U);
  EXPECT_EQ(found.classes[1].stride, 3U);
  EXPECT_NEAR(found.classes[1].overlap, 1021.0 / 1024, 1e-12);
}

/// A and D of the fault class come from one file and C from another: no test window shares samples
/// with a training window. 595 windows of 1024 in 1024 + 594 * 3 = 2806 samples: stride 3.
TEST(Check, CountsEachConditionOfATransferSeparately) {
  const Folder folder;
  write_signal(folder, "bad.csv", 2806, 3);
  write_signal(folder, "bad2.csv", 1028, 4);
  write_signal(folder, "ok1.csv", 1400, 1);
  write_signal(folder, "ok2.csv", 1400, 2);
  Description d = description();
  d.info.conditions = {{.name = "a", .known = false}, {.name = "b", .test = false}};
  d.records.push_back({"bad-02", 1, {"bad2.csv"}, "1", 1000, 600, "", "", "b"});
  for (RecordSource& record : d.records) {
    if (record.condition.empty()) record.condition = record.name == "ok-02" ? "b" : "a";
  }
  const DatasetCheck found = check(d, folder.path());
  EXPECT_EQ(found.exit, Exit::done) << found.classes[0].problem << found.classes[1].problem;
  EXPECT_EQ(found.classes[1].records, 2U);
  EXPECT_EQ(found.classes[1].stride, 1U);
  EXPECT_EQ(found.classes[1].shared_with_training, 0);
  EXPECT_NEAR(found.classes[0].shared_with_training, 1, 1e-6);
}

/// Resampling rounds clipped tops, so the check needs the file's own samples.
TEST(Check, FindsFlawsInTheFilesOwnSamples) {
  const Folder folder;
  write_signal(folder, "ok1.csv", 1324, 1);
  write_signal(folder, "ok2.csv", 1324, 2);
  std::string text;
  for (int i = 0; i < 6000; ++i) text += std::to_string(std::clamp(i * 7 % 101, 20, 80)) + "\n";
  folder.write("bad.csv", text);
  Description d = description();
  d.records[0].sample_rate_hz = 2000;
  const DatasetCheck found = check(d, folder.path());
  EXPECT_EQ(found.records[0].file_samples, 6000U);
  EXPECT_EQ(found.records[0].pieces, std::vector<std::size_t>{3000});
  EXPECT_EQ(found.records[0].length_s(), 3);
  EXPECT_GT(found.records[0].clipped.count, 0U);
}

/// Noise clipped at 2, with a spike. Its last quarter repeats its first, and its times jump.
TEST(Check, KeepsEachFlawOfASignal) {
  const Folder folder;
  write_signal(folder, "ok1.csv", 1324, 1);
  write_signal(folder, "ok2.csv", 1324, 2);
  Stream random("flaws");
  std::vector<double> samples;
  for (int i = 0; i < 4000; ++i) samples.push_back(std::min(random.normal(0, 1), 2.0));
  samples[1500] = -900;
  std::copy_n(samples.begin(), 1000, samples.begin() + 3000);
  std::string text;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i < 2000 ? i : i + 7) / 1000;
    text += std::to_string(t) + ',' + std::to_string(samples[i]) + '\n';
  }
  folder.write("bad.csv", text);
  Description d = description();
  d.records[0].variable = "2";
  const RecordCheck found = check(d, folder.path()).records[0];
  EXPECT_EQ(found.cut_tops.highest, 2);
  EXPECT_EQ(found.cut_tops.on_highest, static_cast<std::size_t>(std::ranges::count(samples, 2.0)));
  EXPECT_EQ(found.lone.farthest, 1500U);
  EXPECT_EQ(found.repeats.first, 3000U);
  EXPECT_EQ(found.repeats.longest, 1000U);
  EXPECT_EQ(found.files.at(0).times.missing, 7U);
  EXPECT_EQ(found.files.at(0).times.longest_after, 1999U);
  EXPECT_EQ(found.few_values, std::nullopt);
}

/// At 1 Hz the record lasts 47 minutes, and at half that rate more than an hour: 5642 s.
TEST(Check, DoesNotResampleARecordOfMoreThanAnHour) {
  const Folder folder;
  write_signal(folder, "ok1.csv", 1324, 1);
  write_signal(folder, "ok2.csv", 1324, 2);
  write_signal(folder, "bad.csv", 2821, 3);
  Description d = description();
  d.records[0].sample_rate_hz = 0.5;
  const DatasetCheck found = check(d, folder.path());
  EXPECT_EQ(found.exit, Exit::done);
  EXPECT_FALSE(found.records[0].level);
  EXPECT_EQ(found.records[0].pieces, std::vector<std::size_t>{5642000});
  EXPECT_GT(found.records[0].lines.front().hz, 0);
  EXPECT_FALSE(found.records[0].lines.front().db);
}

TEST(Check, ContinuesAfterAnUnreadableFile) {
  const Folder folder;
  write_signal(folder, "ok1.csv", 1324, 1);
  folder.write("ok2.csv", "1\nnan\n2\n");
  const Description d = description();
  const DatasetCheck found = check(d, folder.path());
  EXPECT_EQ(found.exit, Exit::bad_input);  // although a file is also missing
  EXPECT_NE(found.records[0].problem.find("no such file"), std::string::npos);
  EXPECT_EQ(found.records[1].problem, "");
  EXPECT_NE(found.records[2].problem.find("NaN"), std::string::npos) << found.records[2].problem;
  EXPECT_EQ(found.classes[0].stride, 0U);
}

TEST(Check, ReportsMissingInputOnlyForMissingFiles) {
  const Folder folder;
  EXPECT_EQ(check(description(), folder.path()).exit, Exit::input_missing);
}

TEST(Check, RefusesRecordsThatAreTooShortForAllWindows) {
  const Folder folder;
  write_signal(folder, "bad.csv", 1100, 3);
  write_signal(folder, "ok1.csv", 1324, 1);
  write_signal(folder, "ok2.csv", 1324, 2);
  const Description d = description();
  const DatasetCheck found = check(d, folder.path());
  EXPECT_EQ(found.exit, Exit::bad_input);
  EXPECT_NE(found.classes[1].problem.find("bad"), std::string::npos) << found.classes[1].problem;
}

}  // namespace
}  // namespace piae::inspection
