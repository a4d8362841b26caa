#include "regression/measurements.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/error.hpp"
#include "support/folder.hpp"

namespace piae::regression {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Stored : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_.path() / "random"); }
  void store(const std::string& text) const { folder_.write("random/cwru.csv", text); }
  [[nodiscard]] Measurements read() const {
    return read_reference(folder_.path(), signal::Protocol::random, "cwru");
  }
  void expect_refused(const std::string& text, const std::string& what, Exit exit) const {
    store(text);
    try {
      (void)read();
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("random/cwru.csv"));
      EXPECT_THAT(error.what(), HasSubstr(what));
      EXPECT_EQ(error.exit(), exit);
    }
  }

  Folder folder_;
};

TEST_F(Stored, ReferenceIsReadToTheLastDigit) {
  Measurements written{
      "cwru", signal::Protocol::random, {}, {"0.1.0 (abc)", "0.2.0"}, {"a; b", "c"}};
  for (const double accuracy : {0.1 + 0.2, 1.0 / 3, 1e-17, 0.62}) {
    const auto seed = static_cast<std::int64_t>(written.values.size());
    written.values.push_back({"vae", "wdcnn", "10to1", "accuracy", seed, accuracy});
  }
  written.values.push_back({"vae", "nearest", "10to1", "accuracy", 0, 0.5});
  written.values.push_back({"vae", "", "", "mmd", 100, 123456.789});
  store(reference_csv(written));
  const Measurements back = read();
  EXPECT_EQ(back.versions, written.versions);
  EXPECT_EQ(back.settings, written.settings);
  ASSERT_EQ(back.values.size(), written.values.size());
  for (std::size_t i = 0; i < back.values.size(); ++i) {
    EXPECT_EQ(back.values[i].method, written.values[i].method);
    EXPECT_EQ(back.values[i].classifier, written.values[i].classifier);
    EXPECT_EQ(back.values[i].ratio, written.values[i].ratio);
    EXPECT_EQ(back.values[i].quantity, written.values[i].quantity);
    EXPECT_EQ(back.values[i].seed, written.values[i].seed);
    EXPECT_EQ(back.values[i].value, written.values[i].value);
  }
  // Tables of several data sets are next to their references (pipeline/keep_shown.sh).
  folder_.write("random/transfer@speeds.csv", "group,method\n");
  EXPECT_THAT(reference_datasets(folder_.path(), signal::Protocol::random), ElementsAre("cwru"));
  EXPECT_THAT(reference_datasets(folder_.path(), signal::Protocol::blocked), IsEmpty());
}

TEST_F(Stored, DamagedOrMissingReferenceIsRefused) {
  const std::string made = "# built from: 1\n# computed with: 2\n";
  const std::string header = "method,classifier,ratio,quantity,seed,value\n";
  const std::string line = "vae,wdcnn,10to1,accuracy,0,0.5\n";
  expect_refused(header + line, "lacks the first lines", Exit::bad_input);
  expect_refused(made + "method,seed\nvae,0\n", "line 3: is not the header", Exit::bad_input);
  expect_refused(made + header, "holds no table", Exit::bad_input);
  expect_refused(made + header + line + line, "line 5: repeats an earlier line", Exit::bad_input);
  expect_refused(made + header + "vae,wdcnn,10to1,accuracy,-1,0.5\n", "'-1' is not a seed",
                 Exit::bad_input);
  expect_refused(made + header + "vae,wdcnn,10to1,accuracy,0.5,0.5\n", "'0.5' is not a seed",
                 Exit::bad_input);
  expect_refused(made + header + "vae,wdcnn,10to1,accuracy,1e300,0.5\n", "'1e300' is not a seed",
                 Exit::bad_input);
  expect_refused(made + header + "vae,wdcnn,10to1,accuracy,\x1b[2J,0.5\n", "'?[2J' is not a seed",
                 Exit::bad_input);
  expect_refused(made + header + "vae,wdcnn,10to1,accuracy,0,nan\n", "'nan' is not a number",
                 Exit::bad_input);
  std::filesystem::remove(folder_.path() / "random/cwru.csv");
  try {
    (void)read();
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("with `make reference RUN=...`"));
    EXPECT_EQ(error.exit(), Exit::input_missing);
  }
}

}  // namespace
}  // namespace piae::regression
