#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// Windows of equal length with their labels: a role A, B, C or D of a split, or generated (E).
struct WindowSet {
  DatasetInfo info;
  std::size_t length = 0;            ///< samples in a window
  std::vector<float> samples;        ///< row-major [n, length]
  std::vector<std::int32_t> labels;  ///< [n], indices into info.classes
  /// [n] where each was cut: index into record_names, and first sample. Empty when generated.
  std::vector<std::string> record_names;
  std::vector<std::int32_t> record;
  std::vector<std::int64_t> first_sample;
  /// [n] (k, c) that each window has (simulated) or was generated from; else empty.
  std::vector<DynamicParameters> parameters;

  [[nodiscard]] std::size_t size() const { return labels.size(); }
  [[nodiscard]] std::span<const float> window(std::size_t i) const {
    return std::span(samples).subspan(i * length, length);
  }
  [[nodiscard]] std::vector<std::size_t> indices_of(int label) const;
  [[nodiscard]] std::size_t count_of(int label) const;

  /// Appends window i of another set of the same dataset and length. Origins and parameters stay
  /// only while all windows have them: cut and generated windows in one set keep neither.
  void append(const WindowSet& other, std::size_t i);
};

/// In the artefact: /windows float32 [n, length], /labels, and where known /record/name,
/// /record/index, /first_sample, /parameters float64 [n, 2] (k in N/m, c in N s/m).
void write(artefact::Writer& writer, const WindowSet& windows);
/// Throws artefact::Refusal for labels that do not exist, and shapes that do not fit each other.
WindowSet read_window_set(const artefact::Reader& reader);

}  // namespace piae::signal
