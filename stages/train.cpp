// Learns a method for making fault windows from the known fault windows of a split.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "artefact/file.hpp"
#include "augment/method.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/stage.hpp"
#include "signal/roles.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "train",
      "Trains a generator on the known fault windows (paper, Sections 3.2 and 3.3) and "
      "writes its model: weights, curves, digital twin space. Every --method has "
      "options of its own: train --method piae-dt --help.",
      "train --method piae-dt --known seed0/C.h5 --seed 0 --output model.h5");
  std::string name = stage.choose_variant(argc, argv, "--method");
  std::int64_t seed = 0;
  std::string device = "cpu";
  fs::path known_file;
  fs::path model_file;
  stage.app()
      .add_option("--method", name,
                  "one of: " + fmt::format("{}", fmt::join(augment::method_names(), ", ")))
      ->required();
  stage.app()
      .add_option("--seed", seed, "the repeat; names the random streams")
      ->required()
      ->check(cli::natural_number());
  stage.app().add_option("--device", device, "cpu or cuda");
  stage.input_file("--known", known_file, "C.h5: the known fault windows, made by split");
  stage.output_file("--output", model_file,
                    "the model; FILE.checkpoint stands beside it meanwhile");
  std::unique_ptr<augment::Method> method;
  if (!name.empty()) {
    try {
      method = augment::make_method(name);
      method->bind(stage.app());
    } catch (const Error&) {
      // An unknown method is reported by run(), like every other error.
    }
  }

  return stage.run(argc, argv, [&] {
    if (!method) method = augment::make_method(name);
    const artefact::Reader reader = stage.open("known", known_file, "windows");
    signal::require_role(reader, "C");
    const signal::WindowSet known = signal::read_window_set(reader);
    signal::require_classes(reader, "C", known);
    const Stream stream(fmt::format("{}/seed{}/train/{}", known.info.name, seed, name));

    cli::catch_interrupts();
    nets::Checkpoint checkpoint;
    checkpoint.path = model_file.string() + ".checkpoint";
    checkpoint.provenance = stage.provenance();
    checkpoint.interrupted = cli::interrupted;
    artefact::Writer model("model");
    model.attribute("/", "method", name);
    model.attribute("/", "seed", seed);
    signal::write(model, signal::origin_of_known(reader));
    method->train(known, stream, device, checkpoint, model);
    stage.save(model, model_file);
    artefact::remove_file(checkpoint.path);
    std::cout << fmt::format("trained {} on {} windows of {} fault classes: {}\n", name,
                             known.size(), known.info.classes.size() - 1, model_file.string());
  });
}
