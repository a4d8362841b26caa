#pragma once

#include <Eigen/Core>

namespace piae::figures {

/// Reduces more numbers than a picture can show to the extremes of groups of neighbours.
class Thinning {
 public:
  /// Cuts `numbers` numbers, at least one, into at most `most` groups of equal size; the last group
  /// may be smaller.
  Thinning(Eigen::Index numbers, Eigen::Index most);

  [[nodiscard]] Eigen::Index groups() const { return (numbers_ + of_each_ - 1) / of_each_; }
  /// Returns the index of a group's middle, which may lie between two numbers.
  [[nodiscard]] double middle(Eigen::Index group) const;
  /// Returns the highest number of each group, [groups]. There must be as many values as numbers.
  [[nodiscard]] Eigen::ArrayXd highest(const Eigen::Ref<const Eigen::ArrayXd>& values) const;
  [[nodiscard]] Eigen::ArrayXd lowest(const Eigen::Ref<const Eigen::ArrayXd>& values) const;

 private:
  [[nodiscard]] Eigen::Index size(Eigen::Index group) const;

  Eigen::Index numbers_;
  Eigen::Index of_each_;
};

}  // namespace piae::figures
