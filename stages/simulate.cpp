// Simulates the records of a data set, or an endless signal of one machine.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>

#include "cli/progress.hpp"
#include "cli/stage.hpp"
#include "signal/machine.hpp"
#include "signal/raw_output.hpp"
#include "signal/simulation.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

/// Writes the samples of a machine while they are simulated.
void stream_to(const fs::path& output, const signal::Simulation& simulation,
               const std::string& class_name, const signal::MachineOptions& options) {
  signal::Machine machine(simulation, class_name, options);
  signal::RawOutput raw(output);
  for (std::vector<float> samples; !(samples = machine.next()).empty();) raw.write(samples);
  raw.close();
  spdlog::info("{} samples of float32 at {:g} Hz: {}", machine.samples(),
               simulation.info.sample_rate_hz, output.string());
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("simulate",
                   "Simulates the vibration of healthy and faulty bearings (paper, Section 3.1, "
                   "eqs 5 to 13).\nThe description gives bearing, classes, distributions of "
                   "stiffness and damping, slip and noise.\nWith --stream it simulates one "
                   "running machine, in which a defect may appear. The output is raw samples: "
                   "float32 in m/s^2, in the byte order of this machine, without a header.",
                   "simulate --description pipeline/datasets/simulated.toml --output records.h5\n"
                   "  simulate --description pipeline/datasets/simulated.toml --stream OR007 "
                   "--duration-s 60 --appears-at-s 30 --output -");
  fs::path description;
  fs::path output;
  std::string class_name;
  signal::MachineOptions machine;
  stage.input_file("--description", description,
                   "Data set description (TOML) with a table [simulation]");
  stage.output_file("--output", output,
                    "recordings, records.h5; with --stream the raw samples (-: standard output)");
  const cli::Options streaming = stage.options().in_group("One machine");
  streaming.add("--stream", class_name,
                "simulate one machine with the defect of this class, or the healthy class");
  bind(streaming, machine);
  for (const char* option : {"--stream", "--duration-s", "--appears-at-s", "--drift-s", "--seed"}) {
    stage.record_unless_default(option);
  }

  return stage.run(argc, argv, [&] {
    const signal::Simulation simulation = signal::read_simulation(description);
    if (!class_name.empty()) return stream_to(output, simulation, class_name, machine);
    if (machine != signal::MachineOptions{}) {
      throw Error(Exit::usage,
                  "--duration-s, --appears-at-s, --drift-s and --seed need --stream CLASS (the "
                  "description gives the seed of records)");
    }
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
