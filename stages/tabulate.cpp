// Makes the tables of a run from its diagnoses and scores.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>

#include "cli/stage.hpp"
#include "report/accuracy_table.hpp"
#include "report/decisions_table.hpp"
#include "report/gaps.hpp"
#include "report/quality_table.hpp"
#include "report/recommendation_tables.hpp"
#include "report/summary.hpp"
#include "report/tables.hpp"
#include "report/twin_table.hpp"
#include "run/held.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "tabulate",
      "Makes the tables of RUN/DATASET from its diagnoses and scores, next to the published "
      "figures: accuracy.csv, gains.csv, quality.csv; comparisons.csv and ranks.csv (tests of "
      "significance); decisions.csv (decisions over several windows of a record, if A.h5 is "
      "there); confidence.csv (share of windows that can be answered); recommendation.csv (the "
      "method to use); tables.md and tables.tex (all of them, for people); summary.txt (results "
      "and recommendation in a small table and a few sentences). The requested methods, ratios "
      "and seeds must exist; the tables include all cells of the run. Prints the accuracies in "
      "percent. Lists may be several values, or one value with commas.",
      "tabulate --run results/try --dataset cwru --methods none piae-dt --ratios "
      "100to1 10to1 --seeds 0 1 --published results/published");
  run::GridOptions options;
  std::string against;
  fs::path run_folder;
  fs::path published_folder;
  bind(stage.options(), options);
  run::bind_classifiers(stage.options(), options.classifiers,
                        "if given, `none` also needs its cell of nearest; default: wdcnn");
  stage.options().add("--against", against,
                      "Method to compare all others with. Default: piae-dt-phase, otherwise "
                      "piae-dt, if it is among the methods; strike-twin first if faults are "
                      "known in other conditions than tested");
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");
  stage.input_file("--published", published_folder, "Folder of the paper's tables as CSV");

  std::vector<std::string> leave_out;
  run::bind_leave_out(stage.options(), leave_out);

  return stage.run(argc, argv, [&] {
    const run::Grid requested = run::resolve(options);
    const report::Published published(published_folder);
    const run::Layout layout(run_folder, requested.dataset);
    const run::Held held(layout, leave_out);
    auto [grid, results] = run::collect_held(layout, requested, held);
    run::require_all(results);
    const std::string left_out = report::left_out_line(results);
    if (!left_out.empty()) spdlog::warn(left_out);

    const auto rows = report::accuracy_rows(grid, results, published);
    const auto comparisons = report::compare_by_classifier(rows, against);
    const auto ranks = report::rank_by_classifier(rows);
    const report::Document tables =
        report::tables(grid, results, rows, published, comparisons, ranks,
                       report::twin_sections(layout, grid, held));
    text::save_all({{layout.accuracy_csv(), report::accuracy_csv(rows)},
                    {layout.gains_csv(), report::accuracy_csv(report::gain_rows(rows))},
                    {layout.quality_csv(), report::quality_csv(grid, results)},
                    {layout.comparisons_csv(), report::comparisons_csv(comparisons)},
                    {layout.ranks_csv(), report::ranks_csv(ranks)},
                    {layout.decisions_csv(), report::decisions_csv(rows, results)},
                    {layout.confidence_csv(), report::confidence_csv(rows, results)},
                    {layout.recommendation_csv(),
                     report::recommendation_csv(report::recommendations(rows, results))},
                    {layout.tables_markdown(), report::markdown(tables)},
                    {layout.tables_latex(), report::latex(tables)},
                    {layout.summary_text(), report::summary_text(grid, results, rows)}});
    std::cout << report::accuracy_text(rows)
              << fmt::format("tabulated {} diagnoses and {} scores: {}\n", results.diagnoses.size(),
                             results.qualities.size(), layout.tables_markdown().string());
  });
}
