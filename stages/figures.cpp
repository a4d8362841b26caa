// Writes the numbers of a run's figures as CSV files, which gnuplot draws.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>

#include "cli/stage.hpp"
#include "figures/catalogue.hpp"
#include "figures/files.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

bool save(figures::Source& source, const figures::Figure& figure) {
  try {
    for (const fs::path& file : save_pictures(source, figure)) {
      std::cout << "wrote " << file.filename().string() << '\n';
    }
    return true;
  } catch (const figures::LeftOut& reason) {
    std::cout << fmt::format("left out {}: {}\n", figure.name, reason.what());
  } catch (const Error& error) {
    if (error.exit() == Exit::failed) throw;  // such as a full disk: no other figure can be written
    spdlog::warn("{} is not drawn: {}", figure.name, error.what());
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "figures",
      "Writes the numbers of each figure of RUN/DATASET as RUN/DATASET/figures/NAME.csv, or "
      "NAME@PART.csv where it has several parts, from the artefacts there. A figure whose "
      "artefacts are missing is named and left out; the others are written. A file that would "
      "not change is left as it is.",
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
    for (const figures::Figure& figure : figures::catalogue()) written += save(source, figure);
    std::cout << fmt::format("wrote the numbers of {} of {} figures\n", written,
                             figures::catalogue().size());
  });
}
