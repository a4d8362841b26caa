#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "artefact/writer.hpp"
#include "stages/doctor.hpp"
#include "stages/tiny.hpp"
#include "support/harmful_files.hpp"

/// Behaviour of stages with unusable inputs.
namespace piae::stages {
namespace {

/// An input of a stage: its option, and its file in the tiny chain.
struct Input {
  const char* stage;
  const char* option;
  const char* file;
  const char* kind;  ///< required kind
};

/// Prints the name for GoogleTest.
void PrintTo(const Input& input, std::ostream* out) { *out << input.stage << ' ' << input.option; }

std::string name_of(const testing::TestParamInfo<Input>& info) {
  std::string option = info.param.option;
  return std::string(info.param.stage) + '_' + option.substr(2);
}

class Inputs : public testing::TestWithParam<Input> {
 protected:
  void SetUp() override { tiny_.run_chain_before(GetParam().stage); }

  /// Expects that the stage refuses the file in the input's place, and leaves nothing behind.
  void expect_refused(const std::string& file, int status, std::vector<std::string> words) {
    SCOPED_TRACE(file);
    const std::set<std::string> before = tiny_.files();
    const std::string stage = GetParam().stage;
    words.push_back(file);
    expect_refusal(tiny_.run(stage, with(step_of(stage).arguments, GetParam().option, file)), stage,
                   status, words);
    EXPECT_EQ(tiny_.files(), before);
  }
  void expect_bytes_refused(const std::string& file, const std::string& bytes) {
    write_bytes(tiny_ / file, bytes);
    expect_refused(file, 65, {});
  }

  Tiny tiny_;
};

TEST_P(Inputs, AreRefusedIfUnusable) {
  expect_refused("nowhere.h5", 66, {"No such file"});
  fs::create_directory(tiny_ / "folder.h5");
  expect_refused("folder.h5", 66, {"not a file"});
  ASSERT_EQ(::mkfifo((tiny_ / "pipe.h5").c_str(), 0600), 0);
  expect_refused("pipe.h5", 66, {"not a file"});

  const std::string good = bytes_of(tiny_ / GetParam().file);
  expect_bytes_refused("empty.h5", "");
  expect_bytes_refused("text.h5", "a,b\n1,2\n");
  expect_bytes_refused("half.h5", good.substr(0, good.size() / 2));
  expect_bytes_refused("shorter.h5", good.substr(0, good.size() / 4 * 3));
  std::string flipped = good;
  const std::size_t middle = good.size() / 2;
  flipped[middle] = static_cast<char>(flipped[middle] ^ 1);
  expect_bytes_refused("flipped.h5", flipped);

  const bool wants_records = GetParam().kind == std::string("records");
  const std::string other = wants_records ? "diagnosis" : "records";
  if (wants_records) {
    artefact::Writer(other).save(tiny_ / "diagnosis.h5", {"test", "", {}});
  }
  expect_refused(other + ".h5", 65, {"'" + other + "'", "'" + std::string(GetParam().kind) + "'"});
}

INSTANTIATE_TEST_SUITE_P(Stages, Inputs,
                         testing::Values(Input{"split", "--records", "records.h5", "records"},
                                         Input{"train", "--known", "C.h5", "windows"},
                                         Input{"generate", "--model", "model.h5", "model"},
                                         Input{"score", "--generated", "E.h5", "windows"},
                                         Input{"score", "--real", "D.h5", "windows"},
                                         Input{"diagnose", "--normal", "B.h5", "windows"}),
                         name_of);

/// For the other options of diagnose it suffices to test that they are checked.
TEST(InputsOfDiagnose, AreEachRefused) {
  const Tiny tiny;
  tiny.run_chain_before("score");
  const Arguments& good = step_of("diagnose").arguments;
  const std::set<std::string> before = tiny.files();
  for (const std::string option : {"--test", "--known", "--generated"}) {
    SCOPED_TRACE(option);
    expect_refusal(tiny.run("diagnose", with(good, option, "no.h5")), "diagnose", 66, {"no.h5"});
    expect_refusal(tiny.run("diagnose", with(good, option, "D.h5")), "diagnose", 65,
                   {"D.h5", "role D"});
  }
  expect_refusal(tiny.run("diagnose", with(good, "--ratio", "1to1")), "diagnose", 65,
                 {"495", "--count", "IR007"});
  EXPECT_EQ(tiny.files(), before);
}

TEST(InputsOfTrain, OnlyKnownWindowsAreAccepted) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const std::set<std::string> before = tiny.files();
  for (const std::string role : {"A", "B", "D"}) {
    expect_refusal(tiny.run("train", with(step_of("train").arguments, "--known", role + ".h5")),
                   "train", 65, {role + ".h5", "role " + role});
  }
  EXPECT_EQ(tiny.files(), before);
}

TEST(InputsOfTabulate, EveryMissingOrDamagedCellIsNamed) {
  const Tiny tiny;
  tiny.run_chain_before("tabulate");
  const std::string score = "run/tiny/seed0/piae-dt/score.h5";
  const std::string diagnosis = "run/tiny/seed0/none/100to1/wdcnn/diagnosis.h5";
  const std::string bytes = bytes_of(tiny / diagnosis);
  fs::remove(tiny / score);
  write_bytes(tiny / diagnosis, bytes.substr(0, bytes.size() / 2));
  const Outcome outcome = tiny.run_step("tabulate");
  EXPECT_EQ(outcome.status, 65);
  EXPECT_NE(outcome.err.find("method piae-dt, seed 0: " + score), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("method none, ratio 100to1, seed 0: " + diagnosis), std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(tiny / "run/tiny/accuracy.csv"));

  write_bytes(tiny / diagnosis, bytes);
  EXPECT_EQ(tiny.run_step("tabulate").status, 66);
  fs::copy_file(tiny / diagnosis, tiny / score);
  EXPECT_EQ(tiny.run_step("tabulate").status, 65);  // another kind instead of the score
  EXPECT_FALSE(fs::exists(tiny / "run/tiny/accuracy.csv"));
}

TEST(Content, NaNUnderGoodDigestsIsRefused) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  doctor(tiny / "C.h5", [](hid_t file) {
    change_numbers<float>(file, "/windows", [](auto& values) { values[7] = std::nanf(""); });
  });
  expect_refusal(tiny.run_step("train"), "train", 65, {"C.h5", "/windows", "NaN"});
  const Outcome verified = tiny.run("verify", {"C.h5"});
  EXPECT_EQ(verified.status, 16) << verified.out;
}

TEST(Content, EmptyClassIsNamed) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  doctor(tiny / "C.h5", [](hid_t file) {
    change_numbers<std::int32_t>(file, "/labels",
                                 [](auto& labels) { std::ranges::fill(labels, 1); });
  });
  expect_refusal(tiny.run_step("train"), "train", 65, {"C.h5", "OR021"});
  expect_refusal(tiny.run("diagnose", chain()[5].arguments), "diagnose", 65, {"--known", "OR021"});
  EXPECT_EQ(tiny.run("verify", {"C.h5"}).status, 16);
}

TEST(Content, TooManyWindowsAreRefusedWithThePossibleNumber) {
  const Tiny tiny;
  tiny.run_chain_before("split");
  const std::set<std::string> before = tiny.files();
  // At stride 1, two records of 6000 samples hold 4977 windows each.
  expect_refusal(tiny.run("split", with(step_of("split").arguments, "--windows-per-class", "9955")),
                 "split", 65, {"Normal", "9954"});
  EXPECT_EQ(tiny.files(), before);
}

/// Returns a description of two CSV recordings for ingest.
std::string raw_description(const std::string& more = "") {
  return described_bearing("tiny") + described_normal + described_ir007 +
         R"([[record]]
class = "Normal"
file = "normal.csv"
variable = "acceleration"
sample_rate_hz = 12000
[[record]]
class = "IR007"
file = "inner.csv"
variable = "acceleration"
sample_rate_hz = 12000
)" + more;
}

std::string csv(double scale, const std::string& last = "0.5") {
  std::string text = "acceleration\n";
  for (int i = 0; i < 100; ++i) text += std::to_string(scale * std::sin(0.3 * i)) + '\n';
  return text + last + '\n';
}

class Ingest : public testing::Test {
 protected:
  Ingest() {
    folder_.write("raw.toml", raw_description());
    folder_.write("data/normal.csv", csv(1));
    folder_.write("data/inner.csv", csv(2));
  }
  [[nodiscard]] Outcome run() const { return folder_.run("ingest", arguments_); }
  void expect_refused(int status, const std::vector<std::string>& words) const {
    const std::set<std::string> before = folder_.files();
    expect_refusal(run(), "ingest", status, words);
    EXPECT_EQ(folder_.files(), before);
  }

  Tiny folder_;
  Arguments arguments_{"--description", "raw.toml", "--data-dir", "data", "--output", "out.h5"};
};

TEST_F(Ingest, MakesRecordsThatVerify) {
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(is_one_line(outcome.out)) << outcome.out;
  EXPECT_EQ(folder_.run("verify", {"out.h5"}).status, 0);
}

TEST_F(Ingest, RefusesNaN) {
  folder_.write("data/inner.csv", csv(2, "nan"));
  expect_refused(65, {"inner.csv", "NaN", "100"});
}

TEST_F(Ingest, RefusesTextThatIsNotANumber) {
  folder_.write("data/inner.csv", csv(2, "broken"));
  expect_refused(65, {"inner.csv", "line 102", "broken"});
}

TEST_F(Ingest, RefusesOneRecordingUnderTwoClasses) {
  folder_.write("data/inner.csv", csv(1));
  expect_refused(65, {"inner.csv", "normal.csv"});
}

TEST_F(Ingest, RefusesAWrongDigest) {
  folder_.write("raw.toml", raw_description("sha256 = \"" + std::string(64, '0') + "\"\n"));
  expect_refused(65, {"inner.csv", "sha256"});
}

TEST_F(Ingest, NamesTheMissingFile) {
  fs::remove(folder_ / "data/inner.csv");
  expect_refused(66, {"data/inner.csv", "IR007"});
}

TEST_F(Ingest, RefusesFilesWithAWrongExtension) {
  folder_.write("raw.toml", raw_description());
  for (const std::string name : {"data/inner.mat", "data/inner.h5", "data/inner.png"}) {
    std::string description = raw_description();
    const std::string file = fs::path(name).filename().string();
    description.replace(description.find("inner.csv"), 9, file);
    folder_.write("raw.toml", description);
    folder_.write(name, "not what the name says");
    expect_refused(65, {file});
  }
}

TEST_F(Ingest, RefusesRecordingsAndDescriptionsThatArePipes) {
  fs::remove(folder_ / "data/inner.csv");
  ASSERT_EQ(::mkfifo((folder_ / "data/inner.csv").c_str(), 0600), 0);
  expect_refused(66, {"data/inner.csv", "is not a file"});
  fs::remove(folder_ / "raw.toml");
  ASSERT_EQ(::mkfifo((folder_ / "raw.toml").c_str(), 0600), 0);
  expect_refused(66, {"raw.toml", "not a file"});
}

// Another program runs the reading libraries. Neither its files nor its messages may remain.
TEST_F(Ingest, RefusesARecordingThatClaimsTooMuchData) {
  std::string description = raw_description();
  description.replace(description.find("inner.csv"), 9, "inner.mat");
  description.replace(description.rfind("acceleration"), 12, "x");
  folder_.write("raw.toml", description);
  folder_.write("data/inner.mat", harmful::claiming_v5());
  expect_refused(65, {"data/inner.mat", "variable x declares 2147483647 values"});
  arguments_ = {"--check", "--description", "raw.toml", "--data-dir", "data"};
  const Outcome check = run();
  EXPECT_EQ(check.status, 65);
  EXPECT_NE(check.out.find("data/inner.mat: variable x declares"), std::string::npos) << check.out;
}

TEST_F(Ingest, RefusesAMissingDamagedOrForeignDescription) {
  folder_.write("raw.toml", "name = \n");
  expect_refused(65, {"raw.toml", "line"});
  folder_.write("raw.toml", raw_description("colour = 3\n"));
  expect_refused(65, {"raw.toml", "colour"});
  fs::remove(folder_ / "raw.toml");
  expect_refused(66, {"raw.toml"});
}

// Sparse files take no disk space, but reading them would take all memory, or minutes.
TEST_F(Ingest, RefusesFilesThatClaimToBeHuge) {
  fs::resize_file(folder_ / "data/inner.csv", 12'000'000'000);
  expect_refused(65, {"data/inner.csv", "is larger than 4000 MB"});
  fs::resize_file(folder_ / "raw.toml", 12'000'000'000);
  expect_refused(65, {"raw.toml", "is larger than 1 MB"});
  expect_refusal(folder_.run("simulate", {"--description", "raw.toml", "--output", "out.h5"}),
                 "simulate", 65, {"raw.toml", "is larger than 1 MB"});
}

// The variable becomes an argument of another program.
TEST_F(Ingest, RefusesAnEndlessVariable) {
  std::string description = raw_description();
  description.replace(description.find("acceleration"), 12, std::string(500'000, 'v'));
  folder_.write("raw.toml", description);
  expect_refused(65, {"raw.toml", "variable", "at most 1000"});
}

TEST(Simulate, RefusesADescriptionThatCannotBeSimulated) {
  const Tiny tiny;
  const auto expect_refused = [&](const std::string& description, const std::string& word) {
    tiny.write("tiny.toml", description);
    expect_refusal(tiny.run_step("simulate"), "simulate", 65, {"tiny.toml", word});
    EXPECT_EQ(tiny.files(), std::set<std::string>{"tiny.toml"});
  };
  expect_refused(raw_description(), "simulation");
  expect_refused(tiny_description + "colour = 3\n", "colour");
  expect_refused(tiny_description.substr(0, 40), "tiny.toml");
  fs::remove(tiny / "tiny.toml");
  expect_refusal(tiny.run_step("simulate"), "simulate", 66, {"tiny.toml"});
  ASSERT_EQ(::mkfifo((tiny / "tiny.toml").c_str(), 0600), 0);
  expect_refusal(tiny.run_step("simulate"), "simulate", 66, {"tiny.toml", "is not a file"});
}

// Windows of another split's C may be in this split's A or D.
TEST(InputsOfDiagnoseAndScore, GeneratorOfAnotherSplitIsRefused) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  Arguments other_split = step_of("split").arguments;
  other_split = with(with(other_split, "--seed", "1"), "--output-dir", "other");
  ASSERT_EQ(tiny.run("split", other_split).status, 0);
  ASSERT_EQ(tiny.run("train", with(step_of("train").arguments, "--known", "other/C.h5")).status, 0);
  ASSERT_EQ(tiny.run_step("generate").status, 0);
  expect_refusal(tiny.run_step("diagnose"), "diagnose", 65, {"E.h5", "C.h5", "learned from"});
  expect_refusal(tiny.run_step("score"), "score", 65, {"E.h5", "D.h5", "another split"});
}

}  // namespace
}  // namespace piae::stages
