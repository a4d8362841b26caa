// Tests on the real recordings, if the environment variable DATA_DIR is set. The descriptions are
// those of pipeline/datasets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "signal/ingest.hpp"
#include "signal/split.hpp"

namespace piae::signal {
namespace {

namespace fs = std::filesystem;
using testing::Each;
using testing::ElementsAre;

const fs::path descriptions =
    fs::path(__FILE__).parent_path().parent_path().parent_path() / "pipeline" / "datasets";

Description description_of(const std::string& dataset) {
  return read_description(descriptions / (dataset + ".toml"));
}

/// Returns the folder of the recordings; empty if they are missing.
fs::path data_dir_with(const Description& description) {
  const char* folder = std::getenv("DATA_DIR");
  if (folder == nullptr || *folder == '\0') return {};
  for (const RecordSource& source : description.records) {
    if (!fs::exists(fs::path(folder) / source.file_text())) return {};
  }
  return folder;
}

double rms(const std::vector<double>& x) {
  return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0) /
                   static_cast<double>(x.size()));
}

const Record& record_of(const Recordings& recordings, const std::string& name) {
  return *std::ranges::find(recordings.records, name, &Record::name);
}

#define NEED_RECORDINGS(description)                    \
  const fs::path data_dir = data_dir_with(description); \
  if (data_dir.empty()) GTEST_SKIP() << "DATA_DIR does not have the recordings"

TEST(RealDescriptions, MatchThePaper) {
  const Description cwru = description_of("cwru");
  EXPECT_EQ(cwru.info.classes.size(), 10U);
  EXPECT_EQ(cwru.records.size(), 10U);
  EXPECT_EQ(cwru.info.classes.front().name, "Normal");
  for (const ClassInfo& c : cwru.info.classes) {
    const double mil = c.name == "Normal" ? 0 : std::stod(c.name.substr(c.name.size() - 2));
    EXPECT_NEAR(c.defect_size_mm, mil * 0.0254, 1e-12) << c.name;
  }
  for (const std::string dataset : {"hit-sm", "hfhp"}) {
    const Description d = description_of(dataset);
    EXPECT_EQ(d.info.classes.size(), 7U);
    EXPECT_EQ(d.info.sample_rate_hz, 12000);
  }
}

TEST(RealDescriptions, DifferForCwruAsPublishedOnlyInTheRateOf97) {
  const Description right = description_of("cwru");
  const Description published = description_of("cwru-as-published");
  for (std::size_t i = 0; i < right.records.size(); ++i) {
    const bool is_97 = right.records[i].file_text() == "cwru/97.mat";
    EXPECT_EQ(right.records[i].sha256, published.records[i].sha256);
    EXPECT_EQ(right.records[i].sample_rate_hz, is_97 ? 48000 : 12000);
    EXPECT_EQ(published.records[i].sample_rate_hz, 12000);
  }
}

TEST(Cwru, HasTheRecordsOfThePaper) {
  const Description description = description_of("cwru");
  NEED_RECORDINGS(description);
  const Recordings r = ingest(description, data_dir);
  ASSERT_EQ(r.records.size(), 10U);
  EXPECT_EQ(record_of(r, "IR007").signal.size(), 121265U);
  EXPECT_EQ(record_of(r, "B007").signal.size(), 122571U);
  EXPECT_EQ(record_of(r, "Normal").signal.size(), 60984U);  // 243938 / 4
  // RMS in g. The notes on the paper give 0.29 for IR007 (all zeros against real windows).
  EXPECT_NEAR(rms(record_of(r, "IR007").signal), 0.292, 0.003);
  const Recordings raw = ingest(description_of("cwru-as-published"), data_dir);
  EXPECT_EQ(record_of(raw, "Normal").signal.size(), 243938U);
  EXPECT_EQ(record_of(raw, "IR007").signal, record_of(r, "IR007").signal);
  EXPECT_LE(rms(record_of(r, "Normal").signal), rms(record_of(raw, "Normal").signal));
}

TEST(Cwru, IsSplitAtStridesOfAbout200And100) {
  const Description description = description_of("cwru");
  NEED_RECORDINGS(description);
  const Split s = split(ingest(description, data_dir), {});
  // (n - 1024) / 599 of 60984, 121265, 122571, 121991, 121846, 121846, 121846, 122136, ...
  EXPECT_THAT(s.strides, ElementsAre(100, 200, 202, 201, 201, 201, 201, 202, 201, 202));
  EXPECT_EQ(s.sets[0].size(), 1000U);
  EXPECT_EQ(s.sets[1].size(), 500U);
  EXPECT_EQ(s.sets[2].size(), 45U);
  EXPECT_EQ(s.sets[3].size(), 4455U);
}

TEST(HitSm, IsIngestedAndSplitAtStride100) {
  const Description description = description_of("hit-sm");
  NEED_RECORDINGS(description);
  const Recordings r = ingest(description, data_dir);
  ASSERT_EQ(r.records.size(), 7U);
  for (const Record& record : r.records) EXPECT_EQ(record.signal.size(), 61440U) << record.name;
  EXPECT_THAT(split(r, {}).strides, Each(100));
}

}  // namespace
}  // namespace piae::signal
