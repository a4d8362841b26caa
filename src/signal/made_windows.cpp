#include "signal/made_windows.hpp"

#include <algorithm>

namespace piae::signal {

namespace {

template <class Value>
void append(const std::optional<Value>& value, std::vector<Value>& all) {
  if (value) all.push_back(*value);
}

}  // namespace

WindowSet make_windows(const DatasetInfo& info, std::size_t length, std::size_t count,
                       const Stream& stream, const MakeWindow& make) {
  WindowSet windows;
  windows.info = info;
  windows.length = length;
  for (const Label label : info.fault_labels()) {
    const Stream own = stream.child(info.class_of(label).name);
    for (std::size_t i = 0; i < count; ++i) {
      Stream random = own.child(std::to_string(i));
      const MadeWindow window = make(label, i, random);
      windows.samples.insert(windows.samples.end(), window.samples.begin(), window.samples.end());
      windows.labels.push_back(label);
      append(window.impact_times_s, windows.impact_times_s);
      append(window.parameters, windows.parameters);
      append(window.condition, windows.condition);
      append(window.shaft_speed_rpm, windows.shaft_speed_rpm);
      append(window.parents, windows.parents);
    }
  }
  return windows;
}

Parents parents_of(std::initializer_list<std::size_t> known) {
  Parents parents;
  for (const std::size_t i : known) {
    const auto index = static_cast<std::int32_t>(i);
    if (std::ranges::find(parents, index) == parents.end()) parents.push_back(index);
  }
  return parents;
}

}  // namespace piae::signal
