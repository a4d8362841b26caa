// Makes the tables of the interpretations of the paper from their cells.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "readings/measure.hpp"
#include "readings/reading.hpp"
#include "readings/tables.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "readings",
      "Makes readings.csv and readings.md in RUN/DATASET for interpretations of the paper: "
      "settings of piae-dt that its text leaves open. For each: accuracy, also of nearest on "
      "spectra; quality of the generated windows; losses, their weights and the distance of the "
      "weights from the stationary point of eq. 23; stiffness and damping, and their true values "
      "if windows are simulated. The cells are in seedK/readings/NAME.",
      "readings --run results/readings --dataset cwru --readings batches=class "
      "--ratios 10to1 1to1 --seeds 100 101 --published results/published");
  readings::ReadingsOptions options;
  fs::path run_folder;
  fs::path published_folder;
  bind(stage.options(), options);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/readings");
  stage.input_file("--published", published_folder, "Folder of the paper's tables as CSV");

  return stage.run(argc, argv, [&] {
    const readings::Readings requested = readings::resolve(options);
    const report::Published published(published_folder);
    const run::Layout layout(run_folder, requested.grid.dataset);
    cli::Progress progress("readings", "readings", requested.readings.size());
    std::vector<readings::Row> rows;
    for (const readings::Reading& reading : requested.readings) {
      std::vector<std::vector<readings::Measured>> by_seed;
      for (const std::int64_t seed : requested.grid.seeds) {
        by_seed.push_back(measure(layout, requested, reading, seed));
      }
      const auto own = rows_of(reading, by_seed);
      rows.insert(rows.end(), own.begin(), own.end());
      progress.update(static_cast<std::size_t>(&reading - requested.readings.data()) + 1,
                      reading.name);
    }
    const auto of_paper = readings::published_rows(requested.grid, published);
    rows.insert(rows.end(), of_paper.begin(), of_paper.end());
    const std::string tables = report::markdown(document(requested, rows));
    text::save_all({{layout.readings_csv(), csv(requested.grid.dataset, rows)},
                    {layout.readings_markdown(), tables}});
    std::cout << fmt::format("tabulated {} interpretations: {}\n", requested.readings.size(),
                             layout.readings_markdown().string());
  });
}
