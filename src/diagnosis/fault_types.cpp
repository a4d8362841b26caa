#include "diagnosis/fault_types.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "symptoms/measures.hpp"

namespace piae::diagnosis {

namespace {

using signal::DatasetInfo;

void require_lines(const DatasetInfo& info) {
  for (const Label label : info.fault_labels()) {
    const signal::ClassInfo& own = info.class_of(label);
    if (bearing::causes_impacts(own.defect)) continue;
    throw Error(Exit::bad_input,
                fmt::format("class {} of data set {} has defect '{}', which does not have a fault "
                            "line; rules detect defects of the bearing only: choose another "
                            "--classifier, such as wdcnn or nearest",
                            own.name, info.name, signal::to_string(own.defect)));
  }
}

void require_one_class_a_type(const DatasetInfo& info) {
  const std::vector<Label> faults = info.fault_labels();
  for (auto label = faults.begin(); label != faults.end(); ++label) {
    const signal::ClassInfo& own = info.class_of(*label);
    const auto other = std::find_if(faults.begin(), label, [&](Label earlier) {
      return info.class_of(earlier).defect == own.defect;
    });
    if (other == label) continue;
    throw Error(
        Exit::bad_input,
        fmt::format("rules tell fault types apart, but data set {} has several classes of one "
                    "type, {} and {}; choose a data set with one class of each type, such as "
                    "cwru-types, or another --classifier",
                    info.name, info.class_of(*other).name, own.name));
  }
}

}  // namespace

std::size_t place_among_types(signal::Defect fault_type) {
  return static_cast<std::size_t>(std::ranges::find(symptoms::fault_types, fault_type) -
                                  symptoms::fault_types.begin());
}

void require_fault_types(const DatasetInfo& info) {
  require_lines(info);
  require_one_class_a_type(info);
}

}  // namespace piae::diagnosis
