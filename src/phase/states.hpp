#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/label.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// Scales (k~, c~) for the decoder. Within a class they differ by some percent, but from class to
/// class by an order of magnitude. So the decoder is given log k~ and log c~ less their mean over
/// the known windows of the class and divided by their standard deviation there.
class StateScale {
 public:
  /// `points` are the (k~, c~) of the known windows, `labels` the classes of these.
  StateScale(const std::vector<twin::TwinPoint>& points, std::span<const Label> labels,
             std::size_t classes);

  /// What the decoder is given in the place of a point of this class.
  [[nodiscard]] twin::TwinPoint standardised(const twin::TwinPoint& point, Label label) const;
  [[nodiscard]] std::vector<twin::TwinPoint> standardised(
      const std::vector<twin::TwinPoint>& points, std::span<const Label> labels) const;

 private:
  struct Class {
    twin::TwinPoint mean;    ///< of log k~ and log c~
    twin::TwinPoint spread;  ///< their standard deviations; 1 where all points are equal
  };
  std::vector<Class> classes_;
};

}  // namespace piae::phase
