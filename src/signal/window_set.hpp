#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// Of which known windows a generated one was made: indices into the windows of C.
using Parents = std::vector<std::int32_t>;

/// n windows of equal length with their labels. Windows that were cut from recordings say where
/// they were cut; generated ones do not.
struct WindowSet {
  DatasetInfo info;
  std::size_t length = 0;                  ///< samples in a window
  std::vector<float> samples;              ///< row-major [n, length], in the unit of the recordings
  std::vector<Label> labels;               ///< [n]
  std::vector<std::string> record_names;   ///< of the recordings; empty when generated
  std::vector<std::int32_t> record;        ///< [n] index into record_names; empty when generated
  std::vector<std::int64_t> first_sample;  ///< [n] in its recording; empty when generated
  /// [n] the (k, c) of each window, where it was simulated or generated from them; else empty.
  std::vector<DynamicParameters> parameters;
  /// [n] the condition of each window, an index into info.conditions or every_condition; and the
  /// speed of the shaft in it. Empty where the dataset tells no conditions apart, and where a
  /// generator knows nothing of them.
  std::vector<std::int32_t> condition;
  std::vector<double> shaft_speed_rpm;
  /// [n] the size of the defect in each window, where the records of a class hold several.
  std::vector<double> defect_size_mm;
  /// [n] when the defect is struck in each window, in s from its first sample, ascending; where a
  /// generator knows.
  std::vector<std::vector<double>> strikes_s;
  /// [n] the known windows of which each was made, the one that gave most first; where a generator
  /// knows. Empty where its windows come from what was fitted to all known ones of a class.
  std::vector<Parents> parents;
  /// [n] the angle between two strikes at which each window begins, from 0 to 2 pi; where a
  /// generator knows.
  std::vector<double> start_angle_rad;

  [[nodiscard]] std::size_t size() const { return labels.size(); }
  [[nodiscard]] std::span<const float> window(std::size_t i) const {
    return std::span(samples).subspan(i * length, length);
  }
  /// The speed of the shaft in a window: its own, or that of the data set.
  [[nodiscard]] double speed_rpm(std::size_t i) const;
  /// The size of the defect in a window: its own, or that of its class.
  [[nodiscard]] double size_mm(std::size_t i) const;
  /// Which windows are of a class, ascending.
  [[nodiscard]] std::vector<std::size_t> indices_of(Label label) const;
  [[nodiscard]] std::size_t count_of(Label label) const;

  /// Appends window i of another set of the same dataset and length. The set goes on saying where
  /// windows were cut only while all of its windows say so, and the same goes for all else that
  /// windows may say.
  /// Throws std::logic_error for another length.
  void append(const WindowSet& other, std::size_t i);
};

/// [n] the indices of the windows in the order of time: by recording and place there, where these
/// are known; else as they stand.
std::vector<std::size_t> in_time_order(const WindowSet& windows);

/// In the artefact: /windows float32 [n, length], /labels, and where known /record/name,
/// /record/index, /first_sample, /parameters float64 [n, 2] (k in N/m, c in N s/m), /condition,
/// /shaft_speed_rpm, /defect_size_mm and /start_angle_rad; all strikes, window after window:
/// /strikes/time_s float64 and /strikes/window int64, the index of the window; and in the same way
/// all parents: /parents/known int32 and /parents/window int64.
void write(artefact::Writer& writer, const WindowSet& windows);
/// Throws artefact::Refusal for labels that no class has, for shapes that do not fit each other,
/// and for a window in which nothing moves, of which no classifier can learn and which no generator
/// should have made.
WindowSet read_window_set(const artefact::Reader& reader);

}  // namespace piae::signal
