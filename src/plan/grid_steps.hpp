#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "plan/request.hpp"
#include "plan/stage_settings.hpp"
#include "plan/step.hpp"
#include "settings/points.hpp"

namespace piae::plan {

/// A method to be trained for a seed: with the settings of the protocol, or with some settings
/// moved by a sweep or an interpretation.
struct Variant {
  std::string folder;  ///< below the seed's folder: "smote", "sweep/batch-1"
  std::string method;
  std::vector<settings::Point> moved = {};
};

/// Returns the method with the settings of the protocol.
Variant variant_of(const std::string& method);

/// Adds the steps of the grid to a graph, each once and together with all that it needs:
///
///     records.h5 -> A B C D -> model.h5 -> E.h5 -> score.h5
///                          \-------------------\-> RATIO/CLASSIFIER/diagnosis.h5
class GridSteps {
 public:
  /// `folder` is the folder of the run.
  GridSteps(const Experiment& experiment, const Choice& choice, signal::Protocol protocol,
            Graph& graph);

  /// Sets if steps added from now on are requested. Other steps represent what the run holds, and
  /// are not made.
  void request(bool is_requested) { is_requested_ = is_requested; }

  StepId records(const Dataset& dataset);
  StepId split(const Dataset& dataset, std::int64_t seed);
  StepId model(const Dataset& dataset, std::int64_t seed, const Variant& variant);
  StepId windows(const Dataset& dataset, std::int64_t seed, const Variant& variant);
  StepId score(const Dataset& dataset, std::int64_t seed, const Variant& variant);
  StepId diagnosis(const Dataset& dataset, std::int64_t seed, const Variant& variant,
                   const std::string& ratio, const std::string& classifier);
  /// Features of the test windows by the paper's classifier (Figs 20 and 21), which is trained
  /// again with a log of its own.
  StepId features(const Dataset& dataset, std::int64_t seed, const std::string& method,
                  const std::string& ratio);
  /// The trained classifier, for `classify` and `monitor`.
  StepId classifier(const Dataset& dataset, std::int64_t seed, const std::string& method,
                    const std::string& ratio, const std::string& classifier);
  /// The verdicts of that classifier on all records of the data set.
  StepId classification(const Dataset& dataset, std::int64_t seed, const std::string& method,
                        const std::string& ratio, const std::string& classifier);

  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] StageSettings& settings() { return settings_; }
  [[nodiscard]] Graph& graph() { return graph_; }

 private:
  Step of_classifier(const Dataset& dataset, std::int64_t seed, const Variant& variant,
                     const std::string& ratio, const std::string& classifier);
  [[nodiscard]] std::string seed_folder(const Dataset& dataset, std::int64_t seed) const;
  StepId add(Step step);

  const Choice& choice_;
  signal::Protocol protocol_;
  Graph& graph_;
  std::string folder_;
  StageSettings settings_;
  bool is_requested_ = true;
};

}  // namespace piae::plan
