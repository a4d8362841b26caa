// Tables fit into a terminal, whatever a run holds.

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "augment/catalogue.hpp"
#include "report/accuracy_table.hpp"
#include "report/contrast.hpp"
#include "report/paper.hpp"
#include "report/ratio_means.hpp"
#include "report/tables.hpp"
#include "support/shown.hpp"

namespace piae::report {
namespace {

void expect_narrow(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(width_of(line), 100U) << line;
}

/// All methods at all ratios, with numbers as wide as possible: differences and deviations with two
/// digits before the point, and quality from 1e-4 to 99.
class FullGrid {
 public:
  FullGrid(const std::string& dataset, int seeds,
           const std::vector<std::string>& classifiers = {}) {
    std::string methods;
    std::string ratios;
    std::string seed_words;
    for (const augment::CatalogueEntry& entry : augment::catalogue()) {
      methods += std::string(entry.name) + ' ';
    }
    for (const scoring::Ratio& ratio : scoring::all_ratios())
      ratios += std::string(ratio.name) + ' ';
    for (int seed = 0; seed < seeds; ++seed) seed_words += std::to_string(seed) + ' ';
    grid_ = resolve(run::GridOptions{dataset, {methods}, {ratios}, {seed_words}, classifiers});
    for (const run::Combination& cell : grid_.combinations) {
      for (const std::int64_t seed : grid_.seeds) add(cell, seed);
    }
    for (const std::string& method : grid_.scored) {
      for (const std::int64_t seed : grid_.seeds) add_score(method, seed);
    }
  }

  /// Removes cells of one method, to make gaps.
  void drop(const std::string& method, std::int64_t from_seed) {
    std::erase_if(results_.diagnoses, [&](const run::Diagnosis& cell) {
      return cell.method == method && cell.seed >= from_seed;
    });
  }

  [[nodiscard]] std::vector<AccuracyRow> rows() const {
    return accuracy_rows(grid_, results_, Published(PIAE_SOURCE "/results/published"));
  }
  [[nodiscard]] std::string markdown_of_tables() const {
    const auto own = rows();
    return markdown(tables(grid_, results_, own, Published(PIAE_SOURCE "/results/published"),
                           compare_by_classifier(own, ""), rank_by_classifier(own)));
  }

 private:
  void add(const run::Combination& cell, std::int64_t seed) {
    const scoring::Ratio& ratio = scoring::find_ratio(cell.ratio);
    const double place = static_cast<double>(results_.diagnoses.size());
    results_.diagnoses.push_back(
        {.method = cell.method,
         .ratio = cell.ratio,
         .classifier = cell.classifier,
         .seed = seed,
         .generated_per_class = ratio.generated_per_class,
         .true_ratio = scoring::true_ratio(500, 5, ratio.generated_per_class),
         .protocol = signal::Protocol::random,
         .accuracy = cell.method == "oracle" ? 1 - 1e-3 * std::abs(std::sin(place))
                                             : 0.5 + 0.5 * std::sin(3 * place + 0.1),
         .confidence = {.calibration_error = 0.5 - 0.5 * std::sin(place),
                        .answerable = 0.5 + 0.5 * std::sin(2 * place)},
         .decisions = {{.windows = 1, .decisions = 12345, .balanced = 0.5 + 0.5 * std::sin(place)},
                       {.windows = 10, .decisions = 1234, .balanced = 1},
                       {.windows = 60, .decisions = 1, .balanced = seed == 0 ? 0.0 : 1.0}}});
  }
  void add_score(const std::string& method, std::int64_t seed) {
    scoring::QualityRecord& record = results_.qualities.emplace_back();
    record.info.name = grid_.dataset;
    record.info.classes = {{"Normal", signal::Defect::none, 0}};
    record.method = method;
    record.seed = seed;
    for (Label label = 1; label < 10; ++label) {
      record.info.classes.push_back({"IR0" + std::to_string(label), signal::Defect::inner, 0.2});
      scoring::ClassQuality& quality = record.classes.emplace_back();
      quality.label = label;
      for (const scoring::Metric& metric : scoring::all_metrics()) {
        quality.*metric.value = (seed % 2 == 0 ? -99 : 99) * std::pow(10, -label / 2);
      }
    }
  }

  run::Grid grid_;
  run::Results results_;
};

class Width : public testing::TestWithParam<const char*> {};

TEST_P(Width, OfTheFullGridIsAtMost100) {
  FullGrid grid(GetParam(), 10);
  expect_narrow(grid.markdown_of_tables());
  EXPECT_THAT(grid.markdown_of_tables(), testing::HasSubstr("| oracle (ceiling) "));
  EXPECT_THAT(grid.markdown_of_tables(), testing::HasSubstr("| decisions of a seed "));
}

TEST_P(Width, OfTablesOfFewOrManySeedsOrWithGapsIsAtMost100) {
  for (const int seeds : {1, 2, 5, 30})
    expect_narrow(FullGrid(GetParam(), seeds).markdown_of_tables());
  FullGrid with_gaps(GetParam(), 10);
  with_gaps.drop("shift", 2);
  with_gaps.drop("oracle", 3);
  with_gaps.drop("piae-dt-phase", 9);
  expect_narrow(with_gaps.markdown_of_tables());
}

TEST_P(Width, OfTablesOfSeveralClassifiersIsAtMost100) {
  const FullGrid grid(GetParam(), 3, {"wdcnn", "wdcnn-spectrum", "wdcnn-envelope"});
  expect_narrow(grid.markdown_of_tables());
  EXPECT_THAT(grid.markdown_of_tables(), testing::HasSubstr(", by wdcnn-envelope\n"));
  expect_narrow(accuracy_text(grid.rows()));
}

TEST_P(Width, OfAContrastIsAtMost100) {
  const std::vector<AccuracyRow> rows = with_means(FullGrid(GetParam(), 10).rows());
  const Contrast protocols = contrast({"results/a", GetParam(), signal::Protocol::random, rows},
                                      {"results/b", GetParam(), signal::Protocol::blocked, rows});
  const Contrast rates =
      contrast({"results/a", GetParam(), signal::Protocol::random, rows},
               {"results/a", "cwru-as-published-at-12-kHz", signal::Protocol::random, rows});
  expect_narrow(markdown(contrast_document(protocols)));
  expect_narrow(markdown(contrast_document(rates)));
}

INSTANTIATE_TEST_SUITE_P(Datasets, Width,
                         testing::Values("cwru", "hit-sm", "cwru-as-published", "rig"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace piae::report
