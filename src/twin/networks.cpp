#include "twin/networks.hpp"

#include <algorithm>
#include <cmath>

#include "nets/dense_chain.hpp"

namespace piae::twin {

namespace {

using Eigen::Index;

/// Returns ln(1 + e^x). As in LibTorch, it is the identity above 20, where both agree in float.
float softplus(float x) { return x > 20 ? x : std::log1p(std::exp(x)); }

}  // namespace

Networks::Networks(const std::shared_ptr<nets::Parameters<float>>& parameters,
                   const TwinVariant& variant, const Coder& coder,
                   const NetworkShape& network_shape, Positive made_positive,
                   std::int64_t most_windows)
    : shape(network_shape),
      positive(made_positive),
      decoder(coder.decoder(parameters, 2 * most_windows)) {
  if (variant.encoder) encoder = coder.encoder(parameters, most_windows);
  if (variant.physics) {
    module = std::make_unique<nets::DenseChain<float>>(parameters, module_name, 2 * most_windows);
  }
}

RowArray<float> Networks::encode(const RowArray<float>& windows) {
  nets::put(windows, encoder->input());
  const RowArray<float> any =
      nets::copied<float>(encoder->forward(windows.rows()), windows.rows(), 2);
  return positive == Positive::softplus ? RowArray<float>(any.unaryExpr(&softplus))
                                        : RowArray<float>(any.exp());
}

RowArray<float> slope_at(const RowArray<float>& k_and_c, Positive positive) {
  // The slope of softplus is 1 - exp(-k~); expm1 keeps all digits of a small k~.
  return positive == Positive::softplus ? RowArray<float>(-(-k_and_c).expm1()) : k_and_c;
}

RowArray<float> Networks::decode(const RowArray<float>& inputs, std::span<const Label> labels) {
  for (Index i = 0; i < inputs.rows(); ++i) {
    float* const row = decoder->input().row(i);
    row[0] = inputs(i, 0);
    row[1] = inputs(i, 1);
    nets::put_one_hot(labels[static_cast<std::size_t>(i)], shape.classes, row + 2);
  }
  return nets::copied<float>(decoder->forward(inputs.rows()), inputs.rows(), shape.samples);
}

BatchMotion<float> Networks::move(const RowArray<float>& acceleration) {
  const Index rows = acceleration.rows();
  for (Index i = 0; i < rows; ++i) {
    float* const row = module->input().row(i);
    std::copy_n(acceleration.row(i).data(), shape.samples, row);
    Eigen::Map<Eigen::ArrayXf>(row + shape.samples, shape.samples) =
        Eigen::ArrayXf::LinSpaced(shape.samples, 0, 1);  // times of the samples
  }
  const nets::Rows<const float> moved = module->forward(rows);
  const nets::Rows<const float> velocity{moved.data + shape.samples, moved.stride};
  return {.displacement = nets::copied(moved, rows, shape.samples),
          .velocity = nets::copied(velocity, rows, shape.samples),
          .acceleration = acceleration};
}

std::vector<TwinPoint> encode_all(Networks& networks, std::span<const float> windows,
                                  std::int64_t batch) {
  const Eigen::Map<const RowArray<float>> all(
      windows.data(), static_cast<Index>(windows.size()) / networks.shape.samples,
      networks.shape.samples);
  std::vector<TwinPoint> points;
  for (Index i = 0; i < all.rows(); i += batch) {
    const auto some =
        as_points(networks.encode(all.middleRows(i, std::min<Index>(batch, all.rows() - i))));
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

RowArray<float> as_rows(std::span<const TwinPoint> points) {
  RowArray<float> rows(static_cast<Index>(points.size()), 2);
  for (Index i = 0; i < rows.rows(); ++i) {
    const TwinPoint& point = points[static_cast<std::size_t>(i)];
    rows.row(i) << static_cast<float>(point.k), static_cast<float>(point.c);
  }
  return rows;
}

std::vector<TwinPoint> as_points(const RowArray<float>& rows) {
  std::vector<TwinPoint> points;
  for (Index i = 0; i < rows.rows(); ++i) points.push_back({.k = rows(i, 0), .c = rows(i, 1)});
  return points;
}

}  // namespace piae::twin
