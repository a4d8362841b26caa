#include "report/tables.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "report/accuracy_sections.hpp"
#include "report/bounded_summary.hpp"
#include "report/gaps.hpp"
#include "report/paper_reference.hpp"
#include "report/quality_table.hpp"

namespace piae::report {

namespace {

std::string ceiling_note(const run::Grid& grid) {
  const auto of_ceiling = [](const run::Combination& cell) {
    return augment::is_ceiling(cell.method);
  };
  if (std::ranges::none_of(grid.combinations, of_ceiling)) return "";
  return " The oracle is no method but a ceiling: it takes real windows that no method may see in "
         "the place of generated ones, and has no quality, which would compare them with "
         "themselves.";
}

std::string how_to_read(const run::Grid& grid, const std::string& protocol) {
  return fmt::format(
      "Split protocol {}; {} seed{} ({}), each with a split, a generator and a classifier of its "
      "own. Numbers are the mean ± the sample standard deviation over the seeds. {} Ratios are "
      "healthy windows to those of each fault class, as the paper names them; where the true one "
      "differs, it follows in brackets.{}",
      protocol, grid.seeds.size(), grid.seeds.size() == 1 ? "" : "s", seed_list(grid.seeds),
      about_intervals, ceiling_note(grid));
}

}  // namespace

Document tables(const run::Grid& grid, const run::Results& results,
                const std::vector<AccuracyRow>& rows, const Published& published,
                const Comparisons& comparisons, const RankTable& ranks,
                const std::vector<Section>& twins) {
  const auto beside = PaperReference(grid.dataset).beside();
  const bool stands_in = beside && !beside->own;
  Document document{.key = grid.dataset, .title = "Results on " + grid.dataset};
  if (stands_in) {
    document.title += std::string(", which ") + beside->relation;
    document.paragraphs.emplace_back(beside->caution);
  }
  document.paragraphs.push_back(how_to_read(grid, to_string(results.diagnoses.front().protocol)));
  std::ranges::move(gap_paragraphs(grid, results), std::back_inserter(document.paragraphs));
  for (std::vector<Section> sections :
       {accuracy_sections(rows, published), comparison_sections(comparisons), rank_sections(ranks),
        quality_sections(grid, results), twins}) {
    std::ranges::move(sections, std::back_inserter(document.sections));
  }
  return document;
}

}  // namespace piae::report
