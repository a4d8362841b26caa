#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "report/document.hpp"
#include "run/grid.hpp"
#include "scoring/statistics.hpp"
#include "signal/window_set.hpp"

namespace piae::report {

/// Models of a run whose inferred (k, c) are compared with the true ones, and a data set with known
/// (k, c).
struct IdentifiabilityOptions {
  std::string dataset;
  std::vector<std::string> methods;
  std::vector<std::string> seeds;
};

void bind(const cli::Options& command, IdentifiabilityOptions& options);
/// Throws Error(usage) as run::resolve() does.
run::Grid resolve(const IdentifiabilityOptions& options);

/// Parameters that the model of one method and seed infers from windows that it has not seen.
struct Identification {
  std::string method;
  std::int64_t seed = 0;
  signal::WindowSet windows;                        ///< with their true parameters
  std::vector<signal::DynamicParameters> inferred;  ///< [n], for each window
};

/// Agreement of one inferred parameter with the truth, for one class or all windows, over the
/// seeds.
struct IdentifiabilityRow {
  std::string method;
  std::string parameter;   ///< "stiffness" or "damping"
  std::string class_name;  ///< "all" for all windows together
  scoring::Summary r2;     ///< this and the next two: see scoring::Agreement
  scoring::Summary bias;
  scoring::Summary correlation2;
};

/// Returns rows by method, then parameter, then class, with "all" before the classes. Throws
/// Error(bad_input) if the true parameters are unknown or do not vary.
std::vector<IdentifiabilityRow> identifiability_rows(const std::vector<Identification>& all);

/// Returns dataset,method,parameter,class,seeds and mean and standard deviation of r2, bias,
/// correlation2.
std::string identifiability_csv(const std::string& dataset,
                                const std::vector<IdentifiabilityRow>& rows);

/// Returns the windows of all seeds in ten groups by the true value: dataset,method,parameter,
/// truth_low,truth_high,windows,inferred_p10,inferred_p50,inferred_p90, in N/m and N s/m.
std::string scatter_csv(const std::string& dataset, const std::vector<Identification>& all);

/// Returns both for people.
Document identifiability_document(const std::string& dataset,
                                  const std::vector<IdentifiabilityRow>& rows,
                                  const std::vector<Identification>& all);

}  // namespace piae::report
