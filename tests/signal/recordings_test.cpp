#include "signal/recordings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "signal/counting.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::signal {
namespace {

std::filesystem::path save(const Folder& folder, const Recordings& recordings) {
  artefact::Writer writer("records");
  write(writer, recordings);
  writer.save(folder / "records.h5", {});
  return folder / "records.h5";
}

Recordings load(const std::filesystem::path& file) {
  return read_recordings(artefact::Reader(file, "records"));
}

TEST(Recordings, AreReadBack) {
  const Folder folder;
  Recordings in = counting_recordings(10);
  in.info.unit_m_per_s2 = 9.80665;
  in.records[3].parameters = DynamicParameters{1e8, 500};
  in.records[2].source = "rig/a.mat";
  in.records[2].source_sha256 = std::string(64, 'a');
  const Recordings out = load(save(folder, in));
  EXPECT_EQ(out.info.name, "counting");
  EXPECT_EQ(out.info.unit_m_per_s2, 9.80665);
  ASSERT_EQ(out.info.classes.size(), 3U);
  EXPECT_EQ(out.info.classes[2].defect, Defect::roller);
  ASSERT_EQ(out.records.size(), in.records.size());
  for (std::size_t i = 0; i < in.records.size(); ++i) {
    EXPECT_EQ(out.records[i].name, in.records[i].name);
    EXPECT_EQ(out.records[i].label, in.records[i].label);
    EXPECT_EQ(out.records[i].signal, in.records[i].signal);
    EXPECT_EQ(out.records[i].source, in.records[i].source);
    EXPECT_EQ(out.records[i].source_sha256, in.records[i].source_sha256);
    EXPECT_EQ(out.records[i].original_sample_rate_hz, 12000);
    EXPECT_EQ(out.records[i].shaft_speed_rpm, 1797);
    EXPECT_EQ(out.records[i].parameters.has_value(), i == 3);
  }
  EXPECT_EQ(out.records[3].parameters->stiffness_n_per_m, 1e8);
  EXPECT_EQ(out.records[3].parameters->damping_ns_per_m, 500);
}

TEST(Recordings, AreReadBackWithPieces) {
  const Folder folder;
  Recordings in = counting_recordings(10);
  in.records[2].pieces = {3, 7};
  in.records[3].pieces = {10};
  const Recordings out = load(save(folder, in));
  EXPECT_EQ(out.records[2].pieces, (std::vector<std::size_t>{3, 7}));
  EXPECT_EQ(out.records[2].piece_lengths(), (std::vector<std::size_t>{3, 7}));
  EXPECT_EQ(out.records[3].pieces, std::vector<std::size_t>{});  // a single piece is not stored
  EXPECT_EQ(out.records[3].piece_lengths(), std::vector<std::size_t>{10});
  for (const std::vector<std::size_t>& wrong :
       {std::vector<std::size_t>{3, 6}, {3, 8}, {0, 10}, {11, 1}}) {
    in.records[2].pieces = wrong;
    EXPECT_ERROR(load(save(folder, in)), Exit::bad_input,
                 "/pieces/N holds lengths of pieces that do not add up to the record");
  }
}

TEST(Recordings, AreReadBackWithSpeedsOverTime) {
  const Folder folder;
  Recordings in = counting_recordings(600);  // 0.05 s
  in.records[2].speeds = SpeedCourse{.block_s = 0.02, .rpm = {1500, 1510, 1530}};
  const auto load_again = [&] { return load(save(folder, in)); };
  const Recordings out = load_again();
  ASSERT_TRUE(out.records[2].speeds);
  EXPECT_EQ(out.records[2].speeds->block_s, 0.02);
  EXPECT_EQ(out.records[2].speeds->rpm, in.records[2].speeds->rpm);
  EXPECT_FALSE(out.records[3].speeds);
  EXPECT_FALSE(artefact::Reader(folder / "records.h5", "records").has("/speeds/R"));
  in.records[2].speeds->rpm[1] = 0;
  EXPECT_ERROR(load_again(), Exit::bad_input, "/speeds/N");
  in.records[2].speeds->rpm = {1500};
  EXPECT_ERROR(load_again(), Exit::bad_input,
               "/speeds/N holds 1 blocks of 0.02 s, but the record lasts 0.05 s");
  in.records[2].speeds->rpm = {};
  EXPECT_ERROR(load_again(), Exit::bad_input, "/speeds/N");
  in.records[2].speeds = SpeedCourse{.block_s = 0, .rpm = {1500}};
  EXPECT_ERROR(load_again(), Exit::bad_input, "block_s");
}

TEST(Recordings, HaveSpeedsOfTheirOwnBeyondOnePercent) {
  Recordings recordings = counting_recordings(10);
  recordings.records[1].shaft_speed_rpm = 1797 * 1.009;
  EXPECT_FALSE(recordings.have_speeds());
  recordings.records[1].shaft_speed_rpm = 1797 * 0.98;
  EXPECT_TRUE(recordings.have_speeds());
  recordings = counting_recordings(10);
  recordings.records[0].speeds = SpeedCourse{.block_s = 0.02, .rpm = {1797}};
  EXPECT_TRUE(recordings.have_speeds());
}

TEST(Recordings, AreReadBackWithTheIntervalOfSnapshots) {
  const Folder folder;
  Recordings in = counting_recordings(10);
  in.records[2].pieces = {3, 7};
  in.records[2].snapshot_interval_s = 100;
  const Recordings out = load(save(folder, in));
  EXPECT_EQ(out.records[2].snapshot_interval_s, 100);
  EXPECT_EQ(out.records[3].snapshot_interval_s, std::nullopt);
  in.records[2].snapshot_interval_s = 0;
  EXPECT_ERROR(load(save(folder, in)), Exit::bad_input, "snapshot_interval_s");
}

TEST(Recordings, AreReadBackWithConditionsAndSizes) {
  const Folder folder;
  Recordings in = counting_transfer(10);
  in.records[2].defect_size_mm = 0.3;
  in.records[5].condition = every_condition;
  const Recordings out = load(save(folder, in));
  EXPECT_EQ(out.info.conditions, in.info.conditions);
  ASSERT_EQ(out.records.size(), 6U);
  for (const Record& record : out.records) {
    const auto same = std::ranges::find(in.records, record.name, &Record::name);
    EXPECT_EQ(record.condition, same->condition);
    EXPECT_EQ(record.defect_size_mm, same->defect_size_mm);
  }
  EXPECT_TRUE(out.have_sizes());
  EXPECT_FALSE(load(save(folder, counting_transfer(10))).have_sizes());
}

TEST(Recordings, AreRefusedWithAnUnlistedCondition) {
  const Folder folder;
  artefact::Writer writer("records");
  write(writer, counting_recordings(10).info);
  writer.group("/records");
  writer.numbers("/records/N", std::vector<double>{1, 2});
  writer.attribute("/records/N", "label", std::int64_t{0});
  writer.attribute("/records/N", "original_sample_rate_hz", 12000.0);
  writer.attribute("/records/N", "shaft_speed_rpm", 900.0);
  writer.attribute("/records/N", "condition", std::string("900 rpm"));
  writer.save(folder / "records.h5", {});
  EXPECT_ERROR(load(folder / "records.h5"), Exit::bad_input,
               "/records/N has a condition that is not listed");
}

TEST(Recordings, AreRefusedIfAClassHasNoRecord) {
  const Folder folder;
  Recordings r = counting_recordings(10);
  r.records.pop_back();
  EXPECT_ERROR(load(save(folder, r)), Exit::bad_input, "/records has no record of class R");
}

TEST(Recordings, AreRefusedWithAnUnknownLabel) {
  const Folder folder;
  for (const int label : {3, -1}) {
    Recordings r = counting_recordings(10);
    r.records[3].label = label;
    EXPECT_ERROR(load(save(folder, r)), Exit::bad_input, "/records/R has label");
  }
}

TEST(Recordings, AreRefusedWithAnEmptySignal) {
  const Folder folder;
  Recordings r = counting_recordings(10);
  r.records[3].signal.clear();
  EXPECT_ERROR(load(save(folder, r)), Exit::bad_input, "/records/R holds no sample");
}

TEST(Recordings, AreNotWrittenWithANaN) {
  const Folder folder;
  Recordings r = counting_recordings(10);
  r.records[0].signal[2] = std::nan("");
  EXPECT_ERROR(save(folder, r), Exit::failed, "/records/I-01: value 2 is NaN");
  EXPECT_FALSE(std::filesystem::exists(folder / "records.h5"));
}

}  // namespace
}  // namespace piae::signal
