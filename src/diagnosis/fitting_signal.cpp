#include "diagnosis/fitting_signal.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"

namespace piae::diagnosis {

namespace {

/// Returns the speeds of the conditions in which faults were known or tested.
std::set<double> trained_speeds_rpm(const signal::DatasetInfo& trained) {
  std::set<double> speeds;
  for (const std::int32_t condition : trained.known_conditions()) {
    speeds.insert(trained.speed_rpm(condition));
  }
  for (const std::int32_t condition : trained.tested_conditions()) {
    speeds.insert(trained.speed_rpm(condition));
  }
  return speeds;
}

}  // namespace

bool is_fitting_speed(const Classifier& classifier, const signal::DatasetInfo& trained,
                      double shaft_speed_rpm) {
  return std::ranges::any_of(trained_speeds_rpm(trained), [&](double rpm) {
    return shaft_speed_rpm >= classifier.slowest * rpm &&
           shaft_speed_rpm <= classifier.fastest * rpm;
  });
}

void require_fitting_signal(const Classifier& classifier, const signal::DatasetInfo& trained,
                            double sample_rate_hz, double shaft_speed_rpm,
                            const std::string& what) {
  if (sample_rate_hz < trained.sample_rate_hz) {
    throw Error(Exit::bad_input,
                fmt::format("{}: is sampled at {:g} Hz, but the classifier was trained at {:g} Hz; "
                            "record at that rate or a higher one, or train a classifier at this "
                            "rate",
                            what, sample_rate_hz, trained.sample_rate_hz));
  }
  if (is_fitting_speed(classifier, trained, shaft_speed_rpm)) return;
  const std::string all = fmt::format("{:g}", fmt::join(trained_speeds_rpm(trained), ", "));
  throw Error(
      Exit::bad_input,
      fmt::format(
          "{}: was recorded at {:g} rpm, but the classifier was trained at {} rpm and "
          "{} judges recordings at {:g} to {:g} times that speed; train a classifier for this "
          "speed (docs/strike-twin.md, if faults are known at another speed only)",
          what, shaft_speed_rpm, all, classifier.name, classifier.slowest, classifier.fastest));
}

}  // namespace piae::diagnosis
