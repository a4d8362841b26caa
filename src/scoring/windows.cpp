#include "scoring/windows.hpp"

#include <stdexcept>

#include "base/bytes.hpp"

namespace piae::scoring {

Windows windows_of(const signal::WindowSet& set, Label label, std::size_t count) {
  const std::vector<std::size_t> indices = set.indices_of(label);
  if (indices.size() < count) throw std::logic_error("a class has fewer windows than requested");
  Windows windows(count, set.length);
  expect_much(windows.data(), static_cast<std::size_t>(windows.size()) * sizeof(double));
  for (std::size_t i = 0; i < count; ++i) {
    const auto window = set.window(indices[i]);
    windows.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXf>(window.data(), windows.cols()).cast<double>();
  }
  return windows;
}

}  // namespace piae::scoring
