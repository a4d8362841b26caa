#include "readings/reading.hpp"

#include <algorithm>
#include <regex>

#include "augment/catalogue.hpp"
#include "base/error.hpp"

namespace piae::readings {

namespace {

Reading parse(const std::string& word) {
  static const std::regex settings(R"([a-z-]+=[a-z0-9.-]+(\+[a-z-]+=[a-z0-9.-]+)*)");
  if (!std::regex_match(word, settings)) {
    throw Error(
        Exit::usage,
        "--readings: '" + word +
            "' is not SETTING=VALUE; write one such as batches=class, and join several by +");
  }
  return {word};
}

}  // namespace

std::string Reading::folder() const {
  std::string below = name;
  std::ranges::replace(below, '=', '-');
  return "readings/" + below;
}

void bind(const cli::Options& command, ReadingsOptions& options) {
  command.add("--dataset", options.dataset, "Data set, such as cwru").required();
  command.add("--base", options.base,
              "Settings of each interpretation that does not override them");
  command
      .add("--readings", options.readings,
           "Interpretations in addition to base, such as: batches=class batches=class+space=class")
      .required();
  command.add("--ratios", options.ratios, "Ratios, such as: 10to1 1to1").required();
  command.add("--seeds", options.seeds, "Seeds, such as: 100 101").required();
}

Readings resolve(const ReadingsOptions& options) {
  Readings readings;
  readings.grid =
      run::resolve({options.dataset, {augment::paper_method()}, options.ratios, options.seeds});
  if (!options.base.empty()) readings.base = run::split_list("--base", options.base);
  readings.readings.push_back({"base"});
  for (const std::string& word : run::split_list("--readings", options.readings)) {
    readings.readings.push_back(parse(word));
  }
  return readings;
}

}  // namespace piae::readings
