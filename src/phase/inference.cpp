#include "phase/inference.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "nets/dense.hpp"
#include "nets/torch.hpp"
#include "phase/features.hpp"

namespace piae::phase {

namespace {

const std::string group = "/inference";
const std::string network = "net";
constexpr int depth = 3;  // dense layers
constexpr auto lags = static_cast<std::int64_t>(feature_lags);

/// Centre and standard deviation of a logarithm that is uniform between those of two values.
struct LogScale {
  LogScale(double low, double high)
      : centre((std::log(low) + std::log(high)) / 2),
        spread((std::log(high) - std::log(low)) / std::sqrt(12.0)) {}
  double centre;
  double spread;
};

/// Of both, for a class.
struct PointScale {
  explicit PointScale(const Bounds& bounds)
      : k(bounds.low.k, bounds.high.k), c(bounds.low.c, bounds.high.c) {}
  LogScale k;
  LogScale c;
};

std::vector<PointScale> scales_of(const std::vector<Bounds>& bounds) {
  return {bounds.begin(), bounds.end()};
}

}  // namespace

Inference::Inference(std::int64_t classes, int width, const Stream& stream, torch::Device device)
    : classes_(classes),
      device_(device),
      parameters_(nets::dense_chain_specs(network, lags + classes, 2, {depth, width}), stream,
                  torch::kFloat32, device),
      feature_mean_(torch::zeros({lags}, torch::TensorOptions(device))),
      feature_spread_(torch::ones({lags}, torch::TensorOptions(device))) {}

torch::Tensor Inference::features_of(const signal::WindowSet& windows) const {
  if (windows.length <= feature_lags) {
    throw Error(Exit::bad_input,
                fmt::format("{}: windows of {} samples are too short to infer (k, c); {} or more "
                            "would do",
                            windows.info.name, windows.length, feature_lags + 1));
  }
  std::vector<float> flat;
  flat.reserve(windows.size() * feature_lags);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const std::vector<float> features = autocorrelation(windows.window(i));
    if (!std::isfinite(features.front())) {
      throw Error(Exit::bad_input, fmt::format("{}: window {} is constant: (k, c) of silence "
                                               "cannot be inferred",
                                               windows.info.name, i));
    }
    flat.insert(flat.end(), features.begin(), features.end());
  }
  return torch::tensor(flat).view({-1, lags}).to(device_);
}

torch::Tensor Inference::labels_of(const signal::WindowSet& windows) const {
  const std::vector<std::int64_t> labels(windows.labels.begin(), windows.labels.end());
  return torch::one_hot(torch::tensor(labels), classes_).to(device_, torch::kFloat32);
}

torch::Tensor Inference::forward(const torch::Tensor& features, const torch::Tensor& labels) const {
  const torch::Tensor standardised = (features - feature_mean_) / feature_spread_;
  return nets::run_dense_chain(parameters_, network, torch::cat({standardised, labels}, 1));
}

torch::Tensor Inference::targets_of(const std::vector<twin::TwinPoint>& points,
                                    const std::vector<std::int32_t>& labels) const {
  const std::vector<PointScale> scales = scales_of(bounds_);
  std::vector<double> flat;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [k, c] = scales[static_cast<std::size_t>(labels[i])];
    flat.push_back((std::log(points[i].k) - k.centre) / k.spread);
    flat.push_back((std::log(points[i].c) - c.centre) / c.spread);
  }
  return torch::tensor(flat, torch::kFloat64).view({-1, 2}).to(device_, torch::kFloat32);
}

std::vector<twin::TwinPoint> Inference::infer(const signal::WindowSet& windows) const {
  const torch::NoGradGuard no_grad;
  const std::vector<float> flat =
      nets::to_vector(forward(features_of(windows), labels_of(windows)));
  const std::vector<PointScale> scales = scales_of(bounds_);
  std::vector<twin::TwinPoint> points;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto& [k, c] = scales[static_cast<std::size_t>(windows.labels[i])];
    points.push_back({std::exp(k.centre + k.spread * flat[2 * i]),
                      std::exp(c.centre + c.spread * flat[2 * i + 1])});
  }
  return points;
}

void Inference::set_scale(const std::vector<Bounds>& bounds, const torch::Tensor& features) {
  bounds_ = bounds;
  feature_mean_ = features.mean(0);
  feature_spread_ = features.std(0).clamp_min(1e-6);
}

void Inference::write(artefact::Writer& writer) const {
  parameters_.write(writer, group, parameters_.values());
  writer.numbers(group + "/feature_mean", nets::to_vector(feature_mean_));
  writer.numbers(group + "/feature_spread", nets::to_vector(feature_spread_));
  std::vector<double> flat;
  for (const auto& [low, high] : bounds_) {
    flat.insert(flat.end(), {low.k, high.k, low.c, high.c});
  }
  writer.numbers(group + "/bounds", flat, {bounds_.size(), 2, 2});
}

void Inference::read(const artefact::Reader& reader) {
  parameters_.read(reader, group);
  nets::copy_into(feature_mean_,
                  reader.numbers<float>(group + "/feature_mean", {feature_lags}).values);
  nets::copy_into(feature_spread_,
                  reader.numbers<float>(group + "/feature_spread", {feature_lags}).values);
  const auto classes = static_cast<std::size_t>(classes_);
  const auto flat = reader.numbers<double>(group + "/bounds", {classes, 2, 2}).values;
  bounds_.clear();
  for (std::size_t i = 0; i < flat.size(); i += 4) {
    bounds_.push_back({{flat[i], flat[i + 2]}, {flat[i + 1], flat[i + 3]}});
  }
}

}  // namespace piae::phase
