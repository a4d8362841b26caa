#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

/// How steps of two back ends compare.
namespace piae::nets {

/// Adam's first moment of a stored group: sums of the gradients that were followed.
inline std::vector<float> first_moments(const std::function<void(artefact::Writer&)>& write_adam,
                                        const std::string& group) {
  artefact::Writer writer("model");
  write_adam(writer);
  const auto path = std::filesystem::path(testing::TempDir()) / "first_moments.h5";
  writer.save(path, {});
  return artefact::Reader(path, "model").numbers<float>(group + "/first_moment", {0}).values;
}

/// |a - b| / |b|
inline double difference(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0;
  double size = 1e-30;  // for moments that are all 0
  for (std::size_t i = 0; i < b.size(); ++i) {
    squares += std::pow(static_cast<double>(a.at(i)) - b[i], 2);
    size += std::pow(static_cast<double>(b[i]), 2);
  }
  return std::sqrt(squares / size);
}

}  // namespace piae::nets
