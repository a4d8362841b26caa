#include "plan/step.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace piae::plan {

StepId Graph::add(Step step) {
  const StepId id = steps_.size();
  const auto [named, is_new] = named_.emplace(name_of(step), id);
  if (!is_new) {
    if (steps_[named->second].outputs == step.outputs) return named->second;
    throw std::logic_error("two steps of a plan are named " + name_of(step));
  }
  std::vector<StepId> needed;
  for (const Input& input : step.inputs) {
    for (const std::string& file : input.files) {
      const auto maker = maker_of(file);
      if (maker) needed.push_back(*maker);
    }
  }
  std::ranges::sort(needed);
  needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
  needs_.push_back(std::move(needed));
  for (const std::string& output : step.outputs) makers_.emplace(output, id);
  steps_.push_back(std::move(step));
  return id;
}

std::optional<StepId> Graph::maker_of(const std::string& file) const {
  const auto found = makers_.find(file);
  return found == makers_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<StepId> Graph::step_named(const std::string& name) const {
  const auto found = named_.find(name);
  return found == named_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> command_of(const Step& step) {
  std::vector<std::string> words{step.stage};
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back("--" + option);
    words.push_back(value);
  };
  if (step.settings) add("config", step.settings->file);
  for (const Input& input : step.inputs) {
    if (input.is_option) add(input.role, input.files.front());
  }
  for (const auto& [option, value] : step.options) {
    words.push_back("--" + option);
    std::istringstream values(value);
    for (std::string each; values >> each;) words.push_back(each);
  }
  words.insert(words.end(), step.words.begin(), step.words.end());
  if (!step.output_option.empty()) {
    add(step.output_option, step.outputs.front());
    if (step.outputs.size() == 1 && step.output_option == "output") return words;
  }
  words.emplace_back("--");
  words.insert(words.end(), step.outputs.begin(), step.outputs.end());
  return words;
}

}  // namespace piae::plan
