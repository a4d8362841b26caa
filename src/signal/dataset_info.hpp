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

/// Location of a class's defect.
using bearing::Defect;

/// Convert between a defect and its word: "none", "outer", "inner", "roller", "other". parse_defect
/// throws Error(bad_input) for any other word.
std::string to_string(Defect defect);
Defect parse_defect(const std::string& word);

struct ClassInfo {
  std::string name;  ///< "IR007"
  Defect defect = Defect::none;
  /// L_o, L_i or L_r; 0 for a healthy bearing or an unknown size. The mean of the known records'
  /// sizes if the class itself has none.
  double defect_size_mm = 0;
};

/// Description of a data set that every artefact holds. A label is an index into `classes`.
struct DatasetInfo {
  std::string name;           ///< "cwru"
  double sample_rate_hz = 0;  ///< of all signals and windows, after resampling
  double shaft_speed_rpm = 0;
  double unit_m_per_s2 = 1;  ///< one unit of the signals: 9.80665 for g
  bearing::Geometry bearing;
  /// True if the bearing is described. Otherwise all faults are `other`.
  bool has_bearing = true;
  std::vector<ClassInfo> classes;
  std::vector<Condition> conditions;  ///< empty if the data set distinguishes none

  /// Returns the labels of all classes, ascending.
  [[nodiscard]] std::vector<Label> labels() const;
  /// Returns the labels of the classes with a defect, ascending.
  [[nodiscard]] std::vector<Label> fault_labels() const;
  /// Returns the label of the only class without a defect. Throws Error(bad_input) if the data set
  /// has none or several.
  [[nodiscard]] Label healthy_label() const;
  [[nodiscard]] const ClassInfo& class_of(Label label) const { return classes[index_of(label)]; }
  /// Returns the index of the condition with this name, or every_condition without one.
  [[nodiscard]] std::int32_t condition_called(const std::string& called) const;
  /// Returns the speed of a condition; the data set's for every_condition.
  [[nodiscard]] double speed_rpm(std::int32_t condition) const;
  /// Return the conditions with known or tested faults, and their mean speeds. A data set that
  /// distinguishes no conditions returns every_condition alone.
  [[nodiscard]] std::vector<std::int32_t> known_conditions() const;
  [[nodiscard]] std::vector<std::int32_t> tested_conditions() const;
  [[nodiscard]] double known_speed_rpm() const;
  [[nodiscard]] double tested_speed_rpm() const;
};

/// Writes attributes of the root and, for a described bearing, of the group /bearing; the data sets
/// /classes/name, /classes/defect and /classes/defect_size_mm; and the conditions.
void write(artefact::Writer& writer, const DatasetInfo& info);
DatasetInfo read_dataset_info(const artefact::Reader& reader);

}  // namespace piae::signal
