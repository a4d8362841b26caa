#include "signal/made_windows.hpp"

#include <algorithm>

namespace piae::signal {

WindowSet make_windows(const DatasetInfo& info, std::size_t length, std::size_t count,
                       const Stream& stream, const MakeWindow& make) {
  WindowSet windows;
  windows.info = info;
  windows.length = length;
  for (const Label label : info.fault_labels()) {
    const Stream own = stream.child(info.class_of(label).name);
    for (std::size_t i = 0; i < count; ++i) {
      Stream random = own.child(std::to_string(i));
      const std::vector<float> window = make(label, i, random);
      windows.samples.insert(windows.samples.end(), window.begin(), window.end());
      windows.labels.push_back(label);
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
