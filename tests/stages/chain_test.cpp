#include <gtest/gtest.h>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

using artefact::Reader;

/// Expects the same bytes from the same commands in another folder.
void expect_same_bytes_elsewhere(const Tiny& tiny) {
  const fs::path other = tiny / "a longer path" / "with spaces";
  fs::create_directories(other);
  write_bytes(other / "tiny.toml", tiny_description);
  for (const Step& step : chain()) {
    ASSERT_EQ(run(other, step.stage, step.arguments).status, 0) << step.stage;
    for (const std::string& output : step.outputs) {
      EXPECT_TRUE(bytes_of(tiny / output) == bytes_of(other / output)) << output;
    }
  }
}

TEST(Chain, GivesTheSameBytesInEveryFolder) {
  const Tiny tiny;
  std::set<std::string> expected{"tiny.toml"};
  for (const Step& step : chain()) {
    const Outcome outcome = tiny.run(step.stage, step.arguments);
    ASSERT_EQ(outcome.status, 0) << step.stage << ": " << outcome.err;
    EXPECT_EQ(outcome.err, "") << step.stage;
    EXPECT_TRUE(step.stage == "tabulate" || is_one_line(outcome.out)) << outcome.out;
    expected.insert(step.outputs.begin(), step.outputs.end());
    EXPECT_EQ(tiny.files(), expected) << step.stage;
  }
  const Outcome verified = tiny.run("verify", artefacts());
  EXPECT_EQ(verified.status, 0);
  EXPECT_EQ(verified.out + verified.err, "");

  // 40 windows of each of 3 classes: A gets 10 of each; B the rest of the healthy ones, C 5 of each
  // fault class.
  const std::map<std::string, std::size_t> windows{
      {"A", 30}, {"B", 30}, {"C", 10}, {"D", 50}, {"E", 10}};
  for (const auto& [role, count] : windows) {
    const Reader reader(tiny / (role + ".h5"), "windows");
    EXPECT_EQ(reader.text("/", "role"), role);
    EXPECT_EQ(reader.numbers<float>("/windows", {0, 1024}).shape.front(), count) << role;
    EXPECT_EQ(reader.numbers<std::int32_t>("/labels", {count}).values.size(), count);
  }
  EXPECT_EQ(Reader(tiny / "C.h5", "windows").text("/", "records_digest"),
            Reader(tiny / "records.h5", "records").digest());
  EXPECT_EQ(Reader(tiny / "model.h5", "model").text("/", "method"), "piae-dt");
  EXPECT_EQ(Reader(tiny / artefacts().back(), "diagnosis").text("/", "ratio"), "50to1");

  const std::string table = bytes_of(tiny / "run/tiny/accuracy.csv");
  EXPECT_NE(
      table.find(
          "dataset,method,classifier,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,"
          "published\ntiny,none,wdcnn,100to1,0,1,"),
      std::string::npos)
      << table;
  EXPECT_NE(table.find("tiny,piae-dt,wdcnn,50to1,5,1,"), std::string::npos) << table;

  expect_same_bytes_elsewhere(tiny);
}

/// Fixture of the other tests of this program (tests/CMakeLists.txt): runs the chain once, in the
/// folder PIAE_TINY_CHAIN.
TEST(TinyChain, IsMade) {
  const char* folder = std::getenv("PIAE_TINY_CHAIN");
  if (folder == nullptr) GTEST_SKIP() << "PIAE_TINY_CHAIN is not set";
  fs::remove_all(folder);
  fs::create_directories(folder);
  write_bytes(fs::path(folder) / "tiny.toml", tiny_description);
  for (const Step& step : chain()) {
    ASSERT_EQ(run(folder, step.stage, step.arguments).status, 0) << step.stage;
  }
}

TEST(Chain, ContentDoesNotDependOnTheNumberOfThreads) {
  const Tiny one;
  const Tiny two;
  fs::create_directories(two / "two");
  for (const std::string stage : {"simulate", "split", "train"}) {
    const Arguments& arguments = step_of(stage).arguments;
    ASSERT_EQ(run(one.path(), stage, arguments).status, 0);
    Arguments elsewhere = arguments;
    const std::string output = step_of(stage).outputs.front();
    if (stage == "simulate") elsewhere = with(elsewhere, "--output", "two/records.h5");
    if (stage == "split") elsewhere = with(elsewhere, "--output-dir", "two");
    if (stage == "train") elsewhere = with(elsewhere, "--output", "two/model.h5");
    ASSERT_EQ(run(one.path(), stage, elsewhere, {{{"OMP_NUM_THREADS", "3"}}}).status, 0);
    EXPECT_EQ(Reader(one / output, "").digest(), Reader(one / ("two/" + output), "").digest());
  }
}

TEST(Chain, DiagnosisWithoutReproducibleStoresTheThroughput) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  Arguments arguments = chain()[5].arguments;
  std::erase(arguments, "--reproducible");
  ASSERT_EQ(tiny.run("diagnose", arguments).status, 0);
  const Reader diagnosis(tiny / chain()[5].outputs.front(), "diagnosis");
  EXPECT_GT(diagnosis.real("/", "train_windows_per_second"), 0);
}

TEST(Chain, DiagnosisKeepsFeaturesIfRequested) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const Arguments arguments = chain()[5].arguments;
  ASSERT_EQ(tiny.run("diagnose", arguments).status, 0);
  Arguments keeping = with(arguments, "--output", "features.h5");
  keeping.emplace_back("--keep-features");
  ASSERT_EQ(tiny.run("diagnose", keeping).status, 0);
  const Reader without(tiny / chain()[5].outputs.front(), "diagnosis");
  const Reader kept(tiny / "features.h5", "diagnosis");
  EXPECT_FALSE(without.has("/features"));
  EXPECT_EQ(kept.numbers<float>("/features/hidden", {30, 100}).shape.size(), 2U);
  EXPECT_EQ(kept.numbers<float>("/features/output", {30, 3}).shape.size(), 2U);
  EXPECT_EQ(kept.numbers<float>("/scores", {30, 3}).values,
            without.numbers<float>("/scores", {30, 3}).values);
}

}  // namespace
}  // namespace piae::stages
