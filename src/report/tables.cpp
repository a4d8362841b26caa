#include "report/tables.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/accuracy_table.hpp"
#include "report/decisions_table.hpp"
#include "report/gaps.hpp"
#include "report/paper.hpp"
#include "report/quality_table.hpp"
#include "report/recommendation_tables.hpp"
#include "report/verdict.hpp"

namespace piae::report {

namespace {

std::string ceiling_note(const run::Grid& grid) {
  const auto of_ceiling = [](const run::Combination& cell) {
    return augment::is_ceiling(cell.method);
  };
  if (std::ranges::none_of(grid.combinations, of_ceiling)) return "";
  return " The oracle is a ceiling, not a method: instead of generated windows it uses real ones "
         "that no method may see. It has no quality, because real windows would be compared with "
         "themselves.";
}

std::string how_to_read(const run::Grid& grid, const std::string& protocol) {
  return fmt::format(
      "Split protocol {}; {} ({}), each with its own split, generator and classifier. Numbers are "
      "the mean ± the sample standard deviation over the seeds. {} Ratios are healthy windows to "
      "windows of each fault class, as named in the paper; the true ratio follows in brackets if "
      "it differs.{}",
      protocol, counted(grid.seeds.size(), "seed"), seed_list(grid.seeds), about_intervals,
      ceiling_note(grid));
}

/// Returns the tables of one classifier.
std::vector<Section> sections_of(const ClassifierRows& block, const run::Results& results,
                                 const Published& published,
                                 const std::vector<Comparisons>& comparisons,
                                 const std::vector<RankTable>& ranks) {
  std::vector<Section> sections = accuracy_sections(block, published);
  const auto add = [&](std::vector<Section> more) {
    std::ranges::move(more, std::back_inserter(sections));
  };
  for (const Comparisons& each : comparisons) {
    if (each.classifier == block.classifier) add(comparison_sections(each));
  }
  for (const RankTable& each : ranks) {
    if (each.classifier == block.classifier) add(rank_sections(each));
  }
  add(decision_sections(block, results));
  add(confidence_sections(block, results));
  return sections;
}

/// Adds the classifier to title and key. Keys are labels of LaTeX; the keys of the paper's
/// classifier stay the same whether or not there are others.
Section named_by(const std::string& classifier, Section section) {
  section.title += ", by " + diagnosis::marked_name(classifier);
  if (classifier != scoring::paper_classifier) section.key += "-" + classifier;
  return section;
}

}  // namespace

Document tables(const run::Grid& grid, const run::Results& results,
                const std::vector<AccuracyRow>& rows, const Published& published,
                const std::vector<Comparisons>& comparisons, const std::vector<RankTable>& ranks,
                const std::vector<Section>& twins) {
  const auto counterpart = PaperReference(grid.dataset).counterpart();
  const bool stands_in = counterpart && !counterpart->own;
  Document document{.key = grid.dataset, .title = "Results on " + grid.dataset};
  if (stands_in) {
    document.title += std::string(", which ") + counterpart->relation;
    document.paragraphs.emplace_back(counterpart->caution);
  }
  const std::string conditions = conditions_note(results);
  if (!conditions.empty()) document.paragraphs.push_back(conditions);
  document.paragraphs.push_back(how_to_read(grid, to_string(results.diagnoses.front().protocol)));
  std::ranges::move(gap_paragraphs(grid, results), std::back_inserter(document.paragraphs));
  const std::string no_decisions = decisions_gap(results);
  if (!no_decisions.empty()) document.paragraphs.push_back(no_decisions);
  const std::vector<ClassifierRows> blocks = by_classifier(rows);
  std::vector<std::string> classifiers;
  for (const ClassifierRows& block : blocks) classifiers.push_back(block.classifier);
  const std::string adapting = about_adapting(classifiers);
  if (!adapting.empty()) document.paragraphs.push_back(adapting);
  for (const ClassifierRows& block : blocks) {
    for (Section& section : sections_of(block, results, published, comparisons, ranks)) {
      document.sections.push_back(blocks.size() == 1 && adapting.empty()
                                      ? std::move(section)
                                      : named_by(block.classifier, std::move(section)));
    }
  }
  std::ranges::move(quality_sections(grid, results), std::back_inserter(document.sections));
  std::ranges::copy(twins, std::back_inserter(document.sections));
  std::ranges::move(recommendation_sections(recommendations(rows, results)),
                    std::back_inserter(document.sections));
  return document;
}

}  // namespace piae::report
