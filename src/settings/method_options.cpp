#include "settings/method_options.hpp"

#include "augment/catalogue.hpp"
#include "base/compute.hpp"
#include "cli/run_options.hpp"
#include "cli/setting.hpp"

namespace piae::settings {

std::string refusal_of(const std::string& method, const Point& point) {
  const auto made = augment::make_method(method);
  Compute compute;
  const auto bind = [&](const cli::Options& options) {
    made->bind(options);
    cli::bind(options, compute);
  };
  const std::string refusal = cli::refusal_of(bind, point.factor, point.value);
  return refusal.empty() ? "" : method + " refuses: " + refusal;
}

}  // namespace piae::settings
