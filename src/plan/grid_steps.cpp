#include "plan/grid_steps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "artefact/journal.hpp"
#include "augment/catalogue.hpp"
#include "base/sha256.hpp"
#include "diagnosis/any_bearing.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/diagnosis_record.hpp"
#include "signal/record_files.hpp"

namespace piae::plan {

namespace {

Input input(const std::string& role, const std::string& file) {
  return {.role = role, .files = {file}};
}

/// Returns the files that match a name or pattern of a description.
std::vector<Input> inputs_of_recordings(const std::string& described, const std::string& data_dir) {
  std::vector<Input> inputs;
  for (const std::string& name : signal::files_of({described}, data_dir)) {
    inputs.push_back({.role = "recording " + name,
                      .files = {fmt::format("{}/{}", data_dir, name)},
                      .is_option = false,
                      // An additional file that matches a pattern is an additional recording.
                      .may_be_unrecorded = !signal::is_pattern(described),
                      .may_be_absent = true});
  }
  return inputs;
}

bool generates(const std::string& method) { return method != augment::no_method; }

}  // namespace

Variant variant_of(const std::string& method) { return {.folder = method, .method = method}; }

GridSteps::GridSteps(const Experiment& experiment, const Choice& choice, signal::Protocol protocol,
                     Graph& graph)
    : choice_(choice),
      protocol_(protocol),
      graph_(graph),
      folder_(choice.folder_of(protocol)),
      settings_(experiment, folder_) {}

std::string GridSteps::seed_folder(const Dataset& dataset, std::int64_t seed) const {
  return folder_ + '/' + dataset.name + "/seed" + std::to_string(seed);
}

StepId GridSteps::add(Step step) {
  if (step.log.empty()) step.log = step.stage;
  step.is_requested = is_requested_;
  step.is_held = !is_requested_;
  return graph_.add(std::move(step));
}

StepId GridSteps::records(const Dataset& dataset) {
  const std::string output = folder_ + '/' + dataset.name + "/records.h5";
  if (const auto there = graph_.maker_of(output)) return *there;
  const auto description = settings_.description(dataset);
  Step step{.stage = dataset.is_simulated ? "simulate" : "ingest",
            .folder = folder_ + '/' + dataset.name,
            .outputs = {output},
            .output_option = "output",
            .place = {.dataset = dataset.name}};
  Input of_description = input("description", description->file);
  of_description.digest = artefact::short_digest(Sha256().update(description->text).finish_hex());
  step.inputs.push_back(std::move(of_description));
  step.description = description;
  if (!dataset.is_simulated) {
    step.words = {"--data-dir", choice_.data_dir};
    for (const std::string& described : description->recordings) {
      std::ranges::move(inputs_of_recordings(described, choice_.data_dir),
                        std::back_inserter(step.inputs));
    }
  }
  return add(std::move(step));
}

StepId GridSteps::split(const Dataset& dataset, std::int64_t seed) {
  const std::string folder = seed_folder(dataset, seed);
  if (const auto there = graph_.maker_of(folder + "/A.h5")) return *there;
  records(dataset);
  Step step{.stage = "split",
            .folder = folder,
            .settings = settings_.of_split(dataset),
            .inputs = {input("records", folder_ + '/' + dataset.name + "/records.h5")},
            .options = {{"seed", std::to_string(seed)}, {"protocol", signal::to_string(protocol_)}},
            .words = {"--output-dir", folder},
            .place = {.dataset = dataset.name, .seed = seed}};
  for (const char* role : {"A", "B", "C", "D"}) step.outputs.push_back(folder + '/' + role + ".h5");
  return add(std::move(step));
}

StepId GridSteps::model(const Dataset& dataset, std::int64_t seed, const Variant& variant) {
  const std::string of_seed = seed_folder(dataset, seed);
  const std::string folder = of_seed + '/' + variant.folder;
  if (const auto there = graph_.maker_of(folder + "/model.h5")) return *there;
  split(dataset, seed);
  Step step{
      .stage = "train",
      .folder = folder,
      .settings = settings_.of("train", variant.method),
      .inputs = {input("known", of_seed + "/C.h5")},
      .options = {{"method", variant.method}, {"seed", std::to_string(seed)}},
      .outputs = {folder + "/model.h5"},
      .output_option = "output",
      .place = {
          .dataset = dataset.name, .seed = seed, .unit = variant.folder, .method = variant.method}};
  if (augment::is_ceiling(variant.method)) step.inputs.push_back(input("real", of_seed + "/D.h5"));
  if (augment::find_entry(variant.method)->healthy != augment::Healthy::unused) {
    step.inputs.push_back(input("healthy", of_seed + "/B.h5"));
  }
  for (const settings::Point& point : variant.moved) {
    step.options.emplace_back(point.factor, point.value);
  }
  return add(std::move(step));
}

StepId GridSteps::windows(const Dataset& dataset, std::int64_t seed, const Variant& variant) {
  const std::string folder = seed_folder(dataset, seed) + '/' + variant.folder;
  if (const auto there = graph_.maker_of(folder + "/E.h5")) return *there;
  model(dataset, seed, variant);
  return add({.stage = "generate",
              .folder = folder,
              .settings = settings_.of("generate"),
              .inputs = {input("model", folder + "/model.h5")},
              .options = {{"seed", std::to_string(seed)}},
              .outputs = {folder + "/E.h5"},
              .output_option = "output",
              .place = {.dataset = dataset.name,
                        .seed = seed,
                        .unit = variant.folder,
                        .method = variant.method}});
}

StepId GridSteps::score(const Dataset& dataset, std::int64_t seed, const Variant& variant) {
  const std::string of_seed = seed_folder(dataset, seed);
  const std::string folder = of_seed + '/' + variant.folder;
  if (const auto there = graph_.maker_of(folder + "/score.h5")) return *there;
  windows(dataset, seed, variant);
  return add({.stage = "score",
              .folder = folder,
              .settings = settings_.of("score"),
              .inputs = {input("generated", folder + "/E.h5"), input("real", of_seed + "/D.h5")},
              .outputs = {folder + "/score.h5"},
              .output_option = "output",
              .place = {.dataset = dataset.name,
                        .seed = seed,
                        .unit = variant.folder,
                        .method = variant.method}});
}

Step GridSteps::of_classifier(const Dataset& dataset, std::int64_t seed, const Variant& variant,
                              const std::string& ratio, const std::string& classifier) {
  const std::string of_seed = seed_folder(dataset, seed);
  if (generates(variant.method)) {
    windows(dataset, seed, variant);
  } else {
    split(dataset, seed);
  }
  Step step{.stage = "diagnose",
            .folder = of_seed + '/' + variant.folder + '/' + ratio + '/' + classifier,
            .settings = settings_.of("diagnose"),
            .inputs = {input("test", of_seed + "/A.h5"), input("normal", of_seed + "/B.h5"),
                       input("known", of_seed + "/C.h5")},
            .options = {{"ratio", ratio}, {"seed", std::to_string(seed)}},
            .place = {.dataset = dataset.name,
                      .seed = seed,
                      .unit = variant.folder,
                      .method = variant.method,
                      .ratio = ratio,
                      .classifier = classifier}};
  if (generates(variant.method)) {
    step.inputs.push_back(input("generated", of_seed + '/' + variant.folder + "/E.h5"));
  }
  if (diagnosis::the_classifier(classifier).fit != nullptr) {
    step.inputs.push_back(input("network", diagnosis::any_bearing_file));
  }
  if (diagnosis::the_classifier(classifier).adapts()) {
    step.inputs.push_back(input("unlabelled", of_seed + "/D.h5"));
  }
  if (classifier != scoring::paper_classifier) step.options.emplace_back("classifier", classifier);
  return step;
}

StepId GridSteps::diagnosis(const Dataset& dataset, std::int64_t seed, const Variant& variant,
                            const std::string& ratio, const std::string& classifier) {
  const std::string output = seed_folder(dataset, seed) + '/' + variant.folder + '/' + ratio + '/' +
                             classifier + "/diagnosis.h5";
  if (const auto there = graph_.maker_of(output)) return *there;
  Step step = of_classifier(dataset, seed, variant, ratio, classifier);
  step.words = {"--reproducible"};
  step.outputs = {output};
  step.output_option = "output";
  return add(std::move(step));
}

StepId GridSteps::features(const Dataset& dataset, std::int64_t seed, const std::string& method,
                           const std::string& ratio) {
  Step step = of_classifier(dataset, seed, variant_of(method), ratio, scoring::paper_classifier);
  const std::string output = step.folder + "/features.h5";
  if (const auto there = graph_.maker_of(output)) return *there;
  step.log = "features";
  step.words = {"--reproducible", "--keep-features"};
  step.outputs = {output};
  step.output_option = "output";
  return add(std::move(step));
}

StepId GridSteps::classifier(const Dataset& dataset, std::int64_t seed, const std::string& method,
                             const std::string& ratio, const std::string& classifier) {
  Step step = of_classifier(dataset, seed, variant_of(method), ratio, classifier);
  const std::string output = step.folder + "/classifier.h5";
  if (const auto there = graph_.maker_of(output)) return *there;
  step.log = "classifier";
  step.outputs = {output};
  step.output_option = "keep-classifier";
  return add(std::move(step));
}

StepId GridSteps::classification(const Dataset& dataset, std::int64_t seed,
                                 const std::string& method, const std::string& ratio,
                                 const std::string& classifier) {
  const Step of = graph_.at(this->classifier(dataset, seed, method, ratio, classifier));
  const std::string output = of.folder + "/classification.h5";
  if (const auto there = graph_.maker_of(output)) return *there;
  return add({.stage = "classify",
              .folder = of.folder,
              .inputs = {input("classifier", of.outputs.front()),
                         input("records", folder_ + '/' + dataset.name + "/records.h5")},
              .outputs = {output},
              .output_option = "output",
              .place = of.place});
}

}  // namespace piae::plan
