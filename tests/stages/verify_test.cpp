#include <gtest/gtest.h>

#include <algorithm>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "stages/doctor.hpp"
#include "stages/tiny.hpp"

/// Exit codes of verify: a bit for each reason.
namespace piae::stages {
namespace {

class Verify : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("train"); }

  void expect_status(const std::vector<std::string>& files, int status, std::size_t lines) const {
    const Outcome outcome = tiny_.run("verify", files);
    EXPECT_EQ(outcome.status, status) << outcome.out;
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(outcome.out, '\n')), lines)
        << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
  void write_damaged(const std::string& name) const {
    std::string bytes = bytes_of(tiny_ / "A.h5");
    const std::size_t middle = bytes.size() / 2;
    bytes[middle] = static_cast<char>(bytes[middle] ^ 1);
    tiny_.write(name, bytes);
  }
  /// Writes HDF5 that no stage wrote.
  void write_foreign(const std::string& name) const {
    const artefact::hdf5::Handle file(
        H5Fcreate((tiny_ / name).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), "create");
  }
  /// Writes a window set without its required content.
  void write_hollow(const std::string& name) const {
    artefact::Writer writer("windows");
    writer.attribute("/", "role", std::string("A"));
    writer.save(tiny_ / name, {"test", "", {}});
  }
  /// Replaces the first window of C by that of A.
  void make_a_window_play_two_roles() const {
    std::vector<std::int32_t> record = artefact::Reader(tiny_ / "A.h5", "windows")
                                           .numbers<std::int32_t>("/record/index", {0})
                                           .values;
    std::vector<std::int64_t> first = artefact::Reader(tiny_ / "A.h5", "windows")
                                          .numbers<std::int64_t>("/first_sample", {0})
                                          .values;
    doctor(tiny_ / "C.h5", [&](hid_t file) {
      change_numbers<std::int32_t>(file, "/record/index",
                                   [&](auto& values) { values.front() = record.front(); });
      change_numbers<std::int64_t>(file, "/first_sample",
                                   [&](auto& values) { values.front() = first.front(); });
    });
  }

  Tiny tiny_;
};

// Lack of memory is not an error of a file.
TEST_F(Verify, ReportsALackOfMemory) {
  fs::copy_file(tiny_ / "A.h5", tiny_ / "large.h5");
  fs::resize_file(tiny_ / "large.h5", 2'000'000'000);
  Surroundings small;
  small.most_memory = 1'000'000'000;
  expect_refusal(run(tiny_.path(), "verify", {"large.h5"}, small), "verify", 1, {"out of memory"});
  fs::resize_file(tiny_ / "large.h5", 12'000'000'000);
  expect_status({"large.h5"}, 1, 1);
}

TEST_F(Verify, IsSilentAboutGoodArtefacts) {
  expect_status({"records.h5", "A.h5", "B.h5", "C.h5", "D.h5"}, 0, 0);
}

TEST_F(Verify, HasABitForEachReason) {
  tiny_.write("text.h5", "not HDF5");
  write_damaged("damaged.h5");
  write_foreign("foreign.h5");
  write_hollow("hollow.h5");
  expect_status({"nowhere.h5"}, 1, 1);
  expect_status({"text.h5"}, 1, 1);
  expect_status({"."}, 1, 1);
  expect_status({"damaged.h5"}, 4, 1);
  expect_status({"foreign.h5"}, 8, 1);
  expect_status({"hollow.h5"}, 16, 1);
  expect_status({"A.h5", "nowhere.h5", "damaged.h5", "text.h5"}, 1 + 4, 3);
  expect_status({"foreign.h5", "hollow.h5", "damaged.h5", "nowhere.h5"}, 1 + 4 + 8 + 16, 4);
}

TEST_F(Verify, RefusesUnknownKindsAndSchemas) {
  artefact::Writer("cake").save(tiny_ / "cake.h5", {"test", "", {}});
  expect_status({"cake.h5"}, 8, 1);
  doctor(tiny_ / "B.h5", [](hid_t file) {
    H5Adelete_by_name(file, "/", "schema", H5P_DEFAULT);
    const std::int64_t next = artefact::schema_version + 1;
    artefact::hdf5::write_attribute(file, "/", "schema",
                                    artefact::hdf5::stored_type<std::int64_t>(), &next);
  });
  expect_status({"B.h5"}, 8, 1);
}

// U+009B begins a command as ESC [ does, and U+202E reverses the following text.
TEST_F(Verify, AndTheStagesPrintNoTerminalCommands) {
  for (const std::string command : {"\xC2\x9B"
                                    "2J",
                                    "\x1B[2J", "\xE2\x80\xAE", "\xFF"}) {
    const std::string name = "a" + command + ".h5";
    const Outcome verified = tiny_.run("verify", {name});
    EXPECT_EQ(verified.status, 1);
    EXPECT_TRUE(verified.out.starts_with("a?")) << testing::PrintToString(verified.out);
    expect_refusal(tiny_.run("split", {"--records", name, "--seed", "0", "--output-dir", "x"}),
                   "split", 66, {"a?"});
    artefact::Writer("cake" + command).save(tiny_ / "cake.h5", {"test", "", {}});
    EXPECT_EQ(tiny_.run("verify", {"cake.h5"}).out.find(command), std::string::npos);
  }
}

TEST_F(Verify, LimitsTheLengthOfLines) {
  artefact::Writer(std::string(60'000, 'x')).save(tiny_ / "long.h5", {"test", "", {}});
  const Outcome verified = tiny_.run("verify", {"long.h5"});
  EXPECT_EQ(verified.status, 8);
  EXPECT_TRUE(is_one_line(verified.out));
  EXPECT_LT(verified.out.size(), 1100U);
  const Outcome split =
      tiny_.run("split", {"--records", "long.h5", "--seed", "0", "--output-dir", "x"});
  expect_refusal(split, "split", 65, {"long.h5", "..."});
  EXPECT_LT(split.err.size(), 1100U);
}

TEST_F(Verify, FindsAWindowWithTwoRoles) {
  make_a_window_play_two_roles();
  expect_status({"A.h5", "B.h5"}, 0, 0);
  expect_status({"A.h5", "B.h5", "C.h5", "D.h5"}, 32, 1);
  expect_status({"A.h5", "C.h5", "nowhere.h5"}, 32 + 1, 2);
  expect_refusal(tiny_.run("diagnose", chain()[5].arguments), "diagnose", 65, {"share a window"});
}

TEST_F(Verify, FindsRolesOfDifferentRecords) {
  doctor(tiny_ / "C.h5",
         [](hid_t file) { replace_attribute(file, "/", "records_digest", std::string(64, '0')); });
  expect_status({"A.h5", "C.h5"}, 32, 1);
}

}  // namespace
}  // namespace piae::stages
