// Teaches the network of any-bearing on simulated machines.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/checks.hpp"
#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "diagnosis/any_bearing.hpp"
#include "machines/lessons.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "teach",
      "Teaches a small network to tell healthy windows and fault types apart on any machine, from "
      "simulated machines alone: random bearings, speeds, structures and noise, with faults by the "
      "twin of piae-dt-zero and noise of worn surfaces. diagnose --classifier any-bearing and "
      "classify fit it to a machine by healthy windows.",
      "teach --config pipeline/protocol.toml --output results/reference/any-bearing.h5");
  machines::LessonOptions options;
  std::int64_t seed = 0;
  fs::path output;
  stage.options()
      .add("--machines", options.machines, "simulated machines; each gives 40 windows")
      .check(cli::whole_number(1, 1'000'000));
  stage.options()
      .add("--prewhitening", options.prewhitening,
           "power of a spectrum's own amplitude that divides it; 1: cepstral prewhitening")
      .check(cli::within(symptoms::possible_prewhitening));
  stage.options()
      .add("--seed", seed, "selects the random streams")
      .check(cli::whole_number(0, 1'000'000));
  const cli::StoredOptions wear = table_of(options.wear);
  wear.bind(stage.options());
  stage.output_file("--output", output, "network for all machines, any-bearing.h5");

  return stage.run(argc, argv, [&] {
    wear.require_order();
    const Stream stream(fmt::format("teach/seed{}", seed));
    cli::Progress progress("teach", "machines", static_cast<std::size_t>(options.machines));
    const machines::Lessons lessons = draw_lessons(
        options, stream.child("machines"), [&](std::size_t done) { progress.update(done); });
    const diagnosis::AnyBearingNetwork network(lessons.symptoms, lessons.labels,
                                               options.prewhitening, stream.child("network"));
    artefact::Writer writer("any-bearing");
    network.write(writer);
    wear.write(writer);
    writer.attribute("/", "machines", static_cast<std::int64_t>(options.machines));
    writer.attribute("/", "seed", seed);
    stage.save(writer, output);
    std::cout << fmt::format(
        "taught {} windows of {} machines, {:.1f} % correct in the last epoch: "
        "{}\n",
        lessons.labels.size(), options.machines, 100 * network.training().train_accuracy.back(),
        output.string());
  });
}
