#pragma once

#include <cmath>
#include <string>

#include "signal/recordings.hpp"

namespace piae::signal {

/// Returns a record whose samples all differ: sample i is label * 1e6 + number * 1e5 + i.
inline Record counting_record(const std::string& name, int label, int number, std::size_t samples) {
  Record record;
  record.name = name;
  record.label = label;
  record.original_sample_rate_hz = 12000;
  record.shaft_speed_rpm = 1797;
  record.source = "simulated";
  for (std::size_t i = 0; i < samples; ++i) {
    record.signal.push_back(label * 1e6 + number * 1e5 + static_cast<double>(i));
  }
  return record;
}

/// Returns three classes; the inner one has two records.
inline Recordings counting_recordings(std::size_t samples) {
  Recordings r;
  r.info.name = "counting";
  r.info.sample_rate_hz = 12000;
  r.info.shaft_speed_rpm = 1797;
  r.info.classes = {{"N", Defect::none, 0}, {"I", Defect::inner, 0.2}, {"R", Defect::roller, 0.5}};
  r.records = {counting_record("I-01", 1, 0, samples / 2),
               counting_record("I-02", 1, 1, samples / 2), counting_record("N", 0, 0, samples),
               counting_record("R", 2, 0, samples)};
  return r;
}

/// Returns three classes at two speeds, all samples different: known at 900 rpm, tested at 1200
/// rpm.
inline Recordings counting_transfer(std::size_t samples) {
  Recordings r = counting_recordings(1);
  r.info.conditions = {{.name = "900 rpm", .shaft_speed_rpm = 900, .test = false},
                       {.name = "1200 rpm", .shaft_speed_rpm = 1200, .known = false}};
  r.records.clear();
  for (int label = 0; label < 3; ++label) {
    for (int condition = 0; condition < 2; ++condition) {
      const std::string name = r.info.class_of(label).name + (condition == 0 ? "-900" : "-1200");
      r.records.push_back(counting_record(name, label, condition, samples));
      r.records.back().condition = condition;
      r.records.back().shaft_speed_rpm = condition == 0 ? 900 : 1190;
    }
  }
  return r;
}

}  // namespace piae::signal
