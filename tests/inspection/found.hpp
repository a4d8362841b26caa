#pragma once

#include <string>
#include <vector>

#include "inspection/check.hpp"

namespace piae::inspection {

/// A description with a healthy class, and an outer, an inner and a roller defect of CWRU's
/// bearing, one record each, and the results of a check on good recordings.
struct Found {
  Found() {
    using signal::Defect;
    description.info.name = "rig";
    description.info.sample_rate_hz = 12000;
    description.info.shaft_speed_rpm = 1797;
    description.info.unit_m_per_s2 = 9.80665;
    description.info.classes = {{"ok", Defect::none, 0},
                                {"outer", Defect::outer, 0.5},
                                {"inner", Defect::inner, 0.5},
                                {"ball", Defect::roller, 0.5}};
    for (const Label label : description.info.labels()) {
      const std::string& name = description.info.class_of(label).name;
      description.records.push_back({name, label, {name + ".csv"}, "2", 12000, 1797, "", ""});
      RecordCheck record;
      record.source = description.records.back();
      record.file_samples = 120000;
      record.pieces = {120000};
      record.level = Level{1, 3, 4};
      record.lines = fault_lines({}, description.info, 1797);
      for (FaultLine& line : record.lines) {
        line.noise_db = 1.6;
        set(line, line.fault_type == description.info.class_of(label).defect ? 20 : 1);
      }
      check.records.push_back(record);
      check.classes.push_back({label, 1, 200, 0.8, 0.08, ""});
    }
  }

  /// Sets a line, which stands out above 3 dB.
  static void set(FaultLine& line, double db) {
    line.db = db;
    line.stands_out = db > 3;
    line.harmonics_above_noise = db > 2 ? 3 : 0;
    line.share_elsewhere = line.stands_out ? 0 : 0.4;
  }
  FaultLine& line(Label label, std::size_t which) {
    return check.records[index_of(label)].lines.at(which);
  }

  signal::Description description;
  DatasetCheck check;
};

}  // namespace piae::inspection
