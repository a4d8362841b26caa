#include <gtest/gtest.h>

#include <random>

#include "artefact/reader.hpp"
#include "stages/tiny.hpp"

/// One byte that is not what it was.
namespace piae::stages {
namespace {

using artefact::Reader;

/// The step that reads an artefact of the chain, and the option that names it.
struct Consumer {
  std::string file;
  std::string stage;
  std::string option;  ///< empty where the stage finds the file by itself
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
    {"run/tiny/seed0/piae-dt/50to1/diagnosis.h5", "tabulate", ""},
};

/// What tells two artefacts with different values apart. Reading checks that both digests are those
/// of the values.
std::string digests_of(const Reader& reader) {
  return reader.digest() + ' ' + reader.text("/provenance", "digest");
}

class Flips : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("tabulate"); }

  /// A copy with one bit or more of one byte changed, at a random place.
  std::string flipped(const std::string& good) {
    std::string bytes = good;
    char& byte = bytes[random_() % bytes.size()];
    byte = static_cast<char>(byte ^ static_cast<char>(1 + random_() % 255));
    return bytes;
  }

  Tiny tiny_;
  std::mt19937_64 random_{20240229};
};

TEST_F(Flips, AreRefusedOrChangeNoValue) {
  int refused = 0;
  int neutral = 0;
  for (int i = 0; i < 200; ++i) {
    const Consumer& c = consumers[static_cast<std::size_t>(i) % consumers.size()];
    const std::string good = digests_of(Reader(tiny_ / c.file, ""));
    write_bytes(tiny_ / "flipped.h5", flipped(bytes_of(tiny_ / c.file)));
    try {
      EXPECT_EQ(digests_of(Reader(tiny_ / "flipped.h5", "")), good) << c.file << ", flip " << i;
      ++neutral;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input) << error.what();
      ++refused;
    }
  }
  RecordProperty("refused", refused);
  RecordProperty("neutral", neutral);
  std::cout << refused << " flips refused, " << neutral << " without any effect on a value\n";
  EXPECT_GT(refused, 100);
}

TEST_F(Flips, AreRefusedByVerifyAndByTheStageThatReadsTheFile) {
  for (std::size_t i = 0; i < 2 * consumers.size(); ++i) {
    const Consumer& c = consumers[i % consumers.size()];
    SCOPED_TRACE(c.file + ", flip " + std::to_string(i));
    const std::string good = bytes_of(tiny_ / c.file);
    const std::string digests = digests_of(Reader(tiny_ / c.file, ""));
    write_bytes(tiny_ / c.file, flipped(good));
    const std::set<std::string> before = tiny_.files();
    const Outcome verified = tiny_.run("verify", {c.file});
    if (verified.status == 0) {
      EXPECT_EQ(digests_of(Reader(tiny_ / c.file, "")), digests);
    } else {
      EXPECT_TRUE(verified.status == 1 || verified.status == 4) << verified.out;
      EXPECT_TRUE(is_one_line(verified.out)) << verified.out;
      const Outcome outcome = tiny_.run_step(c.stage);
      EXPECT_EQ(outcome.status, 65) << outcome.err;
      EXPECT_NE(outcome.err.find(c.file), std::string::npos) << outcome.err;
      EXPECT_EQ(tiny_.files(), before);
    }
    write_bytes(tiny_ / c.file, good);
  }
}

}  // namespace
}  // namespace piae::stages
