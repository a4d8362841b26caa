#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/sha256.hpp"
#include "plan/plan.hpp"
#include "plan/words.hpp"
#include "support/folder.hpp"

namespace piae::plan {

/// A disk in memory. Running a step records the files that it would make.
class DiskOfValues : public Disk {
 public:
  void read_ahead(const std::vector<std::string>& names) override {
    expected.insert(names.begin(), names.end());
  }
  const File* find(const std::string& file) override {
    const bool is_unexpected = file.ends_with(".h5") && !expected.contains(file);
    if (is_unexpected) read_alone.insert(file);
    const auto found = files.find(file);
    return found == files.end() ? nullptr : &found->second;
  }
  const artefact::DoneStep* done(const std::string& step) override {
    const auto found = steps.find(step);
    return found == steps.end() ? nullptr : &found->second;
  }
  std::vector<std::string> files_below(const std::string& folder) override {
    std::vector<std::string> below;
    const std::string prefix = folder + '/';
    for (const auto& [name, file] : files) {
      if (name.starts_with(prefix)) below.push_back(name.substr(prefix.size()));
    }
    return below;
  }

  std::string text_of(const std::string& file) override { return texts[file]; }

  std::map<std::string, File> files;
  std::map<std::string, std::string> texts;
  std::map<std::string, artefact::DoneStep> steps;
  std::set<std::string> expected;    ///< artefacts announced by read_ahead()
  std::set<std::string> read_alone;  ///< other artefacts that find() was called for
};

/// A project with two data sets and a run of it: "real" is measured, "made" is simulated.
class SmallRun {
 public:
  SmallRun() {
    write("datasets/real.toml", "name = \"real\"\n[[record]]\nfile = \"1.mat\"\nclass = \"a\"\n");
    write("datasets/made.toml", "name = \"made\"\n[simulation]\nnoise = 0.1\n");
    write("protocol.toml", protocol);
    disk.files["results/published/table.csv"] = {.digest = "published"};
    disk.files["pipeline/figures/style.gp"] = {.digest = "style"};
    disk.files["data/1.mat"] = {.digest = "recording"};
    request.run = "t";
    request.datasets = "real made";
    request.methods = "none smote piae-dt";
    request.ratios = "100to1 10to1 1to1";
    request.seeds = "0 1";
  }

  void write(const std::string& file, const std::string& text) { pipeline.write(file, text); }
  void set(const std::string& old_words, const std::string& new_words) {
    const std::size_t at = protocol.find(old_words);
    ASSERT_NE(at, std::string::npos);
    protocol.replace(at, old_words.size(), new_words);
    write("protocol.toml", protocol);
  }

  /// Narrows the request to seed 0 of the measured data set.
  void narrow_to(const std::string& method, const std::string& ratio) {
    request.datasets = "real";
    request.methods = method;
    request.ratios = ratio;
    request.seeds = "0";
  }

  /// Makes a new plan for the goals.
  Plan& plan(const std::string& goals = "all", Stretch stretch = Stretch::grid) {
    Request requested = request;
    requested.goals = words_in(goals);
    experiment = read_experiment(pipeline.path());
    current = std::make_unique<Plan>(experiment, choose(experiment, requested), stretch, disk);
    return *current;
  }

  /// Runs the steps to be run, as make would. Returns the number of runs of each stage.
  std::map<std::string, int> run(const std::string& goals = "all") {
    std::map<std::string, int> ran;
    Plan& to_do = plan(goals);
    for (const StepId id : to_do.to_run()) {
      const Step step = to_do.graph().at(id);
      Judge judge(to_do.graph(), disk);
      if (judge.of(id).state == State::current) continue;
      ++ran[step.log];
      make(to_do.graph(), id);
    }
    return ran;
  }

  /// Makes the files of one step. Their contents depend on its inputs and options.
  void make(const Graph& graph, StepId id) {
    const Step& step = graph.at(id);
    Judge judge(graph, disk);
    artefact::DoneStep done = judge.made_now(id);
    done.outputs.clear();
    std::string content = step.stage + *done.made.options;
    for (const artefact::MadeFrom& from : done.made.inputs) content += from.role + from.digest;
    for (const std::string& output : step.outputs) {
      const std::string digest =
          artefact::short_digest(Sha256().update(content + output + salt).finish_hex());
      disk.files[output] = {.digest = digest};
      if (step.is_artefact) {
        disk.files[output].made = done.made;
        disk.files[output].belongs_in = file_name(output);
      }
      done.outputs.push_back({output, digest});
    }
    if (!step.is_artefact) disk.steps[name_of(step)] = done;
  }

  /// Returns why the step with this log is to be run; empty if it is not.
  std::string why(const std::string& log, const std::string& goals = "all") {
    Plan& requested = plan(goals);
    for (const StepId id : requested.requested()) {
      if (name_of(requested.graph().at(id)) == "results/t/" + log)
        return requested.judge().of(id).why;
    }
    return "there is no step " + log;
  }

  std::string protocol =
      "[split]\nwindow = 1024\n[train]\n[train.smote]\nneighbours = 4\n[train.piae-dt]\n"
      "epochs = 200\n[generate]\n[score]\n[diagnose]\nepochs = 50\n";
  Folder pipeline;
  DiskOfValues disk;
  Request request;
  Experiment experiment;
  std::unique_ptr<Plan> current;
  std::string salt;  ///< added to the contents: another salt stands for another random stream
};

}  // namespace piae::plan
