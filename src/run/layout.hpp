#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scoring/diagnosis_record.hpp"

namespace piae::run {

/// Names a sweep of a method's settings in folders and files: "sweep" for the paper's method,
/// "sweep@smote" for another one.
std::string sweep_name(const std::string& method);

/// Files that `tabulate` writes for a dataset.
inline const std::vector<std::string> table_names{
    "accuracy.csv", "gains.csv",     "quality.csv",    "comparisons.csv",
    "ranks.csv",    "decisions.csv", "confidence.csv", "recommendation.csv",
    "tables.md",    "tables.tex",    "summary.txt"};

/// Paths of one data set's artefacts and tables in the folder of a run. The make rules in pipeline/
/// use the same paths.
class Layout {
 public:
  /// `run` is the folder of the run, such as results/paper. Throws Error(bad_input) if it has cells
  /// in the layout from before 0.1.0: programs would report them as missing, and make would
  /// recompute them.
  Layout(const std::filesystem::path& run, const std::string& dataset);

  /// Returns the same data set in the run next to this one with a blocked split.
  [[nodiscard]] Layout blocked() const {
    std::filesystem::path run = folder_.parent_path();
    return {run += "-blocked", folder_.filename()};
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Returns the seeds that have a folder, ascending.
  [[nodiscard]] std::vector<std::int64_t> seeds() const;

  [[nodiscard]] std::filesystem::path score(const std::string& method, std::int64_t seed) const {
    return method_folder(method, seed) / "score.h5";
  }
  [[nodiscard]] std::filesystem::path diagnosis(
      const std::string& method, const std::string& ratio, std::int64_t seed,
      const std::string& classifier = scoring::paper_classifier) const {
    return method_folder(method, seed) / ratio / classifier / "diagnosis.h5";
  }
  /// The classifier itself, next to its diagnosis.
  [[nodiscard]] std::filesystem::path kept_classifier(const std::string& method,
                                                      const std::string& ratio, std::int64_t seed,
                                                      const std::string& classifier) const {
    return diagnosis(method, ratio, seed, classifier).replace_filename("classifier.h5");
  }
  /// Verdicts of that classifier on the records.
  [[nodiscard]] std::filesystem::path classification(const std::string& method,
                                                     const std::string& ratio, std::int64_t seed,
                                                     const std::string& classifier) const {
    return diagnosis(method, ratio, seed, classifier).replace_filename("classification.h5");
  }
  /// A diagnosis by the paper's classifier with the features of the test windows.
  [[nodiscard]] std::filesystem::path features(const std::string& method, const std::string& ratio,
                                               std::int64_t seed) const {
    return diagnosis(method, ratio, seed).replace_filename("features.h5");
  }
  [[nodiscard]] std::filesystem::path model(const std::string& method, std::int64_t seed) const {
    return method_folder(method, seed) / "model.h5";
  }
  /// The folder of the sweep of the paper's method.
  [[nodiscard]] std::filesystem::path sweep_folder(std::int64_t seed) const {
    return seed_folder(seed) / "sweep";
  }
  /// Windows of one role of the split: "A", "B", "C" or "D".
  [[nodiscard]] std::filesystem::path windows(const std::string& role, std::int64_t seed) const {
    return seed_folder(seed) / (role + ".h5");
  }
  [[nodiscard]] std::filesystem::path real_windows(std::int64_t seed) const {
    return windows("D", seed);
  }
  [[nodiscard]] std::filesystem::path known_windows(std::int64_t seed) const {
    return windows("C", seed);
  }
  [[nodiscard]] std::filesystem::path generated_windows(const std::string& method,
                                                        std::int64_t seed) const {
    return method_folder(method, seed) / "E.h5";
  }
  [[nodiscard]] std::filesystem::path figure_csv(const std::string& figure) const {
    return folder_ / "figures" / (figure + ".csv");
  }
  [[nodiscard]] std::filesystem::path accuracy_csv() const { return folder_ / "accuracy.csv"; }
  [[nodiscard]] std::filesystem::path summary_text() const { return folder_ / "summary.txt"; }
  [[nodiscard]] std::filesystem::path gains_csv() const { return folder_ / "gains.csv"; }
  [[nodiscard]] std::filesystem::path quality_csv() const { return folder_ / "quality.csv"; }
  [[nodiscard]] std::filesystem::path comparisons_csv() const {
    return folder_ / "comparisons.csv";
  }
  [[nodiscard]] std::filesystem::path ranks_csv() const { return folder_ / "ranks.csv"; }
  [[nodiscard]] std::filesystem::path decisions_csv() const { return folder_ / "decisions.csv"; }
  [[nodiscard]] std::filesystem::path confidence_csv() const { return folder_ / "confidence.csv"; }
  [[nodiscard]] std::filesystem::path trust_csv() const { return folder_ / "trust.csv"; }
  [[nodiscard]] std::filesystem::path trust_markdown() const { return folder_ / "trust.md"; }
  [[nodiscard]] std::filesystem::path verdicts_csv() const { return folder_ / "verdicts.csv"; }
  [[nodiscard]] std::filesystem::path verdicts_markdown() const { return folder_ / "verdicts.md"; }
  [[nodiscard]] std::filesystem::path recommendation_csv() const {
    return folder_ / "recommendation.csv";
  }
  [[nodiscard]] std::filesystem::path tables_markdown() const { return folder_ / "tables.md"; }
  [[nodiscard]] std::filesystem::path tables_latex() const { return folder_ / "tables.tex"; }
  /// The tables of a sweep of a method's settings.
  [[nodiscard]] std::filesystem::path sweep_csv(const std::string& method) const {
    return folder_ / (sweep_name(method) + ".csv");
  }
  [[nodiscard]] std::filesystem::path sweep_markdown(const std::string& method) const {
    return folder_ / (sweep_name(method) + ".md");
  }
  [[nodiscard]] std::filesystem::path readings_csv() const { return folder_ / "readings.csv"; }
  [[nodiscard]] std::filesystem::path readings_markdown() const { return folder_ / "readings.md"; }
  [[nodiscard]] std::filesystem::path identifiability_csv() const {
    return folder_ / "identifiability.csv";
  }
  [[nodiscard]] std::filesystem::path scatter_csv() const { return folder_ / "scatter.csv"; }
  [[nodiscard]] std::filesystem::path identifiability_markdown() const {
    return folder_ / "identifiability.md";
  }

  /// Returns the log that explains a missing diagnosis or score: the log of the first step towards
  /// it that started without leaving a result. Returns an empty value if every step is finished or
  /// not started. `cell` is a path from diagnosis() or score().
  [[nodiscard]] static std::optional<std::filesystem::path> unfinished_log(
      const std::filesystem::path& cell);

 private:
  [[nodiscard]] std::filesystem::path method_folder(const std::string& method,
                                                    std::int64_t seed) const {
    return seed_folder(seed) / method;
  }
  [[nodiscard]] std::filesystem::path seed_folder(std::int64_t seed) const {
    return folder_ / ("seed" + std::to_string(seed));
  }

  std::filesystem::path folder_;
};

}  // namespace piae::run
