// Trains a method on the known fault windows of a split, to generate fault windows.

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <iostream>

#include "artefact/file.hpp"
#include "augment/catalogue.hpp"
#include "cli/interrupt.hpp"
#include "cli/run_options.hpp"
#include "cli/stage.hpp"
#include "seam/libtorch.hpp"
#include "signal/roles.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "train",
      "Trains a generator on the known fault windows (paper, Sections 3.2 and 3.3) and writes "
      "its model: weights, curves, digital twin space. Each --method has its own options: see "
      "train --method piae-dt --help.",
      "train --method piae-dt --known seed0/C.h5 --seed 0 --output model.h5");
  std::string name = stage.choose_variant(argc, argv, "--method");
  cli::RunOptions run;
  fs::path known_file;
  fs::path real_file;
  fs::path healthy_file;
  fs::path model_file;
  stage.options()
      .add("--method", name,
           "method that makes fault windows, one of: " +
               fmt::format("{}", fmt::join(augment::method_names(), ", ")))
      .required();
  bind(stage.options(), run);
  stage.input_file("--known", known_file, "known fault windows, C.h5 of split");
  stage.output_file("--output", model_file,
                    "trained model, model.h5; FILE.checkpoint exists next to it during training");
  std::unique_ptr<augment::Method> method;
  const augment::CatalogueEntry* const entry = augment::find_entry(name);
  if (entry != nullptr && entry->make != nullptr) {
    method = augment::make_method(name);
    method->bind(stage.options().in_group(name));
    if (method->learns_from() == augment::LearnsFrom::real) {
      stage.input_file("--real", real_file,
                       "hidden real windows, D.h5 of split; for ceilings only");
    }
    if (entry->healthy != augment::Healthy::unused) {
      const bool required = entry->healthy == augment::Healthy::required;
      stage
          .input_file("--healthy", healthy_file,
                      required ? "healthy windows, B.h5 of split"
                               : "healthy windows for --background-from healthy, B.h5 of split")
          .required(required);
    }
  }

  cli::catch_interrupts();
  return stage.run(argc, argv, [&] {
    if (!method) method = augment::make_method(name);
    if (method->needs_libtorch(run.compute)) {
      cli::hold_interrupts();
      seam::continue_with_libtorch(argv);
    }
    const artefact::Reader reader = stage.open("known", known_file, "windows");
    signal::require_role(reader, signal::Role::known);
    signal::WindowSet windows = signal::read_window_set(reader);
    signal::require_belonging(reader, signal::Role::known, windows);
    augment::require_described_faults(*entry, windows.info, known_file.string());
    augment::require_known_windows(*entry, windows, known_file.string());
    if (method->learns_from() == augment::LearnsFrom::real) {
      windows = signal::read_of_one_split(stage.open("real", real_file, "windows"),
                                          signal::Role::hidden, reader);
    }
    if (!healthy_file.empty()) {
      method->use_healthy(signal::read_of_one_split(stage.open("healthy", healthy_file, "windows"),
                                                    signal::Role::healthy, reader));
    }
    const Stream stream(fmt::format("{}/seed{}/train/{}", windows.info.name, run.seed, name));

    const nets::Checkpoint checkpoint{.path = model_file.string() + ".checkpoint",
                                      .provenance = stage.provenance(),
                                      .interrupted = cli::interrupted};
    artefact::require_replaceable(model_file);
    artefact::require_replaceable(checkpoint.path);
    artefact::Writer model("model");
    model.attribute("/", "method", name);
    model.attribute("/", "seed", run.seed);
    signal::write(model, signal::origin_of_known(reader));
    method->train(windows, stream, run.compute, checkpoint, model);
    stage.save(model, model_file);
    artefact::remove_file(checkpoint.path);
    std::cout << fmt::format("trained {} on {}{}: {}\n", name, augment::counted_faults(windows),
                             method->remark(), model_file.string());
  });
}
