// Writes the numbers of a run's figures as CSV files, which gnuplot draws.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>

#include "artefact/file.hpp"
#include "cli/stage.hpp"
#include "figures/catalogue.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

/// Writes one figure's numbers. Those of an earlier run are removed where they cannot be made
/// again, so that no picture shows what is no longer so.
bool write(const figures::Figure& figure, figures::Source& source) {
  const fs::path file = source.layout().figure_csv(figure.name);
  try {
    text::save_if_changed({file, figure.numbers(source).csv()});
    std::cout << "wrote " << file.filename().string() << '\n';
    return true;
  } catch (const figures::LeftOut& reason) {
    std::cout << fmt::format("left out {}: {}\n", figure.name, reason.what());
  } catch (const Error& error) {
    spdlog::warn("{} is not drawn: {}", figure.name, error.what());
  }
  artefact::remove_file(file);
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "figures",
      "Writes the numbers of each figure of RUN/DATASET as RUN/DATASET/figures/NAME.csv, "
      "from the artefacts there. A figure whose artefacts are missing is named and left "
      "out; the others are written. A file that would not change is left as it is.",
      "figures --run results/try --dataset cwru --methods none piae-dt --ratios 100to1 "
      "10to1 --seeds 0 1 --published results/published");
  run::GridOptions options;
  fs::path run_folder;
  fs::path published_folder;
  bind(stage.options(), options);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");
  stage.input_file("--published", published_folder, "Folder of the paper's tables as CSV");

  return stage.run(argc, argv, [&] {
    const run::Grid grid = run::resolve(options);
    figures::Source source({run_folder, grid.dataset}, grid, report::Published(published_folder));
    std::size_t written = 0;
    for (const figures::Figure& figure : figures::catalogue()) written += write(figure, source);
    std::cout << fmt::format("wrote the numbers of {} of {} figures\n", written,
                             figures::catalogue().size());
  });
}
