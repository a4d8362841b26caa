#include <gtest/gtest.h>

#include <map>
#include <random>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

/// Artefacts with one changed byte or a missing end.
namespace piae::stages {
namespace {

using artefact::Reader;

/// A step that reads an artefact of the chain, and the option that names the artefact.
struct Consumer {
  std::string file;
  std::string stage;
  std::string option;  ///< empty if the stage finds the file itself
};

const std::vector<Consumer> consumers{
    {"records.h5", "split", "--records"},
    {"A.h5", "diagnose", "--test"},
    {"B.h5", "diagnose", "--normal"},
    {"C.h5", "train", "--known"},
    {"D.h5", "score", "--real"},
    {"E.h5", "score", "--generated"},
    {"model.h5", "generate", "--model"},
    {"run/tiny/seed0/piae-dt/score.h5", "tabulate", ""},
    {"run/tiny/seed0/piae-dt/50to1/wdcnn/diagnosis.h5", "tabulate", ""},
};

/// Returns both digests, which differ if the values differ. Reading checks that the digests match
/// the values.
std::string digests_of(const Reader& reader) {
  return reader.digest() + ' ' + reader.text("/provenance", "digest");
}

/// Returns a copy with a random byte changed in one or more bits.
std::string flipped(const std::string& good, std::mt19937_64& random) {
  std::string bytes = good;
  char& byte = bytes[random() % bytes.size()];
  byte = static_cast<char>(byte ^ static_cast<char>(1 + random() % 255));
  return bytes;
}

/// True if the library refuses the file. Otherwise the values must be the old ones.
bool is_refused(const fs::path& file, const std::string& digests) {
  try {
    EXPECT_EQ(digests_of(Reader(file, "")), digests);
    return false;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::bad_input) << error.what();
    return true;
  }
}

/// Expects `verify` to report a refused file and its stage to refuse it without writing; expects
/// `verify` to accept any other file.
void expect_refused_by_programs(const Tiny& tiny, const Consumer& c, bool refused) {
  const Outcome verified = tiny.run("verify", {c.file});
  if (!refused) {
    EXPECT_EQ(verified.status, 0) << verified.out;
    return;
  }
  EXPECT_TRUE(verified.status == 1 || verified.status == 4) << verified.out;
  EXPECT_TRUE(is_one_line(verified.out)) << verified.out;
  const std::set<std::string> before = tiny.files();
  const Outcome outcome = tiny.run_step(c.stage);
  EXPECT_EQ(outcome.status, 65) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find(c.file), std::string::npos) << outcome.err;
  EXPECT_EQ(tiny.files(), before);
}

/// The chain's artefacts; tests damage one at a time.
class Damage : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("tabulate");
    for (const Consumer& c : consumers) digests_[c.file] = digests_of(Reader(tiny_ / c.file, ""));
  }

  [[nodiscard]] bool is_refused(const Consumer& c) const {
    return stages::is_refused(tiny_ / c.file, digests_.at(c.file));
  }

  Tiny tiny_;
  std::map<std::string, std::string> digests_;
  std::mt19937_64 random_{20240229};
};

TEST_F(Damage, IsRefusedOrChangesNoValue) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    const Consumer& c = consumers[i % consumers.size()];
    SCOPED_TRACE(c.file + ", flip " + std::to_string(i));
    const std::string good = bytes_of(tiny_ / c.file);
    write_bytes(tiny_ / c.file, flipped(good, random_));
    const bool is_bad = is_refused(c);
    if (is_bad) ++refused;
    if (i % 10 == 0) expect_refused_by_programs(tiny_, c, is_bad);
    write_bytes(tiny_ / c.file, good);
  }
  std::cout << refused << " flips refused, " << 200 - refused << " without effect on any value\n";
  EXPECT_GT(refused, 100);

  refused = 0;
  for (std::size_t i = 0; i < 90; ++i) {
    const Consumer& c = consumers[i % consumers.size()];
    SCOPED_TRACE(c.file + ", cut " + std::to_string(i));
    const std::string good = bytes_of(tiny_ / c.file);
    write_bytes(tiny_ / c.file, good.substr(0, random_() % good.size()));
    if (is_refused(c)) ++refused;
    write_bytes(tiny_ / c.file, good);
  }
  EXPECT_GT(refused, 45);
}

}  // namespace
}  // namespace piae::stages
