#include "storm/targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "classification/verdict.hpp"
#include "diagnosis/fitting_signal.hpp"
#include "raw/file.hpp"
#include "raw/lvm.hpp"
#include "raw/npy.hpp"
#include "raw/sound.hpp"
#include "raw/tdms.hpp"
#include "raw/uff.hpp"
#include "report/paper.hpp"
#include "settings/protocol.hpp"
#include "settings/sweeps.hpp"
#include "signal/description.hpp"
#include "signal/simulation.hpp"
#include "storm/files.hpp"
#include "storm/program.hpp"
#include "verification/verify.hpp"

namespace piae::storm {

namespace {

namespace fs = std::filesystem;

void read_mat(const fs::path& file) {
  (void)raw::read_mat(file, "x");
  (void)raw::read_mat(file, "n");
}

void read_csv(const fs::path& file) { (void)raw::read_csv(file, "1"); }

void read_hdf5(const fs::path& file) { (void)raw::read_hdf5(file, "/x"); }

void read_sound(const fs::path& file) { (void)raw::read_sound(file, "1"); }

void read_tdms(const fs::path& file) {
  (void)raw::read_tdms(file, "rig/n");
  (void)raw::read_tdms(file, "2");
}

void read_uff(const fs::path& file) { (void)raw::read_uff(file, "2"); }

void read_lvm(const fs::path& file) {
  (void)raw::read_lvm(file, "1");
  (void)raw::read_lvm(file, "y");
}

void read_npy(const fs::path& file) { (void)raw::read_npy(file, "1"); }

void read_description(const fs::path& file) { (void)signal::read_description(file); }

void read_simulation(const fs::path& file) { (void)signal::read_simulation(file); }

void read_protocol(const fs::path& file) {
  const toml::table protocol = settings::read_protocol(file);
  (void)settings::sweeps(protocol);
  (void)settings::readings(protocol);
  (void)settings::base_of_readings(protocol);
}

/// Reads the published accuracies: three files, of which the other two are good.
void read_published(const fs::path& file) { (void)report::Published(file.parent_path()); }

bool is_classifier(const fs::path& file) {
  return file.filename().string().find("classifier.") != std::string::npos;
}

constexpr double recorded_hz = 12000;
constexpr double recorded_rpm = 1797;

/// Returns two windows that resemble no class.
std::vector<double> recorded_samples() {
  std::vector<double> samples;
  samples.reserve(2048);
  for (int i = 0; i < 2048; ++i) samples.push_back(std::sin(i / 3.0) + i % 7);
  return samples;
}

/// Classifies the windows of a recording as `classify` does.
void load_classifier(const fs::path& file) {
  diagnosis::KeptClassifier kept(artefact::Reader(file, "classifier"));
  diagnosis::require_fitting_signal(kept.classifier(), kept.info(), recorded_hz, recorded_rpm,
                                    file.string());
  const classification::Recording recording{.name = file.string(),
                                            .shaft_speed_rpm = recorded_rpm,
                                            .true_class = "",
                                            .signal = recorded_samples()};
  (void)classification::judge(recording, kept, kept.length());
}

/// Verifies an artefact. For a model `verify` also generates windows; a classifier also gets some
/// to classify.
void read_artefact(const fs::path& file) {
  const std::vector<verification::Finding> findings = verification::verify({file});
  if (!findings.empty()) throw Error(Exit::bad_input, findings.front().line);
  if (is_classifier(file)) load_classifier(file);
}

constexpr std::array<Target, 13> all{{
    {"mat", read_mat, true},
    {"csv", read_csv, false},
    {"hdf5", read_hdf5, true},
    {"sound", read_sound, true},
    {"npy", read_npy, false},
    {"tdms", read_tdms, false},
    {"uff", read_uff, false},
    {"lvm", read_lvm, false},
    {"description", read_description, false},
    {"simulation", read_simulation, false},
    {"protocol", read_protocol, false},
    {"published", read_published, false},
    {"artefact", read_artefact, true},
}};

std::string description_of(const std::string& file, const std::string& variable) {
  return "name = \"storm\"\nshaft_speed_rpm = 1797\n[bearing]\nballs = 9\nball_diameter_mm = 7.94\n"
         "pitch_diameter_mm = 39.0\ncontact_angle_deg = 0\n[[class]]\nname = \"Normal\"\n"
         "defect = \"none\"\n[[record]]\nclass = \"Normal\"\nfile = \"" +
         file + "\"\nvariable = \"" + variable + "\"\nsample_rate_hz = 12000\n";
}

/// Returns why a program's outcome breaks a promise about the file with this name; "" if it does
/// not. `verify` has exit codes of its own.
std::string failure_of(const Outcome& outcome, const std::string& name, bool is_verify) {
  const std::string printed = ": " + outcome.out + outcome.err;
  const std::string status = std::to_string(outcome.status);
  if (outcome.hung) return "the program hangs" + printed;
  if (outcome.status > 128) return "the program ended with " + status + printed;
  if (took_too_much(outcome, name))
    return "the program took " + std::to_string(outcome.peak_mb) + " MB";
  if (outcome.status == 0) return {};
  if (!is_verify && outcome.status != 65) return "the program ended with " + status + printed;
  return printed.find(name) == std::string::npos ? "the program does not name the file" + printed
                                                 : "";
}

}  // namespace

std::span<const Target> targets() { return all; }

std::string failure_of_programs(const Target& target, const fs::path& file,
                                const fs::path& programs) {
  const fs::path folder = file.parent_path();
  const std::string name = file.filename();
  const auto program = [&](const char* stage) { return (fs::absolute(programs) / stage).string(); };
  if (std::string(target.name) == "artefact") {
    std::string failure = failure_of(run(folder, {program("verify"), name}), name, true);
    if (failure.empty() && is_classifier(file)) {
      std::string recording;
      for (const double sample : recorded_samples()) recording += std::to_string(sample) + '\n';
      const std::string file_name = name + ".csv";  // also holds the classifier's name
      write_bytes(folder / file_name, recording);
      const Outcome named =
          run(folder, {program("classify"), "--classifier", name, "--recording", file_name,
                       "--variable", "1", "--sample-rate-hz", std::to_string(recorded_hz),
                       "--speed-rpm", std::to_string(recorded_rpm)});
      fs::remove(folder / file_name);
      return failure_of(named, name, false);
    }
    if (!failure.empty() || !is_model(file)) return failure;
    const Outcome made = run(folder, {program("generate"), "--model", name, "--count", "1",
                                      "--seed", "0", "--output", "out.h5"});
    fs::remove(folder / "out.h5");
    return failure_of(made, name, false);
  }
  const std::map<std::string, std::string> variables{{"mat", "x"}, {"hdf5", "/x"}};
  const auto found = variables.find(target.name);
  const std::string variable = found == variables.end() ? "1" : found->second;
  write_bytes(folder / "storm.toml", description_of(name, variable));
  const Outcome read = run(folder, {program("ingest"), "--description", "storm.toml", "--data-dir",
                                    ".", "--output", "out.h5"});
  fs::remove(folder / "out.h5");
  return failure_of(read, name, false);
}

}  // namespace piae::storm
