#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// Known windows that a generated window was made from: indices into the windows of C.
using Parents = std::vector<std::int32_t>;

/// n windows of equal length with their labels. Windows cut from recordings store their places
/// there; generated windows do not.
struct WindowSet {
  DatasetInfo info;
  std::size_t length = 0;                  ///< samples in a window
  std::vector<float> samples;              ///< row-major [n, length], in the unit of the recordings
  std::vector<Label> labels;               ///< [n]
  std::vector<std::string> record_names;   ///< of the recordings; empty if generated
  std::vector<std::int32_t> record;        ///< [n] index into record_names; empty if generated
  std::vector<std::int64_t> first_sample;  ///< [n] in its recording; empty if generated
  /// [n] (k, c) of each simulated window, or window generated from them; else empty.
  std::vector<DynamicParameters> parameters;
  /// [n] condition of each window, an index into info.conditions or every_condition, and shaft
  /// speed. Empty if the data set distinguishes no conditions or the generator does not know them;
  /// the speeds of recorded windows only if Recordings::have_speeds() is false, too.
  std::vector<std::int32_t> condition;
  std::vector<double> shaft_speed_rpm;
  /// [n] defect size of each window, if the records of a class differ in size; else empty.
  std::vector<double> defect_size_mm;
  /// [n] impact times in each window, in s from its first sample, ascending; empty if the generator
  /// does not know them.
  std::vector<std::vector<double>> impact_times_s;
  /// [n] known windows that each window was made from, the largest contribution first. Empty if the
  /// generator does not know them or fits all known windows of a class.
  std::vector<Parents> parents;
  /// [n] angle between two impacts at which each window begins, from 0 to 2 pi; empty if the
  /// generator does not know it.
  std::vector<double> start_angle_rad;

  [[nodiscard]] std::size_t size() const { return labels.size(); }
  [[nodiscard]] std::span<const float> window(std::size_t i) const {
    return std::span(samples).subspan(i * length, length);
  }
  /// Returns the shaft speed of a window: its own, or the data set's.
  [[nodiscard]] double speed_rpm(std::size_t i) const;
  /// Returns the defect size of a window: its own, or its class's.
  [[nodiscard]] double size_mm(std::size_t i) const;
  /// Returns the indices of the windows of a class, ascending.
  [[nodiscard]] std::vector<std::size_t> indices_of(Label label) const;
  [[nodiscard]] std::size_t count_of(Label label) const;

  /// Appends window i of another set of the same data set and length. Keeps places and other
  /// optional data only while all windows have them. Throws std::logic_error for another length.
  void append(const WindowSet& other, std::size_t i);
};

/// Returns the indices of the windows, [n], by recording and place. Without places, keeps their
/// order.
std::vector<std::size_t> in_time_order(const WindowSet& windows);

/// Writes /windows float32 [n, length], /labels and, if known, /record/name, /record/index,
/// /first_sample, /parameters float64 [n, 2] (k in N/m, c in N s/m), /condition, /shaft_speed_rpm,
/// /defect_size_mm and /start_angle_rad. Impact times, window by window: /strikes/time_s float64
/// and /strikes/window int64, the index of the window. Parents in the same way: /parents/known
/// int32 and /parents/window int64.
void write(artefact::Writer& writer, const WindowSet& windows);
/// Reads windows. Throws artefact::Refusal for labels without a class, for shapes that do not
/// match, and for constant windows, from which no classifier can learn.
WindowSet read_window_set(const artefact::Reader& reader);

}  // namespace piae::signal
