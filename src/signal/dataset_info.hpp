#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "signal/conditions.hpp"

namespace piae::signal {

/// Where the defect of a class sits.
using bearing::Defect;

/// "none", "outer", "inner", "roller", "other". parse_defect throws Error(bad_input) for any other
/// word.
std::string to_string(Defect defect);
Defect parse_defect(const std::string& word);

struct ClassInfo {
  std::string name;  ///< "IR007"
  Defect defect = Defect::none;
  /// L_o, L_i or L_r; 0 for a healthy bearing, and where nobody knows it. Where the records of the
  /// class hold several sizes: the mean of the known ones.
  double defect_size_mm = 0;
};

/// What every artefact of a dataset says about it. A label is an index into `classes`.
struct DatasetInfo {
  std::string name;           ///< "cwru"
  double sample_rate_hz = 0;  ///< of all signals and windows, after resampling
  double shaft_speed_rpm = 0;
  double unit_m_per_s2 = 1;  ///< one unit of the signals: 9.80665 where they are in g
  bearing::Geometry bearing;
  /// Whether anything is said of the bearing. Where not, all faults are `other`.
  bool has_bearing = true;
  std::vector<ClassInfo> classes;
  std::vector<Condition> conditions;  ///< empty where the dataset tells none apart

  /// The labels of all classes, ascending.
  [[nodiscard]] std::vector<Label> labels() const;
  /// The labels of the classes with a defect, ascending.
  [[nodiscard]] std::vector<Label> fault_labels() const;
  /// The label of the one class without a defect. Throws Error(bad_input) when there is none or
  /// more than one.
  [[nodiscard]] Label healthy_label() const;
  [[nodiscard]] const ClassInfo& class_of(Label label) const { return classes[index_of(label)]; }
  /// The condition called so, or every_condition where there is none.
  [[nodiscard]] std::int32_t condition_called(const std::string& called) const;
  /// The speed of a condition, or for every_condition that of the dataset.
  [[nodiscard]] double speed_rpm(std::int32_t condition) const;
  /// The conditions in which faults are known, or tested; every_condition alone where the dataset
  /// tells none apart. And the mean of their speeds.
  [[nodiscard]] std::vector<std::int32_t> known_conditions() const;
  [[nodiscard]] std::vector<std::int32_t> tested_conditions() const;
  [[nodiscard]] double known_speed_rpm() const;
  [[nodiscard]] double tested_speed_rpm() const;
};

/// In the artefact: attributes of the root and, where the bearing is described, of the group
/// /bearing; the datasets /classes/name,
/// /classes/defect, /classes/defect_size_mm, and the conditions.
void write(artefact::Writer& writer, const DatasetInfo& info);
DatasetInfo read_dataset_info(const artefact::Reader& reader);

}  // namespace piae::signal
