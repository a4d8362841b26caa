// Compares the stiffness and damping that trained models infer with the true ones.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "augment/catalogue.hpp"
#include "cli/stage.hpp"
#include "report/identifiability.hpp"
#include "run/held.hpp"
#include "run/layout.hpp"
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
                 fmt::format("has method {}, seed {}, but must have {}, seed {}",
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

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "identify",
      "Makes identifiability.csv, scatter.csv and identifiability.md in RUN/DATASET: agreement "
      "of the stiffness and damping that models infer from the unseen windows D with the values "
      "of the simulation (R², bias, correlation², a scatter table). The models of the requested "
      "methods and seeds must exist; the tables include all models of the run.",
      "identify --run results/try --dataset simulated --methods piae-dt --seeds 0 1");
  report::IdentifiabilityOptions options;
  fs::path run_folder;
  std::vector<std::string> leave_out;
  bind(stage.options(), options);
  run::bind_leave_out(stage.options(), leave_out);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");

  return stage.run(argc, argv, [&] {
    const run::Grid requested = report::resolve(options);
    const run::Layout layout(run_folder, requested.dataset);
    std::vector<report::Identification> all;
    for (const run::CellName& model :
         held_models(layout, requested, run::Held(layout, leave_out))) {
      all.push_back(identify(layout, model.method, model.seed));
    }
    const auto rows = report::identifiability_rows(all);
    const report::Document document =
        report::identifiability_document(requested.dataset, rows, all);
    text::save_all(
        {{layout.identifiability_csv(), report::identifiability_csv(requested.dataset, rows)},
         {layout.scatter_csv(), report::scatter_csv(requested.dataset, all)},
         {layout.identifiability_markdown(), report::markdown(document)}});
    std::cout << fmt::format("compared (k, c) of {} models with the truth: {}\n", all.size(),
                             layout.identifiability_markdown().string());
  });
}
