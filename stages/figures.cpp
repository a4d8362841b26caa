// Writes the numbers of a run's figures as CSV files, which gnuplot draws.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>

#include "cli/stage.hpp"
#include "figures/catalogue.hpp"
#include "figures/files.hpp"
#include "report/gaps.hpp"
#include "run/started.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

bool save(figures::Source& source, const figures::Figure& figure) {
  const bool was_drawn = !stored_pictures(source.layout(), figure).empty();
  try {
    for (const fs::path& file : save_pictures(source, figure)) {
      std::cout << "wrote " << file.filename().string() << '\n';
    }
    return true;
  } catch (const figures::LeftOut& reason) {
    std::cout << fmt::format("left out {}: {}\n", figure.name, reason.what());
  } catch (const Error& error) {
    if (error.exit() == Exit::failed)
      throw;  // such as a full disk: then the other figures cannot be written, either
    spdlog::warn("{} is not drawn: {}", figure.name, error.what());
    if (was_drawn) spdlog::warn("the old picture of {} is removed", figure.name);
  }
  return false;
}

run::Grid requested_cells(const run::Layout& layout, const run::GridOptions& options) {
  const bool nothing = options.methods.empty() && options.ratios.empty() && options.seeds.empty() &&
                       options.classifiers.empty();
  if (!nothing) return run::Started(layout).resolve(options);
  return {.dataset = options.dataset, .scored = {}, .combinations = {}, .seeds = {}};
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "figures",
      "Writes the numbers of each figure of RUN/DATASET to RUN/DATASET/figures/NAME.csv, or to "
      "NAME@PART.csv if it has several parts. Reports and leaves out a figure with missing "
      "artefacts, and writes the others. Does not touch a file that would not change. The "
      "requested methods, ratios and seeds must exist; the figures include all cells of the run. "
      "If nothing is requested, no cell is required.",
      "figures --run results/try --dataset cwru --methods none piae-dt --ratios 100to1 "
      "10to1 --seeds 0 1 --published results/published");
  run::GridOptions options{};
  fs::path run_folder;
  fs::path published_folder;
  fs::path costs_file;
  std::vector<std::string> leave_out;
  stage.options().add("--dataset", options.dataset, "Data set, such as cwru").required();
  run::bind_started_cells(stage.options(), options);
  run::bind_leave_out(stage.options(), leave_out);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");
  stage.input_file("--published", published_folder, "Folder of the paper's tables as CSV");
  stage
      .input_file("--costs", costs_file,
                  "processor time of steps, jobs/costs.csv, for the figure cost")
      .required(false);

  return stage.run(argc, argv, [&] {
    const run::Layout layout(run_folder, options.dataset);
    figures::Source source(
        layout, requested_cells(layout, options), report::Published(published_folder), leave_out,
        costs_file.empty() ? std::vector<run::StepCost>{} : run::read_costs(costs_file));
    std::size_t written = 0;
    for (const figures::Figure& figure : figures::catalogue()) written += save(source, figure);
    const std::string left_out = report::left_out_line(source.results());
    if (!left_out.empty()) spdlog::warn(left_out);
    std::cout << fmt::format("wrote the numbers of {} of {} figures\n", written,
                             figures::catalogue().size());
  });
}
