#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "plan/planned.hpp"
#include "plan/request.hpp"

namespace piae::plan {

/// The words of a request as options. An option that is not given takes its value from a variable
/// of make: --methods from METHODS. An empty value counts as not given.
struct RequestOptions {
  std::string goals;
  std::string run;
  std::string datasets;
  std::string methods;
  std::string ratios;
  std::string classifiers;
  std::string seeds;
  signal::Protocol protocol = signal::Protocol::random;
  std::string data_dir;

  [[nodiscard]] Request request() const;
};

void bind(const cli::Options& command, RequestOptions& requested);
void bind(const cli::Options& command, PlanOptions& options);

}  // namespace piae::plan
