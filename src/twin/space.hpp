#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "base/random.hpp"

namespace piae::twin {

/// Group of a model that holds its digital twin space.
inline const std::string space_group = "/twin_space";

/// One point of the digital twin space: k~ and c~ of eq. 19, dimensionless.
struct TwinPoint {
  double k = 0;
  double c = 0;
};

/// Writes points as a dataset [n, 2] of that name, and reads them.
void write_points(artefact::Writer& writer, const std::string& name,
                  const std::vector<TwinPoint>& points);
std::vector<TwinPoint> read_points(const artefact::Reader& reader, const std::string& name);

/// The digital twin space (paper 3.2 and 4.4.2, eqs 14 and 15): the joint histogram of (k~, c~)
/// over all known windows, used as a probability distribution.
class TwinSpace {
 public:
  /// Makes bins of equal width between the smallest and the largest value of each parameter.
  TwinSpace(const std::vector<TwinPoint>& points, int bins);
  /// Reads the output of write(). Throws artefact::Refusal if it is not a histogram.
  explicit TwinSpace(const artefact::Reader& reader);

  /// Draws a bin by its frequency, then a uniform point within the bin.
  [[nodiscard]] TwinPoint sample(Stream& stream) const;

  /// Writes /twin_space/points [n, 2], k_edges and c_edges [bins + 1], and counts [bins, bins] (k
  /// by c).
  void write(artefact::Writer& writer) const;

  [[nodiscard]] const std::vector<TwinPoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<double>& k_edges() const { return k_edges_; }
  [[nodiscard]] const std::vector<double>& c_edges() const { return c_edges_; }
  [[nodiscard]] const std::vector<std::int64_t>& counts() const { return counts_; }

 private:
  std::vector<TwinPoint> points_;
  std::vector<double> k_edges_;
  std::vector<double> c_edges_;
  std::vector<std::int64_t> counts_;
};

/// Returns the space of one class: the histogram of its own windows (paper 3.4: "for each fault
/// type").
TwinSpace space_of_class(const std::vector<TwinPoint>& points, const std::vector<Label>& labels,
                         Label label, int bins);

/// Throws artefact::Refusal unless all labels belong to classes of the model's data set and each
/// class with a defect has a label: a class is drawn from its own windows.
void require_points_of_faults(const artefact::Reader& model, const std::string& path,
                              const std::vector<Label>& labels);

/// Records in a model that each class is drawn from its own windows, which have these labels.
void write_labels_of_space(artefact::Writer& writer, const std::vector<Label>& labels);

/// The source of each class's points in a model: SpaceOf.
class ClassSpaces {
 public:
  /// Throws artefact::Refusal if the model does not hold a histogram.
  explicit ClassSpaces(const artefact::Reader& model);
  [[nodiscard]] TwinSpace of(Label label) const;

 private:
  TwinSpace all_;
  std::vector<Label> labels_;  ///< one per known window; empty if all classes share one space
};

}  // namespace piae::twin
