#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"

namespace piae::signal {

/// Where the defect of a class sits.
using bearing::Defect;

/// "none", "outer", "inner", "roller". parse_defect throws Error(bad_input) for any other word.
std::string to_string(Defect defect);
Defect parse_defect(const std::string& word);

struct ClassInfo {
  std::string name;  ///< "IR007"
  Defect defect = Defect::none;
  double defect_size_mm = 0;  ///< L_o, L_i or L_r; 0 for a healthy bearing
};

/// What every artefact of a dataset knows about it. Labels are indices into `classes`.
struct DatasetInfo {
  std::string name;           ///< "cwru"
  double sample_rate_hz = 0;  ///< of all signals and windows, after resampling
  double shaft_speed_rpm = 0;
  double unit_m_per_s2 = 1;  ///< one unit of the signals: 9.80665 where they are in g
  bearing::Geometry bearing;
  std::vector<ClassInfo> classes;

  /// The label of the one class without a defect. Throws Error(bad_input) when there is none or
  /// more than one.
  [[nodiscard]] int healthy_label() const;
};

/// In the artefact: attributes of the root and of the group /bearing, and the datasets
/// /classes/name, /classes/defect, /classes/defect_size_mm.
void write(artefact::Writer& writer, const DatasetInfo& info);
DatasetInfo read_dataset_info(const artefact::Reader& reader);

}  // namespace piae::signal
