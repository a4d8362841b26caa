#include "signal/window_set.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "signal/amplitude.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

/// Returns the index of a name in a list. Appends a new name.
std::int32_t index_in(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  const auto index = static_cast<std::int32_t>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return index;
}

void require_movement(const artefact::Reader& reader, const WindowSet& windows) {
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (is_constant(windows.window(i))) {
      reader.refuse("/windows", "window " + std::to_string(i) + " is constant");
    }
  }
}

void require_known_labels(const artefact::Reader& reader, const WindowSet& windows) {
  const std::size_t classes = windows.info.classes.size();
  for (const Label label : windows.labels) {
    if (label < 0 || index_of(label) >= classes) {
      reader.refuse("/labels", "holds label " + std::to_string(label) + ", but there are " +
                                   std::to_string(classes) + " classes");
    }
  }
}

void read_places(const artefact::Reader& reader, WindowSet& windows) {
  windows.record_names = reader.strings("/record/name");
  windows.record = reader.numbers<std::int32_t>("/record/index", {0}).values;
  windows.first_sample = reader.numbers<std::int64_t>("/first_sample", {0}).values;
  if (windows.record.size() != windows.size()) {
    reader.refuse("/record/index", "does not match /labels");
  }
  if (windows.first_sample.size() != windows.size()) {
    reader.refuse("/first_sample", "does not match /labels");
  }
  const auto known = static_cast<std::int32_t>(windows.record_names.size());
  for (const std::int32_t index : windows.record) {
    if (index < 0 || index >= known) {
      reader.refuse("/record/index",
                    "points to record " + std::to_string(index) + " of " + std::to_string(known));
    }
  }
  reader.require_all("/first_sample", windows.first_sample, ranges::first_sample);
  for (const std::string& name : windows.record_names) {
    if (!ranges::is_plain_name(name)) {
      reader.refuse("/record/name", "holds an invalid name: it " + ranges::plain_name_rule);
    }
  }
}

void read_parameters(const artefact::Reader& reader, WindowSet& windows) {
  const auto pairs = reader.numbers<double>("/parameters", {0, 2});
  if (pairs.shape[0] != windows.size()) reader.refuse("/parameters", "does not match /labels");
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (!ranges::stiffness_n_per_m.holds(pairs.values[2 * i]) ||
        !ranges::damping_ns_per_m.holds(pairs.values[2 * i + 1])) {
      reader.refuse("/parameters", "holds a stiffness or a damping outside its range");
    }
    windows.parameters.push_back({pairs.values[2 * i], pairs.values[2 * i + 1]});
  }
}

/// Reads one number per window; empty if the artefact has none.
std::vector<double> read_each(const artefact::Reader& reader, const std::string& path,
                              std::size_t windows, const Range& range) {
  if (!reader.has(path)) return {};
  std::vector<double> values = reader.numbers<double>(path, {windows}).values;
  reader.require_all(path, values, range);
  return values;
}

void read_condition_of_windows(const artefact::Reader& reader, WindowSet& windows) {
  const std::string path = "/condition";
  if (!reader.has(path)) return;
  windows.condition = reader.numbers<std::int32_t>(path, {windows.size()}).values;
  const auto listed = static_cast<std::int32_t>(windows.info.conditions.size());
  for (const std::int32_t condition : windows.condition) {
    if (condition < every_condition || condition >= listed) {
      reader.refuse(
          path, "holds condition " + std::to_string(condition) + " of " + std::to_string(listed));
    }
  }
}

/// Paths of lists of windows: all values in the order of the windows, and next to them the window
/// of each value.
struct ListPaths {
  std::string group;
  std::string values;
  [[nodiscard]] std::string owners() const { return group + "/window"; }
};

const ListPaths impact_time_paths{.group = "/strikes", .values = "/strikes/time_s"};
const ListPaths parent_paths{.group = "/parents", .values = "/parents/known"};

template <class T>
void write_lists(artefact::Writer& writer, const ListPaths& paths,
                 const std::vector<std::vector<T>>& lists) {
  if (lists.empty()) return;
  std::vector<T> values;
  std::vector<std::int64_t> owners;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    values.insert(values.end(), lists[i].begin(), lists[i].end());
    owners.insert(owners.end(), lists[i].size(), static_cast<std::int64_t>(i));
  }
  writer.numbers(paths.values, values);
  writer.numbers(paths.owners(), owners);
}

/// Reads one list per window; empty if the artefact has none.
template <class T>
std::vector<std::vector<T>> read_lists(const artefact::Reader& reader, const ListPaths& paths,
                                       std::size_t windows) {
  if (!reader.has(paths.group)) return {};
  const std::vector<T> values = reader.numbers<T>(paths.values, {0}).values;
  const auto owners = reader.numbers<std::int64_t>(paths.owners(), {values.size()}).values;
  std::vector<std::vector<T>> lists(windows);
  std::int64_t last = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (owners[i] < last || owners[i] >= static_cast<std::int64_t>(windows)) {
      reader.refuse(paths.owners(), "does not name windows in order");
    }
    last = owners[i];
    lists[static_cast<std::size_t>(last)].push_back(values[i]);
  }
  return lists;
}

void read_impact_times(const artefact::Reader& reader, WindowSet& windows) {
  windows.impact_times_s = read_lists<double>(reader, impact_time_paths, windows.size());
  const double end_s = static_cast<double>(windows.length) / windows.info.sample_rate_hz;
  for (const std::vector<double>& own : windows.impact_times_s) {
    double last_s = 0;
    for (const double time_s : own) {
      if (!(time_s >= last_s && time_s < end_s)) {
        reader.refuse(impact_time_paths.values,
                      "holds an impact that does not follow the previous one within its window");
      }
      last_s = time_s;
    }
  }
}

void read_parents(const artefact::Reader& reader, WindowSet& windows) {
  windows.parents = read_lists<std::int32_t>(reader, parent_paths, windows.size());
  for (const Parents& own : windows.parents) {
    for (const std::int32_t known : own) {
      if (known < 0) {
        reader.refuse(parent_paths.values, "holds " + std::to_string(known) +
                                               ", which is not the index of a window of C");
      }
    }
  }
}

/// Appends entry i of another set's optional column. Clears the column if this entry or an earlier
/// one is missing.
template <class T>
void append_known(std::vector<T>& known_values, const std::vector<T>& other, std::size_t i,
                  std::size_t windows) {
  if (!other.empty() && known_values.size() == windows) {
    known_values.push_back(other[i]);
  } else {
    known_values.clear();
  }
}

}  // namespace

double WindowSet::speed_rpm(std::size_t i) const {
  return shaft_speed_rpm.empty() ? info.shaft_speed_rpm : shaft_speed_rpm[i];
}

double WindowSet::size_mm(std::size_t i) const {
  return defect_size_mm.empty() ? info.class_of(labels[i]).defect_size_mm : defect_size_mm[i];
}

std::vector<std::size_t> WindowSet::indices_of(Label label) const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == label) indices.push_back(i);
  }
  return indices;
}

std::size_t WindowSet::count_of(Label label) const {
  return static_cast<std::size_t>(std::ranges::count(labels, label));
}

void WindowSet::append(const WindowSet& other, std::size_t i) {
  if (other.length != length) throw std::logic_error("windows of different lengths in one set");
  if (!other.record.empty() && record.size() == size()) {
    const auto from = static_cast<std::size_t>(other.record[i]);
    record.push_back(index_in(record_names, other.record_names[from]));
    first_sample.push_back(other.first_sample[i]);
  } else {
    record_names.clear();
    record.clear();
    first_sample.clear();
  }
  append_known(parameters, other.parameters, i, size());
  append_known(condition, other.condition, i, size());
  append_known(shaft_speed_rpm, other.shaft_speed_rpm, i, size());
  append_known(defect_size_mm, other.defect_size_mm, i, size());
  append_known(impact_times_s, other.impact_times_s, i, size());
  append_known(parents, other.parents, i, size());
  append_known(start_angle_rad, other.start_angle_rad, i, size());
  const std::span<const float> window = other.window(i);
  samples.insert(samples.end(), window.begin(), window.end());
  labels.push_back(other.labels[i]);
}

std::vector<std::size_t> in_time_order(const WindowSet& windows) {
  std::vector<std::size_t> order(windows.size());
  std::iota(order.begin(), order.end(), 0);
  if (windows.record.empty() || windows.first_sample.empty()) return order;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::pair(windows.record[i], windows.first_sample[i]);
  });
  return order;
}

void write(artefact::Writer& writer, const WindowSet& windows) {
  write(writer, windows.info);
  writer.numbers("/windows", windows.samples, {windows.size(), windows.length});
  writer.numbers("/labels", windows.labels);
  if (!windows.record_names.empty()) {
    writer.strings("/record/name", windows.record_names);
    writer.numbers("/record/index", windows.record);
    writer.numbers("/first_sample", windows.first_sample);
  }
  if (!windows.parameters.empty()) {
    std::vector<double> pairs;
    for (const DynamicParameters& p : windows.parameters) {
      pairs.insert(pairs.end(), {p.stiffness_n_per_m, p.damping_ns_per_m});
    }
    writer.numbers("/parameters", pairs, {windows.size(), 2});
  }
  if (!windows.condition.empty()) writer.numbers("/condition", windows.condition);
  if (!windows.shaft_speed_rpm.empty()) writer.numbers("/shaft_speed_rpm", windows.shaft_speed_rpm);
  if (!windows.defect_size_mm.empty()) writer.numbers("/defect_size_mm", windows.defect_size_mm);
  if (!windows.start_angle_rad.empty()) writer.numbers("/start_angle_rad", windows.start_angle_rad);
  write_lists(writer, impact_time_paths, windows.impact_times_s);
  write_lists(writer, parent_paths, windows.parents);
}

WindowSet read_window_set(const artefact::Reader& reader) {
  WindowSet windows;
  windows.info = read_dataset_info(reader);
  if (windows.info.fault_labels().empty()) {
    reader.refuse("/classes/defect", "has no class with a defect; it must have at least one");
  }
  auto samples = reader.numbers<float>("/windows", {0, 0});
  windows.length = samples.shape[1];
  windows.samples = std::move(samples.values);
  windows.labels = reader.numbers<Label>("/labels", {0}).values;
  if (!ranges::window_samples.holds(static_cast<double>(windows.length))) {
    reader.refuse("/windows", "has windows of " + std::to_string(windows.length) +
                                  " samples; their length " + ranges::window_samples.rule());
  }
  if (windows.size() != samples.shape[0]) reader.refuse("/labels", "does not match /windows");
  require_known_labels(reader, windows);
  require_movement(reader, windows);
  if (reader.has("/record")) read_places(reader, windows);
  if (reader.has("/parameters")) read_parameters(reader, windows);
  read_condition_of_windows(reader, windows);
  windows.shaft_speed_rpm =
      read_each(reader, "/shaft_speed_rpm", windows.size(), ranges::shaft_speed_rpm);
  windows.defect_size_mm =
      read_each(reader, "/defect_size_mm", windows.size(), ranges::defect_size_mm);
  windows.start_angle_rad =
      read_each(reader, "/start_angle_rad", windows.size(), ranges::start_angle_rad);
  read_impact_times(reader, windows);
  read_parents(reader, windows);
  return windows;
}

}  // namespace piae::signal
