// Compares the stiffness and damping that trained models infer with the true ones.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iostream>

#include "augment/catalogue.hpp"
#include "cli/stage.hpp"
#include "report/identifiability.hpp"
#include "run/layout.hpp"
#include "seam/libtorch.hpp"
#include "signal/roles.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

report::Identification identify(const run::Layout& layout, const std::string& method,
                                std::int64_t seed) {
  const artefact::Reader model(layout.model(method, seed), "model");
  const artefact::Reader real(layout.real_windows(seed), "windows");
  if (model.text("/", "method") != method || model.integer("/", "seed") != seed) {
    model.refuse("/",
                 fmt::format("is of method {}, seed {}; here it must be {}, seed {}",
                             model.text("/", "method"), model.integer("/", "seed"), method, seed));
  }
  signal::require_role(real, signal::Role::hidden);
  signal::require_same_split(model, real);
  signal::WindowSet windows = signal::read_window_set(real);
  auto inferred = augment::make_method(method)->infer(model, windows, {});
  return {.method = method,
          .seed = seed,
          .windows = std::move(windows),
          .inferred = std::move(inferred)};
}

bool needs_libtorch(const run::Grid& grid) {
  return std::ranges::any_of(grid.combinations, [](const run::Combination& cell) {
    return augment::make_method(cell.method)->needs_libtorch({});
  });
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "identify",
      "Makes identifiability.csv, scatter.csv and identifiability.md in RUN/DATASET: how well the "
      "stiffness and damping that models infer of the windows D, which they have not seen, agree "
      "with those that the windows were simulated with (R², bias, correlation², a scatter table).",
      "identify --run results/try --dataset simulated --methods piae-dt --seeds 0 1");
  report::IdentifiabilityOptions options;
  fs::path run_folder;
  bind(stage.options(), options);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");

  return stage.run(argc, argv, [&] {
    const run::Grid grid = report::resolve(options);
    if (needs_libtorch(grid)) seam::continue_with_libtorch(argv);
    const run::Layout layout(run_folder, grid.dataset);
    std::vector<report::Identification> all;
    for (const run::Combination& combination : grid.combinations) {
      for (const std::int64_t seed : grid.seeds) {
        all.push_back(identify(layout, combination.method, seed));
      }
    }
    const auto rows = report::identifiability_rows(all);
    const report::Document document = report::identifiability_document(grid.dataset, rows, all);
    text::save_all({{layout.identifiability_csv(), report::identifiability_csv(grid.dataset, rows)},
                    {layout.scatter_csv(), report::scatter_csv(grid.dataset, all)},
                    {layout.identifiability_markdown(), report::markdown(document)}});
    std::cout << fmt::format("compared (k, c) of {} models with the truth: {}\n", all.size(),
                             layout.identifiability_markdown().string());
  });
}
