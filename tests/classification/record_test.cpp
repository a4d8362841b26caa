#include "classification/record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "classification/judged.hpp"
#include "stages/doctor.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::classification {
namespace {

using testing::ElementsAre;

class ClassificationRecord : public testing::Test {
 protected:
  ClassificationRecord() { write_again(); }
  void write_again() const {
    artefact::Writer writer("classification");
    write(writer, {judged("a.csv", {1, 0, 1}), judged("b.csv", {-1, 2, -1})}, classifier_of_toys(),
          "0123");
    writer.save(file_, {"test", "", {}});
  }
  [[nodiscard]] artefact::Reader reader() const { return {file_, "classification"}; }
  template <artefact::hdf5::Number T>
  [[nodiscard]] std::vector<T> numbers(const std::string& path) const {
    return reader().numbers<T>(path, {0}).values;
  }
  /// Expects a refusal if the first number of a dataset changes.
  template <artefact::hdf5::Number T>
  void expect_refused(const std::string& path, T first) const {
    write_again();
    stages::doctor(file_, [&](hid_t file) {
      stages::change_numbers<T>(file, path, [&](auto& values) { values.front() = first; });
    });
    EXPECT_ERROR(require_classification(reader()), Exit::bad_input, path);
  }

  const Folder folder_;
  const std::string file_ = folder_ / "classification.h5";
};

TEST_F(ClassificationRecord, HoldsEachRecordingAndEachWindow) {
  EXPECT_NO_THROW(require_classification(reader()));
  EXPECT_EQ(reader().text("/", "classifier"), "nearest");
  EXPECT_EQ(reader().text("/", "classifier_digest"), "0123");
  EXPECT_THAT(reader().strings("/recordings/name"), ElementsAre("a.csv", "b.csv"));
  EXPECT_THAT(numbers<Label>("/recordings/label"), ElementsAre(1, 2));
  EXPECT_THAT(numbers<double>("/recordings/probability"),
              ElementsAre(testing::DoubleNear(1.7 / 3, 1e-6), testing::DoubleNear(0.8, 1e-6)));
  EXPECT_THAT(numbers<double>("/recordings/share"), ElementsAre(2.0 / 3, 1.0 / 3));
  EXPECT_THAT(numbers<double>("/recordings/share_unknown"), ElementsAre(0, 2.0 / 3));
  EXPECT_THAT(numbers<std::int32_t>("/recordings/unknown"), ElementsAre(0, 1));
  EXPECT_THAT(numbers<std::int32_t>("/windows/recording"), ElementsAre(0, 0, 0, 1, 1, 1));
  EXPECT_THAT(numbers<Label>("/windows/label"), ElementsAre(1, 0, 1, 0, 2, 0));
  EXPECT_DOUBLE_EQ(numbers<double>("/windows/start_s")[5], 2048 / 12000.0);
  EXPECT_GT(numbers<double>("/windows/strangeness")[3], 1);
  EXPECT_NEAR(reader().numbers<float>("/windows/probabilities", {6, 3}).values[1], 0.8, 1e-6);
}

TEST_F(ClassificationRecord, HasThePredictionOfEachRecording) {
  const std::vector<Named> named = read_named(reader());
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[0].recording, "a.csv");
  EXPECT_EQ(named[0].fault, classifier_of_toys().info().classes[1].name);
  EXPECT_EQ(named[1].fault, "unknown");
}

TEST_F(ClassificationRecord, RefusesImpossibleContents) {
  expect_refused<Label>("/recordings/label", 3);
  expect_refused<Label>("/windows/label", -1);
  expect_refused<std::int32_t>("/windows/recording", 2);
  expect_refused<std::int32_t>("/recordings/unknown", 7);
  expect_refused<double>("/recordings/share", 1.5);
  expect_refused<double>("/recordings/share_unknown", -0.5);
  expect_refused<double>("/windows/start_s", -1);
  expect_refused<double>("/windows/strangeness", -1);
  expect_refused<float>("/windows/probabilities", 1.5F);
}

}  // namespace
}  // namespace piae::classification
