// Makes the table of a hyper-parameter sweep from its diagnoses.

#include "report/sweep.hpp"

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "sweep",
      "Makes sweep.csv and sweep.md in RUN/DATASET from the diagnoses of a sweep, in which one "
      "setting of piae-dt at a time is moved (paper, Section 4.5.5 and Fig. 19). They lie in "
      "seedK/sweep/FACTOR-VALUE/RATIO, those of --centre in seedK/piae-dt/RATIO. The ratios and "
      "seeds that are named must be there; the tables have all that the run holds. Lists may be "
      "several values, or one with commas.",
      "sweep --run results/try --dataset cwru --points batch=1 batch=5 --centre batch=5 "
      "--ratios 1to1 --seeds 0 1");
  report::SweepOptions options;
  fs::path run_folder;
  std::vector<std::string> leave_out;
  bind(stage.options(), options);
  run::bind_leave_out(stage.options(), leave_out);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");

  return stage.run(argc, argv, [&] {
    const report::Sweep sweep = report::resolve(options);
    const run::Layout layout(run_folder, sweep.grid.dataset);
    run::Results results;
    const auto rows = report::sweep_rows(layout, sweep, run::Held(layout, leave_out), results);
    run::require_all(results);

    const std::string tables = report::markdown(report::sweep_document(sweep, rows, results));
    text::save_all(
        {{layout.sweep_csv(), report::sweep_csv(sweep, rows)}, {layout.sweep_markdown(), tables}});
    std::cout << fmt::format("tabulated {} diagnoses of {} settings: {}\n",
                             results.diagnoses.size(), sweep.points.size(),
                             layout.sweep_markdown().string());
  });
}
