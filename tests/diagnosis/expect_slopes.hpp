#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/wdcnn_network.hpp"
#include "support/differences.hpp"

namespace piae::diagnosis {

/// Expects the current gradients of four numbers of each parameter to be the slopes of `loss`,
/// which may compute other gradients.
template <class Loss>
void expect_slopes(WdcnnNetwork<double>& network, const Loss& loss) {
  const std::vector<double> gradients(network.gradients().begin(), network.gradients().end());
  Stream stream("parameters");
  for (const WdcnnParameter& parameter : network.layout()) {
    std::vector<std::int64_t> places;
    parameter.for_each([&](std::int64_t, std::int64_t j) { places.push_back(j); });
    for (int sample = 0; sample < 4; ++sample) {
      const auto j = static_cast<std::size_t>(places[stream.below(places.size())]);
      EXPECT_NEAR(gradients[j], central_difference(network.values()[j], 1e-6, loss),
                  1e-7 + 1e-5 * std::abs(gradients[j]))
          << parameter.spec.name;
    }
  }
}

}  // namespace piae::diagnosis
