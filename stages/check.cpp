// Compares a run with the stored reference, or makes the run the reference.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <span>

#include "artefact/file.hpp"
#include "cli/stage.hpp"
#include "regression/deviations_text.hpp"
#include "regression/run_measurements.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void store(const std::vector<regression::Measurements>& run, const fs::path& folder) {
  for (const regression::Measurements& measurements : run) {
    const fs::path path =
        regression::reference_file(folder, measurements.protocol, measurements.dataset);
    const std::string text = regression::reference_csv(measurements);
    artefact::write_file_atomically(path, std::as_bytes(std::span(text)));
    std::cout << fmt::format("stored {} numbers of {}: {}\n", measurements.values.size(),
                             measurements.dataset, path.string());
  }
}

/// Adds each data set that only the reference has, without values, so that its cells count as
/// missing.
void add_missing(std::vector<regression::Measurements>& run, const fs::path& folder,
                 const run::Selection& selection) {
  const signal::Protocol protocol = run.front().protocol;
  for (const std::string& dataset : regression::reference_datasets(folder, protocol)) {
    if (selection.has_dataset(dataset) &&
        std::ranges::find(run, dataset, &regression::Measurements::dataset) == run.end()) {
      run.push_back({.dataset = dataset, .protocol = protocol});
    }
  }
}

/// Prints the deviations of the run from the reference. Returns true if they are acceptable.
/// Without a given tolerance, chooses the one that fits the settings of both.
bool check_dataset(const regression::Measurements& run, const fs::path& folder,
                   const run::Selection& selection,
                   std::optional<regression::Tolerance> tolerance) {
  const auto reference = regression::read_reference(folder, run.protocol, run.dataset);
  const auto chosen = tolerance.value_or(regression::tolerance_for(reference, run));
  const regression::Deviations deviations =
      regression::find_deviations(reference, run, selection, chosen);
  std::cout << regression::deviations_text(reference, run, chosen, deviations);
  return deviations.acceptable();
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "check",
      "Compares the accuracies and scores of a run with the stored reference, cell by cell, and "
      "prints each change in standard errors. Exits with 1 if a cell is missing on one side, or if "
      "a value differs by more than the tolerance. With the same processor, threads, compiler and "
      "libraries, numbers must be equal; otherwise their means must agree within the spread over "
      "the seeds.",
      "check --run results/try --reference results/reference --datasets cwru --seeds 0 1");
  fs::path run_folder;
  fs::path reference_folder;
  run::Selection selection;
  std::optional<regression::Tolerance> tolerance;
  bool as_reference = false;
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");
  stage.input_file("--reference", reference_folder, "Folder of the reference");
  bind(stage.options(), selection);
  stage.options().choose("--tolerance", tolerance,
                         {{"auto", std::nullopt},
                          {"exact", regression::Tolerance::exact},
                          {"spread", regression::Tolerance::spread}},
                         "exact, spread, or auto: exact if processor and libraries are the same");
  stage.options().flag("--store", as_reference,
                       "Store these cells of the run as the reference instead of comparing them");

  return stage.run(argc, argv, [&] {
    std::vector<regression::Measurements> run = regression::read_run(run_folder, selection);
    if (as_reference) return store(run, reference_folder);
    add_missing(run, reference_folder, selection);
    std::size_t failed = 0;
    for (const regression::Measurements& measurements : run) {
      if (!check_dataset(measurements, reference_folder, selection, tolerance)) ++failed;
    }
    if (failed == 0) return;
    throw Error(Exit::failed,
                fmt::format("{} differs from the reference on {} of {} data sets, see above (name "
                            "data sets, methods, ratios or seeds to compare a part; after an "
                            "intended change, run `make reference`)",
                            run_folder.string(), failed, run.size()));
  });
}
