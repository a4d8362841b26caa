#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "twin/space.hpp"

namespace piae::phase {

/// Makes (k~, c~) fit for the decoder. Within a class they differ by some percent, from class to
/// class by an order of magnitude: so log k~ and log c~ are freed of their class's mean and divided
/// by its standard deviation over the known windows.
class StateScale {
 public:
  StateScale(const std::vector<twin::TwinPoint>& points, std::span<const std::int32_t> labels,
             std::size_t classes);

  [[nodiscard]] twin::TwinPoint standardised(const twin::TwinPoint& point, std::size_t label) const;
  [[nodiscard]] std::vector<twin::TwinPoint> standardised(
      const std::vector<twin::TwinPoint>& points, std::span<const std::int32_t> labels) const;

 private:
  struct Class {
    twin::TwinPoint mean;    ///< of log k~ and log c~
    twin::TwinPoint spread;  ///< their standard deviations; 1 for a class of equal points
  };
  std::vector<Class> classes_;
};

}  // namespace piae::phase
