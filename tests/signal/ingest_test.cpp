#include "signal/ingest.hpp"

#include <gtest/gtest.h>

#include "base/sha256.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

Recordings ingest(const Description& description, const std::filesystem::path& data_dir) {
  Recordings all{description.info, {}};
  ingest(description, data_dir, [&](const Record& record) { all.records.push_back(record); });
  return all;
}

/// Returns two classes with one CSV each, written into the folder.
Description description_in(const Folder& folder) {
  folder.write("rig/a.csv", "1\n2\n3\n4\n");
  folder.write("rig/b.csv", "5\n6\n7\n8\n");
  Description d;
  d.info.name = "rig";
  d.info.sample_rate_hz = 1000;
  d.info.classes = {{"ok", Defect::none, 0}, {"bad", Defect::outer, 1}};
  d.records = {{"bad", 1, {"rig/b.csv"}, "1", 1000, 600, "", ""},
               {"ok", 0, {"rig/a.csv"}, "1", 1000, 600, "", ""}};
  return d;
}

TEST(Ingest, KeepsTheFactsOfEachRecord) {
  const Folder folder;
  Description d = description_in(folder);
  d.records[0].sha256 = sha256_of_file(folder / "rig/b.csv");
  const Recordings r = ingest(d, folder.path());
  ASSERT_EQ(r.records.size(), 2U);
  EXPECT_EQ(r.records[0].name, "bad");
  EXPECT_EQ(r.records[0].label, 1);
  EXPECT_EQ(r.records[0].source, "rig/b.csv");
  EXPECT_EQ(r.records[0].source_sha256, d.records[0].sha256);
  EXPECT_EQ(r.records[0].shaft_speed_rpm, 600);
  EXPECT_EQ(r.records[0].signal, (std::vector<double>{5, 6, 7, 8}));
  EXPECT_FALSE(r.records[0].parameters.has_value());
}

TEST(Ingest, ResamplesRecordsToTheRateOfTheDataset) {
  const Folder folder;
  Description d = description_in(folder);
  d.records[0].sample_rate_hz = 2000;
  const Recordings r = ingest(d, folder.path());
  EXPECT_EQ(r.records[0].signal.size(), 2U);
  EXPECT_EQ(r.records[0].original_sample_rate_hz, 2000);
  EXPECT_EQ(r.records[1].signal.size(), 4U);
}

TEST(Ingest, ScalesARecordWithItsOwnUnit) {
  const Folder folder;
  Description d = description_in(folder);
  d.info.unit_m_per_s2 = 2;
  d.records[0].unit_m_per_s2 = 0.5;
  d.records[0].offset = 4;
  const Recordings r = ingest(d, folder.path());
  EXPECT_EQ(r.records[0].signal, (std::vector<double>{0.25, 0.5, 0.75, 1}));  // (x - 4) / 4
  EXPECT_EQ(r.records[1].signal, (std::vector<double>{1, 2, 3, 4}));
}

/// Returns one record of three files, at twice the rate of the data set.
Description many_files_in(const Folder& folder) {
  Description d = description_in(folder);
  folder.write("run/acc_10.csv", "7\n9\n7\n9\n7\n9\n");
  folder.write("run/acc_2.csv", "1\n3\n1\n3\n");
  folder.write("run/acc_1.csv", "5\n6\n5\n6\n5\n6\n5\n6\n");
  d.records[0].files = {"run/acc_*.csv"};
  d.records[0].sample_rate_hz = 2000;
  return d;
}

TEST(Ingest, ReadsManyFilesAsOneRecordInNumericOrder) {
  const Folder folder;
  const Description d = many_files_in(folder);
  const Record record = ingest(d, folder.path()).records[0];
  EXPECT_EQ(record.pieces, (std::vector<std::size_t>{4, 2, 3}));
  ASSERT_EQ(record.signal.size(), 9U);
  EXPECT_EQ(record.source, "run/acc_*.csv");
  ASSERT_EQ(record.files.size(), 3U);
  EXPECT_EQ(record.files[0].name, "run/acc_1.csv");
  EXPECT_EQ(record.files[2].name, "run/acc_10.csv");
  EXPECT_EQ(record.files[2].sha256, sha256_of_file(folder / "run/acc_10.csv"));
  // Each file is resampled separately: its samples do not affect the next file.
  Description alone = d;
  alone.records[0].files = {"run/acc_10.csv"};
  const std::vector<double> last = ingest(alone, folder.path()).records[0].signal;
  EXPECT_EQ(std::vector<double>(record.signal.begin() + 6, record.signal.end()), last);
}

/// The files last 4, 2 and 3 ms.
TEST(Ingest, RefusesSnapshotsThatOverlap) {
  const Folder folder;
  Description d = many_files_in(folder);
  d.records[0].snapshot_interval_s = 0.004;
  EXPECT_EQ(ingest(d, folder.path()).records[0].snapshot_interval_s, 0.004);
  d.records[0].snapshot_interval_s = 0.0039;
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input,
               "file 1 of 3 lasts 0.004 s, but the next one starts 0.0039 s after it");
}

/// Compares with the output of `sha256sum run/acc_1.csv run/acc_2.csv run/acc_10.csv | sha256sum`.
TEST(Ingest, ChecksManyFilesByTheDigestOfTheirList) {
  const Folder folder;
  Description d = many_files_in(folder);
  std::string list;
  for (const char* name : {"run/acc_1.csv", "run/acc_2.csv", "run/acc_10.csv"}) {
    list += sha256_of_file(folder / name) + "  " + name + '\n';
  }
  d.records[0].sha256 = sha256_of_file(folder.write("list", list));
  EXPECT_EQ(ingest(d, folder.path()).records[0].source_sha256, d.records[0].sha256);
  folder.write("run/acc_2.csv", "1\n3\n1\n4\n");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input, "run/acc_*.csv (record bad): sha256 is ");
}

TEST(Ingest, NamesTheDamagedFileOfMany) {
  const Folder folder;
  Description d = many_files_in(folder);
  folder.write("run/acc_2.csv", "1\n3\nnan\n");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input,
               "run/acc_2.csv (record bad): 1 is NaN, infinite or beyond 32 bits at sample 2");
  folder.write("run/acc_2.csv", "1\n3\nx\n");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input, "run/acc_2.csv, line 3: ");
  folder.write("run/acc_2.csv", "");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input, "acc_2.csv: 1 holds no sample");
  d.records[0].files = {"run/acc_1.csv", "run/acc_3.csv"};
  EXPECT_ERROR(ingest(d, folder.path()), Exit::input_missing,
               "run/acc_3.csv: no such file; record bad");
  d.records[0].files = {"run/b*.csv"};
  EXPECT_ERROR(ingest(d, folder.path()), Exit::input_missing,
               "run/b*.csv: matches no file; record bad");
}

TEST(Ingest, AdvisesHowToGetAMissingFile) {
  const Folder folder;
  Description d = description_in(folder);
  std::filesystem::remove(folder / "rig/b.csv");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::input_missing,
               "rig/b.csv: no such file; record bad");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::input_missing, "`make data`");
  EXPECT_ERROR(ingest(d, folder.path()), Exit::input_missing, "DATA_DIR=");
}

TEST(Ingest, NamesBothDigestsIfTheyDiffer) {
  const Folder folder;
  Description d = description_in(folder);
  d.records[1].sha256 = std::string(64, '0');
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input,
               "sha256 is " + sha256_of_file(folder / "rig/a.csv") + ", expected 0000");
}

TEST(Ingest, RefusesUnusableSignals) {
  const Folder folder;
  const Description d = description_in(folder);
  const auto with = [&](const std::string& text) {
    folder.write("rig/a.csv", text);
    return ingest(d, folder.path());
  };
  EXPECT_ERROR(with("1\n2\nnan\n"), Exit::bad_input,
               "(record ok): 1 is NaN, infinite or beyond 32 bits at sample 2");
  EXPECT_ERROR(with("1\n-inf\n3\n"), Exit::bad_input, "beyond 32 bits at sample 1");
  EXPECT_ERROR(with("1\n2\n1e39\n"), Exit::bad_input, "beyond 32 bits at sample 2");
  EXPECT_ERROR(with(""), Exit::bad_input, "a.csv: 1 holds no sample");
  EXPECT_ERROR(with("2\n2\n2\n"), Exit::bad_input, "never changes");
}

TEST(Ingest, RefusesOneRecordingUnderTwoClasses) {
  const Folder folder;
  const Description d = description_in(folder);
  folder.write("rig/a.csv", "5.0\n6.0\n7\n8\n");  // other bytes, the same samples
  EXPECT_ERROR(
      ingest(d, folder.path()), Exit::bad_input,
      "(record ok): holds the same samples as record bad (rig/b.csv), but has another class");
}

TEST(Ingest, RefusesOneRecordingTwice) {
  const Folder folder;
  Description d = description_in(folder);
  d.records.insert(d.records.begin() + 1, d.records[0]);
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input, "name each recording once");
}

TEST(Ingest, RefusesARecordThatWouldFillTheMemory) {
  const Folder folder;
  Description d = description_in(folder);
  d.records[0].sample_rate_hz = 1e-9;
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input,
               "rig/b.csv (record bad): would have more than 1e8 samples");
}

TEST(Ingest, RefusesARecordThatIsEmptyAfterResampling) {
  const Folder folder;
  Description d = description_in(folder);
  d.records[0].sample_rate_hz = 5000;
  EXPECT_ERROR(ingest(d, folder.path()), Exit::bad_input, "shorter than one sample");
}

}  // namespace
}  // namespace piae::signal
