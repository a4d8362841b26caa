// Makes fault windows with a trained model.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "augment/stored_model.hpp"
#include "cli/run_options.hpp"
#include "cli/stage.hpp"
#include "seam/libtorch.hpp"
#include "signal/roles.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage("generate",
                   "Generates windows of each fault class with a trained model (paper, eqs 15 "
                   "and 26) and writes them as windows E. Stores the (k, c), the tested "
                   "condition and the impacts of each window if the method knows them. The first "
                   "n windows of a class do not depend on --count.",
                   "generate --model model.h5 --count 495 --seed 0 --output E.h5");
  std::size_t count = 495;
  cli::RunOptions run;
  fs::path model_file;
  fs::path output;
  stage.options()
      .add("--count", count, "windows of each fault class")
      .check(cli::whole_number(1, 1000000));
  bind(stage.options(), run);
  stage.input_file("--model", model_file, "trained model, model.h5 of train");
  stage.output_file("--output", output, "generated windows, E.h5");

  return stage.run(argc, argv, [&] {
    const artefact::Reader model = stage.open("model", model_file, "model");
    const std::string name = model.text("/", "method");
    const std::unique_ptr<augment::Method> method = augment::method_of(model);
    if (method->needs_libtorch(run.compute)) seam::continue_with_libtorch(argv);
    const std::string dataset = model.text("/", "dataset");
    const Stream stream(fmt::format("{}/seed{}/generate/{}", dataset, run.seed, name));
    const signal::WindowSet windows =
        augment::generate_with(*method, model, count, stream, run.compute);

    artefact::Writer writer("windows");
    signal::write(writer, windows);
    writer.attribute("/", "role", std::string("E"));
    writer.attribute("/", "method", name);
    writer.attribute("/", "seed", run.seed);
    signal::write(writer, signal::read_origin(model));
    stage.save(writer, output);
    std::cout << fmt::format("generated {} windows with {}: {}\n", windows.size(), name,
                             output.string());
  });
}
