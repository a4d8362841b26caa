// Makes the table of a sweep from its diagnoses: of hyper-parameters, or of the effect of parts.

#include "report/sweep.hpp"

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "report/parts.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

/// Both tables of a sweep: for programs, and for people.
struct Tables {
  std::string csv;
  report::Document document;
};

Tables tables_of(const report::Sweep& sweep, const std::vector<report::SweepRow>& rows,
                 const run::Results& results) {
  if (sweep.method == augment::paper_method()) {
    return {report::sweep_csv(sweep, rows), report::sweep_document(sweep, rows, results)};
  }
  const std::vector<report::PartRow> parts = report::part_rows(rows);
  return {report::parts_csv(sweep, parts), report::parts_document(sweep, parts, results)};
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "sweep",
      "Makes sweep.csv and sweep.md in RUN/DATASET from the diagnoses of a sweep, which changes "
      "one setting of piae-dt at a time (paper, Section 4.5.5 and Fig. 19). The diagnoses are in "
      "seedK/sweep/FACTOR-VALUE/RATIO/CLASSIFIER, those of --centre in "
      "seedK/piae-dt/RATIO/CLASSIFIER. With another --method all names have sweep@METHOD, and "
      "the tables show the effect of each of its parts. The requested ratios and seeds must "
      "exist; the tables include all cells of the run. Lists may be several values, or one value "
      "with commas.",
      "sweep --run results/try --dataset cwru --points batch=1 batch=5 --centre batch=5 "
      "--ratios 1to1 --seeds 0 1");
  (void)stage.choose_variant(argc, argv, "--method");
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

    const Tables tables = tables_of(sweep, rows, results);
    const fs::path markdown = layout.sweep_markdown(sweep.method);
    text::save_all({{layout.sweep_csv(sweep.method), tables.csv},
                    {markdown, report::markdown(tables.document)}});
    std::cout << fmt::format("tabulated {} diagnoses of {} settings: {}\n",
                             results.diagnoses.size(), sweep.points.size(), markdown.string());
  });
}
