#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace piae::report {

struct PublishedPercent {
  double value = 0;
  std::string place;  ///< file and line
};

/// Accuracies that the paper publishes, in percent.
class Published {
 public:
  /// Without any accuracies.
  Published() = default;
  /// Reads table6-7-baseline.csv, table8-9-methods.csv and table10-11-ablation.csv of a folder.
  /// Throws Error(input_missing) for a file that cannot be read, and Error(bad_input) with file and
  /// line for an unknown header, model or ratio, a row of another length than the header, a value
  /// that is no percentage, and one that contradicts another table.
  explicit Published(const std::filesystem::path& folder);

  /// Empty where the paper has no such dataset, method or ratio.
  [[nodiscard]] std::optional<double> percent(const std::string& dataset, const std::string& method,
                                              const std::string& ratio) const;
  /// The runs of Tables 6 and 7, without augmentation. Empty for any other dataset.
  [[nodiscard]] std::vector<double> baseline_runs(const std::string& dataset) const;

 private:
  /// By data set, method and ratio.
  std::map<std::tuple<std::string, std::string, std::string>, PublishedPercent> percents_;
  std::map<std::string, std::vector<double>> baseline_runs_;
};

}  // namespace piae::report
