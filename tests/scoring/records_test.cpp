#include <gmock/gmock.h>

#include <algorithm>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/quality_record.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/three_classes.hpp"

namespace piae::scoring {
namespace {

using artefact::Reader;
using artefact::Refusal;
using artefact::Writer;
using testing::HasSubstr;

class Records : public testing::Test {
 protected:
  template <class Record>
  Reader stored(const std::string& kind, const Record& record) {
    Writer writer(kind);
    write(writer, record);
    return save(writer, kind);
  }
  Reader save(Writer& writer, const std::string& kind) {
    writer.save(folder_.path() / "file.h5", {"test", "", {}});
    return {folder_.path() / "file.h5", kind};
  }

  Folder folder_;
};

DiagnosisRecord diagnosis() {
  DiagnosisRecord record;
  record.info = three_classes();
  record.method = "piae-dt";
  record.ratio = "2to1";
  record.generated_per_class = 145;
  record.true_ratio = 500.0 / 150;
  record.seed = 3;
  record.protocol = signal::Protocol::random;
  record.labels = {0, 1, 2, 1};
  record.predictions = {0, 1, 0, 1};
  record.scores = {0.8F, 0.1F, 0.1F, 0, 1, 0, 0.5F, 0.25F, 0.25F, 0, 1, 0};
  record.loss = {1.5, 0.5};
  record.train_accuracy = {0.25, 1};
  return record;
}

QualityRecord quality() {
  return {
      three_classes(),
      "vae",
      4,
      signal::Protocol::blocked,
      {{1, 495, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}, {2, 494, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7}}};
}

TEST_F(Records, UnknownNamesAreRefused) {
  DiagnosisRecord odd = diagnosis();
  odd.ratio = "3to1";
  EXPECT_THROW((void)read_diagnosis(stored("diagnosis", odd)), Refusal);
  odd = diagnosis();
  odd.method = "<b>vae</b>";
  EXPECT_THROW((void)read_diagnosis(stored("diagnosis", odd)), Refusal);
  QualityRecord score = quality();
  score.method = "";
  EXPECT_THROW((void)read_quality(stored("score", score)), Refusal);
}

TEST_F(Records, DiagnosisIsReadAsWritten) {
  DiagnosisRecord record = diagnosis();
  EXPECT_FALSE(read_diagnosis(stored("diagnosis", record)).train_windows_per_second);
  record.train_windows_per_second = 12.5;
  const Reader reader = stored("diagnosis", record);
  EXPECT_EQ(reader.real("/", "accuracy"), 0.75);
  EXPECT_THAT(reader.numbers<std::int64_t>("/confusion", {3, 3}).values,
              testing::ElementsAre(1, 0, 0, 0, 2, 0, 1, 0, 0));
  const DiagnosisRecord read = read_diagnosis(reader);
  EXPECT_EQ(read.info.name, "toy");
  EXPECT_EQ(read.method, record.method);
  EXPECT_EQ(read.ratio, record.ratio);
  EXPECT_EQ(read.generated_per_class, record.generated_per_class);
  EXPECT_EQ(read.true_ratio, record.true_ratio);
  EXPECT_EQ(read.seed, record.seed);
  EXPECT_EQ(read.protocol, record.protocol);
  EXPECT_EQ(read.labels, record.labels);
  EXPECT_EQ(read.predictions, record.predictions);
  EXPECT_EQ(read.scores, record.scores);
  EXPECT_EQ(read.loss, record.loss);
  EXPECT_EQ(read.train_accuracy, record.train_accuracy);
  EXPECT_EQ(read.train_windows_per_second, record.train_windows_per_second);
  EXPECT_EQ(read.accuracy(), 0.75);
}

TEST_F(Records, DiagnosisWithoutKnownFaultsRecordsIt) {
  DiagnosisRecord record = diagnosis();
  EXPECT_FALSE(stored("diagnosis", record).has_attribute("/", "known_per_class"));
  record.any_known = false;
  const Reader generated = stored("diagnosis", record);
  EXPECT_EQ(generated.integer("/", "known_per_class"), 0);
  EXPECT_FALSE(read_diagnosis(generated).any_known);
  EXPECT_EQ(read_diagnosis(generated).true_ratio, record.true_ratio);
}

/// The ratio to the windows of a fault exists only if there are some.
TEST_F(Records, DiagnosisHasATrueRatioUnlessItLacksFaultWindows) {
  DiagnosisRecord record = diagnosis();
  record.any_known = false;
  record.true_ratio.reset();
  EXPECT_ERROR(read_diagnosis(stored("diagnosis", record)), Exit::bad_input, "true_ratio");
  record.generated_per_class = 0;
  record.ratio = "100to1";
  const Reader healthy_alone = stored("diagnosis", record);
  EXPECT_FALSE(healthy_alone.has_attribute("/", "true_ratio"));
  EXPECT_EQ(read_diagnosis(healthy_alone).true_ratio, std::nullopt);
  record.any_known = true;
  EXPECT_ERROR(read_diagnosis(stored("diagnosis", record)), Exit::bad_input, "true_ratio");
}

// Files of the paper's classifier stay the same as before others existed.
TEST_F(Records, DiagnosisNamesItsClassifierUnlessItIsThePapers) {
  DiagnosisRecord record = diagnosis();
  const Reader papers = stored("diagnosis", record);
  EXPECT_FALSE(papers.has_attribute("/", "classifier"));
  EXPECT_EQ(read_diagnosis(papers).classifier, "wdcnn");
  record.classifier = "nearest";
  const Reader other = stored("diagnosis", record);
  EXPECT_EQ(other.text("/", "classifier"), "nearest");
  EXPECT_EQ(read_diagnosis(other).classifier, "nearest");
  record.classifier = "<b>nearest</b>";
  EXPECT_THROW((void)read_diagnosis(stored("diagnosis", record)), Refusal);
}

TEST_F(Records, DiagnosisWithoutTrainingHasNoCurves) {
  DiagnosisRecord record = diagnosis();
  record.loss.clear();
  record.train_accuracy.clear();
  const DiagnosisRecord read = read_diagnosis(stored("diagnosis", record));
  EXPECT_TRUE(read.loss.empty());
  EXPECT_TRUE(read.train_accuracy.empty());
}

TEST_F(Records, DiagnosisMayHaveFeatures) {
  DiagnosisRecord record = diagnosis();
  EXPECT_FALSE(read_diagnosis(stored("diagnosis", record)).features);
  EXPECT_FALSE(stored("diagnosis", record).has("/features"));
  record.features = {.hidden = {1, 2, 3, 4, 5, 6, 7, 8}, .output = record.scores};
  const Reader reader = stored("diagnosis", record);
  EXPECT_EQ(reader.numbers<float>("/features/hidden", {4, 2}).values, record.features->hidden);
  const DiagnosisRecord read = read_diagnosis(reader);
  ASSERT_TRUE(read.features);
  EXPECT_EQ(read.features->hidden, record.features->hidden);
  EXPECT_EQ(read.features->output, record.features->output);
}

TEST_F(Records, DiagnosisNeedsFeaturesOfEachWindow) {
  DiagnosisRecord record = diagnosis();
  record.features = {.hidden = {1, 2, 3, 4, 5}, .output = record.scores};
  EXPECT_THROW(stored("diagnosis", record), std::logic_error);
  record.features = {.hidden = {1, 2, 3, 4}, .output = {1, 2, 3, 4}};
  EXPECT_THROW(stored("diagnosis", record), std::logic_error);
}

/// Content with correct digests that a diagnosis cannot have.
class WrongDiagnosis : public Records {
 protected:
  void SetUp() override {
    signal::write(writer_, diagnosis().info);
    writer_.attribute("/", "method", std::string("word"));
    writer_.attribute("/", "ratio", std::string("100to1"));
    writer_.attribute("/", "protocol", std::string("random"));
    writer_.attribute("/", "generated_per_class", std::int64_t{0});
    writer_.attribute("/", "seed", std::int64_t{0});
    writer_.attribute("/", "true_ratio", 100.0);
  }
  void expect_refused(const std::vector<std::int32_t>& labels,
                      const std::vector<std::int32_t>& predictions,
                      const std::vector<std::int64_t>& confusion, double accuracy,
                      const std::string& what) {
    writer_.attribute("/", "accuracy", accuracy);
    writer_.numbers("/labels", labels);
    writer_.numbers("/predictions", predictions);
    writer_.numbers("/confusion", confusion, {3, 3});
    writer_.numbers("/scores", std::vector<float>(3 * labels.size()), {labels.size(), 3});
    writer_.numbers("/curves/loss", std::vector<double>{1});
    writer_.numbers("/curves/train_accuracy", std::vector<double>{1});
    const Reader reader = save(writer_, "diagnosis");
    try {
      read_diagnosis(reader);
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Refusal& refusal) {
      EXPECT_EQ(refusal.reason(), artefact::RefusalReason::bad_content);
      EXPECT_THAT(refusal.what(), HasSubstr(what));
      EXPECT_THAT(refusal.what(), HasSubstr("file.h5"));
    }
  }

 private:
  Writer writer_{"diagnosis"};
};

TEST_F(WrongDiagnosis, WithAWrongAccuracyIsRefused) {
  expect_refused({0, 1}, {0, 2}, {1, 0, 0, 0, 0, 1, 0, 0, 0}, 0.9, "attribute accuracy");
}
TEST_F(WrongDiagnosis, WithAWrongMatrixIsRefused) {
  expect_refused({0, 1}, {0, 2}, {1, 0, 0, 0, 1, 0, 0, 0, 0}, 1.0, "/confusion is not");
}
TEST_F(WrongDiagnosis, WithAnUnknownLabelIsRefused) {
  expect_refused({0, 3}, {0, 2}, {1, 0, 0, 0, 1, 0, 0, 0, 0}, 1.0, "/labels holds class 3");
}
TEST_F(WrongDiagnosis, WithAnUnknownPredictionIsRefused) {
  expect_refused({0, 1}, {0, -1}, {1, 0, 0, 0, 1, 0, 0, 0, 0}, 1.0, "/predictions holds class -1");
}
TEST_F(WrongDiagnosis, WithFewerPredictionsThanLabelsIsRefused) {
  expect_refused({0, 1}, {0}, {1, 0, 0, 0, 1, 0, 0, 0, 0}, 1.0, "/predictions has the wrong shape");
}
TEST_F(WrongDiagnosis, WithoutAWindowIsRefused) {
  expect_refused({}, {}, {0, 0, 0, 0, 0, 0, 0, 0, 0}, 1.0, "/labels is empty");
}

TEST_F(Records, QualityIsReadAsWritten) {
  const Reader reader = stored("score", quality());
  EXPECT_THAT(reader.list("/quality"),
              testing::UnorderedElementsAre("mmd", "rmse", "aligned_rmse", "amplitude_ratio",
                                            "spectral_distance_db", "fault_line_db",
                                            "fault_line_difference_db"));
  EXPECT_THAT(reader.numbers<double>("/quality/rmse", {2}).values, testing::ElementsAre(0.2, 1.2));
  const QualityRecord read = read_quality(reader);
  EXPECT_EQ(read.info.name, "toy");
  EXPECT_EQ(read.method, "vae");
  EXPECT_EQ(read.seed, 4);
  EXPECT_EQ(read.protocol, signal::Protocol::blocked);
  ASSERT_EQ(read.classes.size(), 2U);
  EXPECT_EQ(read.classes[1].label, 2);
  EXPECT_EQ(read.classes[1].windows, 494);
  for (const Metric& metric : all_metrics()) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(read.classes[i].*metric.value, quality().classes[i].*metric.value) << metric.name;
    }
  }
}

TEST_F(Records, QualityOfImpossibleClassesIsRefused) {
  for (const int label : {3, -1, 2}) {
    QualityRecord record = quality();
    record.classes[0].label = label;
    EXPECT_THROW(read_quality(stored("score", record)), Refusal) << label;
  }
  QualityRecord nothing = quality();
  nothing.classes.clear();
  EXPECT_THROW(read_quality(stored("score", nothing)), Refusal);
}

TEST_F(Records, RecordOfAnotherKindIsRefused) {
  EXPECT_THROW(read_diagnosis(stored("score", quality())), Refusal);
  EXPECT_THROW(read_quality(stored("diagnosis", diagnosis())), Refusal);
}

TEST(QualityRecord, MeanFaultLineUsesClassesWithALine) {
  QualityRecord record;
  record.info = three_classes();
  record.classes = {{.label = 1, .rmse = 1, .fault_line_db = 4}, {.label = 2, .rmse = 3}};
  const auto mean = [&](const std::string& name) {
    const auto metrics = all_metrics();
    return record.mean_over_classes(*std::ranges::find(metrics, name, &Metric::name));
  };
  EXPECT_EQ(mean("rmse"), 2);
  EXPECT_EQ(mean("fault_line_db"), 2);
  record.info.classes[2].defect = signal::Defect::other;
  EXPECT_EQ(mean("rmse"), 2);
  EXPECT_EQ(mean("fault_line_db"), 4);
  record.info.classes[1].defect = signal::Defect::other;
  EXPECT_EQ(mean("fault_line_db"), 0);
}

}  // namespace
}  // namespace piae::scoring
