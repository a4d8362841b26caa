#include "plan/costs.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <vector>

#include "run/step_costs.hpp"

namespace piae::plan {

namespace {

std::string key_of(const std::string& stage, const std::string& dataset, const std::string& method,
                   const std::string& ratio) {
  return stage + '|' + dataset + '|' + method + '|' + ratio;
}

/// Names a stage and its classifier. Each classifier counts as a stage of its own.
std::string stage_by(const std::string& stage, const std::string& classifier) {
  return classifier.empty() ? stage : stage + " by " + classifier;
}

/// Returns the keys under which the costs of a step are stored, the most specific first.
std::array<std::string, 6> keys_of(const std::string& stage, const Place& place) {
  const std::string by = stage_by(stage, place.classifier);
  return {key_of(by, place.dataset, place.method, place.ratio),
          key_of(by, "", place.method, place.ratio),
          key_of(by, place.dataset, "", place.ratio),
          key_of(by, "", "", place.ratio),
          by,
          ""};
}

}  // namespace

void Costs::learn(const std::string& stage, const Place& place, const Cost& cost) {
  for (const std::string& key : keys_of(stage, place)) {
    Cost& most = known_[key];
    most.seconds = std::max(most.seconds, cost.seconds);
    most.megabytes = std::max(most.megabytes, cost.megabytes);
  }
}

Costs Costs::read(const std::filesystem::path& file) {
  Costs costs;
  for (const run::StepCost& cost : run::read_costs(file)) {
    costs.learn(cost.stage,
                {.dataset = cost.dataset,
                 .method = cost.method,
                 .ratio = cost.ratio,
                 .classifier = cost.classifier},
                {.seconds = cost.seconds, .megabytes = cost.megabytes});
  }
  return costs;
}

std::string measured_costs(const Plan& plan, Logs& logs) {
  struct Sum {
    double seconds = 0;
    double megabytes = 0;
    std::size_t count = 0;
  };
  std::map<std::string, Sum> sums;
  for (const Step& step : plan.graph().steps()) {
    const Place& place = step.place;
    const bool has_moved_setting = place.unit != place.method;
    if (step.log == "features" || has_moved_setting) continue;
    const auto log = logs.read(log_of(step));
    if (!log || log->end != run::StepEnd::done || !log->processor_s) continue;
    Sum& sum = sums[fmt::format("{},{},{},{},{}", step.stage, place.dataset, place.method,
                                place.classifier, place.ratio)];
    sum.seconds += *log->processor_s;
    sum.megabytes = std::max(sum.megabytes, log->memory_mb.value_or(0));
    ++sum.count;
  }
  std::string text = "stage,dataset,method,classifier,ratio,seconds,megabytes\n";
  for (const auto& [key, sum] : sums) {
    text += fmt::format("{},{:.2f},{:.0f}\n", key, sum.seconds / static_cast<double>(sum.count),
                        sum.megabytes);
  }
  return text;
}

Costs::Estimate Costs::of(const Step& step) const {
  const std::string stage = step.stage;
  const auto keys = keys_of(stage, step.place);
  const bool is_training = stage == "train";
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (is_training && (i == 2 || i == 3)) continue;  // methods train differently
    const auto found = known_.find(keys[i]);
    if (found == known_.end()) continue;
    return {found->second, i == 5 || (is_training && i > 1)};
  }
  return {{}, true};
}

}  // namespace piae::plan
