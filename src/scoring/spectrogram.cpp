#include "scoring/spectrogram.hpp"

#include <stdexcept>

#include "scoring/spectrum.hpp"

namespace piae::scoring {

Eigen::ArrayXXd spectrogram(const Eigen::Ref<const Eigen::RowVectorXd>& window,
                            Eigen::Index segment) {
  if (segment < 2 || segment % 2 != 0 || segment > window.size()) {
    throw std::logic_error("a spectrogram needs even segments that fit into the window");
  }
  const Eigen::Index hop = segment / 2;
  Eigen::ArrayXXd power((window.size() - segment) / hop + 1, hop + 1);
  for (Eigen::Index time = 0; time < power.rows(); ++time) {
    power.row(time) = mean_power_spectrum(window.segment(time * hop, segment)).transpose();
  }
  return power;
}

}  // namespace piae::scoring
