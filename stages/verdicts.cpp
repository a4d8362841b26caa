// Tabulates the verdicts of kept classifiers on each record: the tables of `make verdicts`.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "report/record_verdicts.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "verdicts",
      "Makes verdicts.csv and verdicts.md in RUN/DATASET from the classifications of the requested "
      "kept classifiers: who is right about which record, and by what evidence.",
      "verdicts --run results/try --dataset cwru-blind --methods none --ratios 100to1 --seeds 0 "
      "--classifiers envelope-rule exclusion-rule --nothing-known cwru-blind");
  run::GridOptions options;
  fs::path run_folder;
  fs::path others;
  bind(stage.options(), options);
  run::bind_classifiers(stage.options(), options.classifiers,
                        "if given, `none` also needs its cell of nearest; default: wdcnn");
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");
  stage
      .input_file("--others", others,
                  "Grades of the records and verdicts of others (CSV): record,grade,NAME,...")
      .required(false);

  return stage.run(argc, argv, [&] {
    const run::Grid grid = run::resolve(options);
    const run::Layout layout(run_folder, grid.dataset);
    const report::RecordVerdicts verdicts = report::record_verdicts(layout, grid, others);
    text::save_all(
        {{layout.verdicts_csv(), report::verdicts_csv(verdicts)},
         {layout.verdicts_markdown(), report::markdown(report::verdicts_document(verdicts))}});
    std::cout << fmt::format("tabulated {} judges on {} records: {}\n", verdicts.judges.size(),
                             verdicts.records.size(), layout.verdicts_markdown().string());
  });
}
