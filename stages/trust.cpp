// Measures how far kept classifiers can be trusted: the tables of `make trust`.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "report/trust_table.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "trust",
      "Makes trust.csv and trust.md in RUN/DATASET for the requested classifiers of `diagnose "
      "--keep-classifier`: how often they are correct at a given confidence, and whether they "
      "notice a fault that was not trained.",
      "trust --run results/try --dataset cwru --methods none shift --ratios 100to1 1to1 "
      "--seeds 0 1");
  run::GridOptions options;
  fs::path run_folder;
  bind(stage.options(), options);
  run::bind_classifiers(stage.options(), options.classifiers,
                        "if given, `none` also needs its cell of nearest; default: wdcnn");
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");

  return stage.run(argc, argv, [&] {
    const run::Grid grid = run::resolve(options);
    const run::Layout layout(run_folder, grid.dataset);
    const auto rows = report::trust_rows(layout, grid);
    text::save_all(
        {{layout.trust_csv(), report::trust_csv(grid.dataset, rows)},
         {layout.trust_markdown(), report::markdown(report::trust_document(grid.dataset, rows))}});
    std::cout << fmt::format("tabulated {} kept classifiers: {}\n", rows.size() * grid.seeds.size(),
                             layout.trust_markdown().string());
  });
}
