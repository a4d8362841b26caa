#include "figures/feature_maps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "embedding/trustworthiness.hpp"
#include "embedding/tsne.hpp"
#include "figures/csv_rows.hpp"
#include "support/errors.hpp"
#include "support/stored_run.hpp"

namespace piae::figures {
namespace {

/// Returns features of 20 windows: 10 of class OR around 0, alternating with 10 of class IR around
/// 50.
scoring::Features two_clouds() {
  scoring::Features features;
  for (int i = 0; i < 20; ++i) {
    const double away = i % 2 == 0 ? 0 : 50;
    for (const double at : {away + std::sin(i), away + std::cos(3 * i)}) {
      features.hidden.push_back(static_cast<float>(at));
    }
    for (const double at : {std::sin(2 * i), std::cos(i), std::sin(5 * i)}) {
      features.output.push_back(static_cast<float>(at));
    }
  }
  return features;
}

class FeatureMaps : public StoredRun {
 protected:
  [[nodiscard]] scoring::DiagnosisRecord record(const std::string& method, const std::string& ratio,
                                                int generated) const {
    scoring::DiagnosisRecord result = diagnosis(method, ratio, generated, 0, 10);
    for (std::size_t i = 0; i < 20; i += 2) result.labels[i] = 2;
    result.features = two_clouds();
    return result;
  }
  void save_features(const scoring::DiagnosisRecord& record) const {
    save("diagnosis", record, layout_.features(record.method, record.ratio, record.seed));
  }
  void save_all() const {
    save_features(record("none", "100to1", 0));
    save_features(record("vae", "2to1", 145));
  }

  Source source_{layout_, grid_, {}};
};

TEST_F(FeatureMaps, ShowEachMethodAtItsLastRatio) {
  save_all();
  const CsvRows rows(hidden_map(source_));
  EXPECT_THAT(rows.header(),
              testing::ElementsAre("method", "class", "x", "y", "trustworthiness", "kl"));
  for (const char* const method : {"none", "vae"}) {
    EXPECT_EQ(rows.where({{"method", method}, {"class", ""}}).size(), 1U);
    EXPECT_EQ(rows.where({{"method", method}, {"class", "IR"}}).size(), 10U);
    EXPECT_EQ(rows.where({{"method", method}, {"class", "OR"}}).size(), 10U);
  }
}

TEST_F(FeatureMaps, KeepClustersApart) {
  save_all();
  const CsvRows rows(hidden_map(source_));
  const auto inner = rows.where({{"method", "vae"}, {"class", "IR"}});
  const auto outer = rows.where({{"method", "vae"}, {"class", "OR"}});
  const auto distance = [](const CsvRows::Row& a, const CsvRows::Row& b) {
    return std::hypot(std::stod(a.at("x")) - std::stod(b.at("x")),
                      std::stod(a.at("y")) - std::stod(b.at("y")));
  };
  for (std::size_t i = 0; i < inner.size(); ++i) {
    EXPECT_LT(distance(inner[i], inner[(i + 1) % 10]), distance(inner[i], outer[i]));
  }
}

TEST_F(FeatureMaps, ReportTheirTrustworthiness) {
  save_all();
  const scoring::Features features = two_clouds();
  embedding::Points points(20, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.reshaped<Eigen::RowMajor>()[i] = features.output[static_cast<std::size_t>(i)];
  }
  const embedding::TsneMap map = embedding::tsne(points, {.perplexity = 19 / 4.0});
  const auto summary = CsvRows(output_map(source_)).where({{"method", "vae"}, {"class", ""}});
  ASSERT_EQ(summary.size(), 1U);
  EXPECT_NEAR(std::stod(summary[0].at("kl")), map.kl_divergence, 6e-4);
  EXPECT_NEAR(std::stod(summary[0].at("trustworthiness")),
              embedding::trustworthiness(points, map.points, 9), 6e-4);
}

TEST_F(FeatureMaps, NameAMissingFile) {
  save_features(record("none", "100to1", 0));
  EXPECT_ERROR(hidden_map(source_), Exit::input_missing,
               layout_.features("vae", "2to1", 0).string());
}

TEST_F(FeatureMaps, NameAFileWithoutFeatures) {
  save_all();
  save_features(diagnosis("vae", "2to1", 145, 0, 10));
  EXPECT_ERROR(hidden_map(source_), Exit::bad_input, "--keep-features");
}

TEST_F(FeatureMaps, NameAFileOfAnotherCell) {
  save_all();
  save("diagnosis", record("vae", "10to1", 45), layout_.features("vae", "2to1", 0));
  EXPECT_ERROR(hidden_map(source_), Exit::bad_input, layout_.features("vae", "2to1", 0).string());
}

TEST_F(FeatureMaps, NeedAFewWindows) {
  save_all();
  scoring::DiagnosisRecord four = record("vae", "2to1", 145);
  four.labels.resize(4);
  four.predictions.resize(4);
  four.scores.resize(12);
  four.features->hidden.resize(8);
  four.features->output.resize(12);
  save_features(four);
  EXPECT_ERROR(output_map(source_), Exit::bad_input, "4 test windows; a map needs 5");
}

}  // namespace
}  // namespace piae::figures
