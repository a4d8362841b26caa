#include "signal/conditions.hpp"

#include <algorithm>
#include <set>

#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

const std::string conditions_group = "/conditions";

/// A use of a condition: its name in the artefact and its flag.
struct Use {
  const char* name;
  bool Condition::*flag;
};
constexpr Use uses[] = {
    {"known", &Condition::known}, {"test", &Condition::test}, {"healthy", &Condition::healthy}};

std::vector<std::string> read_names(const artefact::Reader& reader) {
  const std::string path = conditions_group + "/name";
  std::vector<std::string> names = reader.strings(path);
  if (names.empty()) reader.refuse(path, "is empty");
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!is_condition_name(name)) reader.refuse(path, "holds a name that " + condition_name_rule);
    if (!seen.insert(name).second) reader.refuse(path, "has " + name + " twice");
  }
  return names;
}

void read_use(const artefact::Reader& reader, const Use& use, std::vector<Condition>& conditions) {
  const std::string path = conditions_group + "/" + use.name;
  const auto flags = reader.numbers<std::int32_t>(path, {conditions.size()}).values;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (flags[i] != 0 && flags[i] != 1) reader.refuse(path, "holds a value other than 0 and 1");
    conditions[i].*use.flag = flags[i] == 1;
  }
  if (std::ranges::none_of(conditions, use.flag)) reader.refuse(path, "is 0 for all conditions");
}

}  // namespace

bool is_transfer(std::span<const Condition> conditions) {
  return std::ranges::any_of(conditions, [](const Condition& c) { return c.known != c.test; });
}

bool is_condition_name(const std::string& name) {
  std::string without_spaces = name;
  std::ranges::replace(without_spaces, ' ', '-');
  return ranges::is_plain_name(without_spaces) && name.front() != ' ' && name.back() != ' ' &&
         name.find("  ") == std::string::npos;
}

void write(artefact::Writer& writer, std::span<const Condition> conditions) {
  if (conditions.empty()) return;
  std::vector<std::string> names;
  std::vector<double> speeds;
  for (const Condition& condition : conditions) {
    names.push_back(condition.name);
    speeds.push_back(condition.shaft_speed_rpm);
  }
  writer.strings(conditions_group + "/name", names);
  writer.numbers(conditions_group + "/shaft_speed_rpm", speeds);
  for (const Use& use : uses) {
    std::vector<std::int32_t> flags;
    for (const Condition& condition : conditions) flags.push_back(condition.*use.flag ? 1 : 0);
    writer.numbers(conditions_group + "/" + use.name, flags);
  }
}

std::vector<Condition> read_conditions(const artefact::Reader& reader) {
  if (!reader.has(conditions_group)) return {};
  std::vector<Condition> conditions;
  for (std::string& name : read_names(reader)) conditions.push_back({.name = std::move(name)});
  const std::string speeds_path = conditions_group + "/shaft_speed_rpm";
  const auto speeds = reader.numbers<double>(speeds_path, {conditions.size()}).values;
  reader.require_all(speeds_path, speeds, ranges::shaft_speed_rpm);
  for (std::size_t i = 0; i < conditions.size(); ++i) conditions[i].shaft_speed_rpm = speeds[i];
  for (const Use& use : uses) read_use(reader, use, conditions);
  return conditions;
}

}  // namespace piae::signal
