#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "run/layout.hpp"
#include "stages/program.hpp"
#include "support/description_text.hpp"
#include "support/folder.hpp"

namespace piae::stages {

/// A simulated data set that takes a fraction of a second: three classes with two short records
/// each.
inline const std::string tiny_description = described_bearing("tiny") + described_normal +
                                            described_ir007 + described_or021 +
                                            described_simulation("2", "0.5") + "snr_db = 10\n";

inline std::vector<std::string> tables_of_tiny() {
  std::vector<std::string> files;
  files.reserve(std::size(run::table_names));
  for (const std::string& name : run::table_names) files.push_back("run/tiny/" + name);
  return files;
}

/// A step of the chain from a simulation to the tables.
struct Step {
  std::string stage;
  Arguments arguments;
  std::vector<std::string> outputs;
};

/// Returns the whole chain, each step with the files that it writes, relative to its folder. It has
/// two diagnoses: without and with generated windows.
inline const std::vector<Step>& chain() {
  static const std::string cell = "run/tiny/seed0/";
  static const std::vector<Step> steps{
      {"simulate", {"--description", "tiny.toml", "--output", "records.h5"}, {"records.h5"}},
      {"split",
       {"--records", "records.h5", "--seed", "0", "--windows-per-class", "40", "--test-per-class",
        "10", "--known-per-class", "5", "--output-dir", "."},
       {"A.h5", "B.h5", "C.h5", "D.h5"}},
      {"train",
       {"--method", "piae-dt", "--known", "C.h5", "--seed", "0", "--width", "8", "--epochs", "4",
        "--output", "model.h5"},
       {"model.h5"}},
      {"generate",
       {"--model", "model.h5", "--count", "5", "--seed", "0", "--output", "E.h5"},
       {"E.h5"}},
      {"score",
       {"--generated", "E.h5", "--real", "D.h5", "--output", cell + "piae-dt/score.h5"},
       {cell + "piae-dt/score.h5"}},
      {"diagnose",
       {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio", "100to1", "--seed", "0",
        "--epochs", "2", "--reproducible", "--output", cell + "none/100to1/wdcnn/diagnosis.h5"},
       {cell + "none/100to1/wdcnn/diagnosis.h5"}},
      {"diagnose",
       {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--generated", "E.h5", "--ratio",
        "50to1", "--seed", "0", "--epochs", "2", "--reproducible", "--output",
        cell + "piae-dt/50to1/wdcnn/diagnosis.h5"},
       {cell + "piae-dt/50to1/wdcnn/diagnosis.h5"}},
      {"tabulate",
       {"--run", "run", "--dataset", "tiny", "--methods", "none", "piae-dt", "--ratios", "100to1",
        "50to1", "--seeds", "0", "--published", std::string(PIAE_SOURCE) + "/results/published"},
       tables_of_tiny()},
  };
  return steps;
}

/// Returns the network for all machines that the project stores.
inline std::string stored_network() {
  return std::string(PIAE_SOURCE) + "/results/reference/any-bearing.h5";
}

/// Returns the last step of a stage; for diagnose it is the one with generated windows.
inline const Step& step_of(const std::string& stage) {
  const Step* found = nullptr;
  for (const Step& step : chain()) {
    if (step.stage == stage) found = &step;
  }
  if (found == nullptr) throw std::logic_error("no step " + stage);
  return *found;
}

/// Returns a copy with another value for an option.
inline Arguments with(Arguments arguments, const std::string& option, const std::string& value) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == option) {
      arguments[i + 1] = value;
      return arguments;
    }
  }
  arguments.insert(arguments.end(), {option, value});
  return arguments;
}

/// A folder with the description, in which the chain runs as far as a test needs.
class Tiny {
 public:
  Tiny() { folder_.write("tiny.toml", tiny_description); }

  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  [[nodiscard]] fs::path operator/(const std::string& name) const { return folder_ / name; }
  fs::path write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }

  /// Makes the outputs of all steps before the first one of this stage; of all steps for an empty
  /// name. Under ctest every test is its own process, so outputs are copied from the fixture's
  /// chain (chain_test.cpp); otherwise the steps run.
  void run_chain_before(const std::string& stage) const {
    const char* made = std::getenv("PIAE_TINY_CHAIN");
    for (const Step& step : chain()) {
      if (step.stage == stage) return;
      if (made != nullptr) {
        for (const std::string& output : step.outputs) copy_from(made, output);
        continue;
      }
      const Outcome outcome = stages::run(path(), step.stage, step.arguments);
      ASSERT_EQ(outcome.status, 0) << step.stage << ": " << outcome.err;
    }
  }
  [[nodiscard]] Outcome run(const std::string& stage, const Arguments& arguments) const {
    return stages::run(path(), stage, arguments);
  }
  [[nodiscard]] Outcome run_step(const std::string& stage) const {
    return run(stage, step_of(stage).arguments);
  }

  /// Returns the names of all files and links below the folder.
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path())) {
      if (!entry.is_directory()) names.insert(entry.path().lexically_relative(path()).string());
    }
    return names;
  }
  /// Returns the temporary files, which programs write before they rename them.
  [[nodiscard]] std::set<std::string> left_overs() const {
    std::set<std::string> names = files();
    std::erase_if(names, [](const auto& name) { return name.find(".partial") == name.npos; });
    return names;
  }

 private:
  void copy_from(const fs::path& made, const std::string& output) const {
    fs::create_directories((path() / output).parent_path());
    fs::copy_file(made / output, path() / output);
  }

  Folder folder_;
};

/// Stops a training as soon as it reports its start, five times, and expects a checkpoint each
/// time. step.sh sends no signal that would end a stage after this report.
inline void expect_checkpoints_at_once(const Tiny& tiny, const Arguments& arguments) {
  const Surroundings of_step{.environment = {{"OMP_NUM_THREADS", "1"}, {"PIAE_STEP", "1"}}};
  for (int cut = 0; cut < 5; ++cut) {
    Process train(tiny.path(), "train", arguments, of_step);
    train.wait_until_it_warns("step: started");
    train.send(SIGUSR1);
    const Outcome outcome = train.wait();
    ASSERT_EQ(outcome.status, 75) << outcome.err;
    EXPECT_NE(outcome.err.find("train: interrupted after epoch"), std::string::npos) << outcome.err;
  }
}

inline void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Returns all artefacts of the chain.
inline std::vector<std::string> artefacts() {
  std::vector<std::string> names;
  for (const Step& step : chain()) {
    for (const std::string& output : step.outputs) {
      if (output.ends_with(".h5")) names.push_back(output);
    }
  }
  return names;
}

}  // namespace piae::stages
