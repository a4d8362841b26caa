#include "nets/layer_normalisation.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace piae::nets {

std::vector<ParameterSpec> layer_normalisation_specs(const std::string& name, std::int64_t width) {
  return {{.name = name + "/scale", .shape = {width}, .constant = 1},
          {.name = name + "/shift", .shape = {width}}};
}

template <class T>
LayerNormalisation<T>::LayerNormalisation(GradientArray<T>& parameters, const std::string& name,
                                          std::int64_t length)
    : SequenceLayer<T>({.length = length, .width = parameters.find(name + "/scale").columns},
                       {.length = length, .width = parameters.find(name + "/scale").columns}),
      scale_(parameters.find(name + "/scale")),
      shift_(parameters.find(name + "/shift")) {
  if (scale_.columns != scale_.held_columns) {
    throw std::logic_error("the width of " + name + " does not fill whole rows");
  }
}

template <class T>
void LayerNormalisation<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t rows = windows * this->input().length;
  const std::int64_t width = this->input().width;
  auto normalised = as_matrix(room_for(rows * width, normalised_), rows, width).array();
  auto factor = as_matrix(room_for(rows, factor_), rows, 1).array();
  const auto scale = as_matrix(scale_.values, 1, width).array().row(0);
  const auto shift = as_matrix(shift_.values, 1, width).array().row(0);
  const auto from = as_matrix(x, rows, width).array();
  auto to = as_matrix(y, rows, width).array();
  for (std::int64_t i = 0; i < rows; ++i) {
    normalised.row(i) = from.row(i) - from.row(i).mean();
    factor(i) = 1 / std::sqrt(normalised.row(i).square().mean() + static_cast<T>(epsilon));
    normalised.row(i) *= factor(i);
    to.row(i) = normalised.row(i) * scale + shift;
  }
}

template <class T>
void LayerNormalisation<T>::backward(const SignalBatch& batch, const T*, const T* dy, T* dx) {
  const std::int64_t rows = batch.windows * this->input().length;
  const std::int64_t width = this->input().width;
  const auto normalised = as_matrix<T>(std::as_const(normalised_).data(), rows, width).array();
  const auto first = as_matrix(dy, rows, width).array();
  as_matrix(scale_.gradient, 1, width) = (first * normalised).colwise().sum().matrix();
  as_matrix(shift_.gradient, 1, width) = first.colwise().sum().matrix();
  if (dx == nullptr) return;
  const auto scale = as_matrix(scale_.values, 1, width).array().row(0);
  const auto from = as_matrix(dy, batch.signals * rows, width).array();
  auto to = as_matrix(dx, batch.signals * rows, width).array();
  for (std::int64_t i = 0; i < batch.signals * rows; ++i) {
    const auto x = normalised.row(i % rows);
    auto by_x = to.row(i);
    by_x = from.row(i) * scale;
    const T mean = by_x.mean();
    const T slope = (by_x * x).mean();
    by_x = factor_(i % rows) * (by_x - mean - slope * x);
  }
}

template class LayerNormalisation<float>;
template class LayerNormalisation<double>;

}  // namespace piae::nets
