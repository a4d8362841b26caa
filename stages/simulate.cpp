#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "signal/simulation.hpp"

int main(int argc, char** argv) {
  using namespace piae;
  cli::Stage stage("simulate",
                   "Simulates the vibration of healthy and faulty bearings (paper, section 3.1, "
                   "eqs 5 to 13).\nBearing, classes, distributions of stiffness and damping, slip "
                   "and noise stand in the description.",
                   "simulate --description pipeline/datasets/simulated.toml --output records.h5");
  std::filesystem::path description;
  std::filesystem::path output;
  stage.input_file("--description", description, "dataset description with a table [simulation]");
  stage.output_file("--output", output, "records.h5 to write");
  return stage.run(argc, argv, [&] {
    const signal::Simulation simulation = signal::read_simulation(description);
    stage.note_input("description", description);
    const std::size_t records = simulation.records();
    signal::Recordings recordings;
    {
      cli::Progress progress("simulate", "records", records);
      recordings = signal::simulate(simulation, [&](std::size_t done) { progress.update(done); });
    }
    artefact::Writer writer("records");
    signal::write(writer, recordings);
    stage.save(writer, output);
    std::cout << fmt::format("simulate: {} records of {} samples at {:g} Hz: {}\n", records,
                             simulation.samples, simulation.info.sample_rate_hz, output.string());
  });
}
