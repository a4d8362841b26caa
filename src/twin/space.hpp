#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"

namespace piae::twin {

/// One point of the digital twin space: k~ and c~ of eq. 19.
struct TwinPoint {
  double k = 0;
  double c = 0;
};

/// The digital twin space (paper 3.2 and 4.4.2, eqs 14 and 15): the joint histogram of (k~, c~)
/// over all known windows, taken as a probability distribution.
class TwinSpace {
 public:
  /// Bins of equal width between the smallest and the largest value of each parameter.
  TwinSpace(const std::vector<TwinPoint>& points, int bins);
  explicit TwinSpace(const artefact::Reader& reader);

  /// A bin by its frequency, then uniform within the bin.
  [[nodiscard]] TwinPoint sample(Stream& stream) const;

  /// /twin_space/points [n, 2], k_edges and c_edges [bins + 1], counts [bins, bins] (k by c).
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

}  // namespace piae::twin
