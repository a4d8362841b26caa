// Makes the tables of a run from its diagnoses and scores.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>
#include <span>

#include "artefact/file.hpp"
#include "cli/stage.hpp"
#include "report/markdown.hpp"
#include "report/quality_table.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void save_text(const fs::path& path, const std::string& text) {
  artefact::write_file_atomically(path, std::as_bytes(std::span(text)));
}

/// A table with a hole in it is no table: every missing or refused cell is named, and that is all.
void require_all(const report::Results& results) {
  if (results.problems.empty()) return;
  for (const std::string& problem : results.problems) spdlog::error(problem);
  throw Error(
      results.exit,
      fmt::format("{} of the files that the tables need {} missing or refused; no table was "
                  "written (make the cells named above, or ask for fewer)",
                  results.problems.size(), results.problems.size() == 1 ? "is" : "are"));
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "tabulate",
      "Makes accuracy.csv, quality.csv and tables.md in RUN/DATASET from the diagnoses "
      "and scores there, with the published figures beside ours, and prints the "
      "accuracies in percent. Lists may be several values, or one with commas.",
      "tabulate --run results/try --dataset cwru --methods none piae-dt --ratios "
      "100to1 10to1 --seeds 0 1 --published results/published");
  report::GridOptions options;
  fs::path run;
  fs::path published_folder;
  bind(stage.app(), options);
  stage.input_file("--run", run, "Folder of the run, such as results/try");
  stage.input_file("--published", published_folder, "Folder of the paper's tables as CSV");

  return stage.run(argc, argv, [&] {
    const report::Grid grid = report::resolve(options);
    const report::Published published(published_folder);
    const report::Layout layout(run, grid.dataset);
    const report::Results results = report::collect(layout, grid);
    require_all(results);

    const auto rows = report::accuracy_rows(grid, results, published);
    const std::string quality = report::quality_csv(grid, results);
    const std::string tables = report::tables_markdown(grid, results, rows, published);
    save_text(layout.accuracy_csv(), report::accuracy_csv(rows));
    save_text(layout.quality_csv(), quality);
    save_text(layout.tables_markdown(), tables);
    std::cout << report::accuracy_text(rows)
              << fmt::format("tabulated {} diagnoses and {} scores: {} {} {}\n",
                             results.diagnoses.size(), results.qualities.size(),
                             layout.accuracy_csv().string(), layout.quality_csv().string(),
                             layout.tables_markdown().string());
  });
}
