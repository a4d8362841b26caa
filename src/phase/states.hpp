#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/label.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// Scales (k~, c~) for the decoder. They vary by some percent within a class, but by an order of
/// magnitude between classes. So the decoder receives log k~ and log c~ minus their mean over the
/// known windows of the class, divided by their standard deviation.
class StateScale {
 public:
  /// `points` are the (k~, c~) of the known windows, `labels` their classes.
  StateScale(const std::vector<twin::TwinPoint>& points, std::span<const Label> labels,
             std::size_t classes);

  /// Returns the decoder's input for a point of this class.
  [[nodiscard]] twin::TwinPoint standardised(const twin::TwinPoint& point, Label label) const;
  [[nodiscard]] std::vector<twin::TwinPoint> standardised(
      const std::vector<twin::TwinPoint>& points, std::span<const Label> labels) const;

 private:
  struct Class {
    twin::TwinPoint mean;    ///< mean of log k~ and log c~
    twin::TwinPoint spread;  ///< their standard deviations; 1 if all points are equal
  };
  std::vector<Class> classes_;
};

}  // namespace piae::phase
