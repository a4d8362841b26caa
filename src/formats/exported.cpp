#include "formats/exported.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"

namespace piae::formats {

namespace {

using signal::WindowSet;

std::vector<std::string> class_names(const signal::DatasetInfo& info) {
  std::vector<std::string> names;
  for (const signal::ClassInfo& c : info.classes) names.push_back(c.name);
  return names;
}

/// Returns which classes are named; all if `classes` is empty.
std::vector<bool> wanted_of(const signal::DatasetInfo& info,
                            const std::vector<std::string>& classes) {
  const std::vector<std::string> names = class_names(info);
  std::vector<bool> wanted(names.size(), classes.empty());
  for (const std::string& name : classes) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
      throw Error(Exit::usage,
                  fmt::format("--class {}: the data set {} has no such class; it has {}", name,
                              info.name, fmt::join(names, ", ")));
    }
    wanted[static_cast<std::size_t>(found - names.begin())] = true;
  }
  return wanted;
}

/// Returns function(i) for each window i.
template <class Values, class Function>
Values of_each(const WindowSet& windows, const Function& function) {
  Values values;
  values.reserve(windows.size());
  for (std::size_t i = 0; i < windows.size(); ++i) values.push_back(function(i));
  return values;
}

std::string condition_name(const WindowSet& windows, std::size_t i) {
  const std::int32_t condition = windows.condition[i];
  return condition == signal::every_condition
             ? std::string("every")
             : windows.info.conditions[static_cast<std::size_t>(condition)].name;
}

/// Adds facts that only generated windows have.
void add_generated(const WindowSet& windows, std::vector<Fact>& facts) {
  if (!windows.parameters.empty()) {
    facts.push_back({"k_n_per_m", of_each<Numbers>(windows, [&](std::size_t i) {
                       return windows.parameters[i].stiffness_n_per_m;
                     })});
    facts.push_back({"c_ns_per_m", of_each<Numbers>(windows, [&](std::size_t i) {
                       return windows.parameters[i].damping_ns_per_m;
                     })});
  }
  if (!windows.start_angle_rad.empty()) {
    facts.push_back({"start_angle_rad", windows.start_angle_rad});
  }
  if (!windows.parents.empty()) {
    facts.push_back({"parents", of_each<Lists>(windows, [&](std::size_t i) {
                       const signal::Parents& parents = windows.parents[i];
                       return std::vector<double>(parents.begin(), parents.end());
                     })});
  }
  if (!windows.impact_times_s.empty()) facts.push_back({"strikes_s", windows.impact_times_s});
}

}  // namespace

Exported select(const WindowSet& windows, const std::vector<std::string>& classes,
                std::size_t count) {
  const std::vector<bool> wanted = wanted_of(windows.info, classes);
  std::vector<std::size_t> taken(wanted.size());
  Exported exported;
  exported.windows.info = windows.info;
  exported.windows.length = windows.length;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const std::size_t label = index_of(windows.labels[i]);
    if (!wanted[label] || (count > 0 && taken[label] == count)) continue;
    ++taken[label];
    exported.windows.append(windows, i);
    exported.rows.push_back(i);
  }
  if (exported.rows.empty()) {
    throw Error(
        Exit::bad_input,
        classes.empty()
            ? std::string("holds no window, so there is nothing to export")
            : fmt::format("holds no window of {}; leave out --class to export other classes",
                          fmt::join(classes, ", ")));
  }
  return exported;
}

Facts facts_of(const Exported& exported) {
  const WindowSet& windows = exported.windows;
  const signal::DatasetInfo& info = windows.info;
  Facts facts;
  facts.of_all = {{"dataset", Texts{info.name}}, {"role", Texts{exported.role}}};
  if (!exported.method.empty()) facts.of_all.push_back({"method", Texts{exported.method}});
  facts.of_all.push_back({"sample_rate_hz", Numbers{info.sample_rate_hz}});
  facts.of_all.push_back({"unit_m_per_s2", Numbers{info.unit_m_per_s2}});

  std::vector<Fact>& each = facts.of_each;
  const auto class_of = [&](std::size_t i) { return info.class_of(windows.labels[i]); };
  each.push_back({"window", Numbers(exported.rows.begin(), exported.rows.end())});
  each.push_back(
      {"class_name", of_each<Texts>(windows, [&](std::size_t i) { return class_of(i).name; })});
  each.push_back({"defect", of_each<Texts>(windows, [&](std::size_t i) {
                    return signal::to_string(class_of(i).defect);
                  })});
  each.push_back({"defect_size_mm",
                  of_each<Numbers>(windows, [&](std::size_t i) { return windows.size_mm(i); })});
  each.push_back({"shaft_speed_rpm",
                  of_each<Numbers>(windows, [&](std::size_t i) { return windows.speed_rpm(i); })});
  if (!windows.condition.empty()) {
    each.push_back({"condition", of_each<Texts>(windows, [&](std::size_t i) {
                      return condition_name(windows, i);
                    })});
  }
  if (!windows.record.empty()) {
    each.push_back({"record", of_each<Texts>(windows, [&](std::size_t i) {
                      return windows.record_names[static_cast<std::size_t>(windows.record[i])];
                    })});
    each.push_back(
        {"first_sample", Numbers(windows.first_sample.begin(), windows.first_sample.end())});
  }
  add_generated(windows, each);
  return facts;
}

}  // namespace piae::formats
