#include "phase/inference.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "nets/stored_parameters.hpp"
#include "phase/features.hpp"
#include "twin/ranges.hpp"

namespace piae::phase {

namespace {

const std::string adam_group = "/inference/adam";
const std::string network = "net";
constexpr int depth = 3;  // dense layers
constexpr auto lags = static_cast<std::int64_t>(feature_lags);
constexpr float least_spread = 1e-6F;

/// Mean and standard deviation of a logarithm that is uniform between those of two values.
struct LogScale {
  LogScale(double low, double high)
      : centre((std::log(low) + std::log(high)) / 2),
        spread((std::log(high) - std::log(low)) / std::sqrt(12.0)) {}
  double centre;
  double spread;
};

/// The scales of log k~ and log c~ of a class.
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

const std::string Inference::group = "/inference";

std::vector<nets::ParameterSpec> Inference::specs_of(std::int64_t classes, int width) {
  return nets::dense_chain_specs(network, lags + classes, 2, {.depth = depth, .width = width});
}

Inference::Inference(std::int64_t classes, int width, int batch, const Stream& stream)
    : classes_(classes),
      batch_(batch),
      specs_(specs_of(classes, width)),
      parameters_(std::make_shared<nets::Parameters<float>>(specs_, stream)),
      network_(parameters_, network, batch),
      feature_mean_(Row::Zero(lags)),
      feature_spread_(Row::Ones(lags)) {}

nets::RowArray<float> Inference::features_of(const signal::WindowSet& windows) {
  if (windows.length <= feature_lags) {
    throw Error(
        Exit::bad_input,
        fmt::format("{}: windows of {} samples are too short to infer (k, c); use {} or more",
                    windows.info.name, windows.length, feature_lags + 1));
  }
  nets::RowArray<float> all(static_cast<std::int64_t>(windows.size()), lags);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const std::vector<float> features = autocorrelation(windows.window(i));
    if (!std::isfinite(features.front())) {
      throw Error(Exit::bad_input, fmt::format("{}: window {} is constant, so (k, c) cannot be "
                                               "inferred; cut dead stretches out of the recordings",
                                               windows.info.name, i));
    }
    std::ranges::copy(features, all.row(static_cast<std::int64_t>(i)).data());
  }
  return all;
}

nets::RowArray<float> Inference::forward(const nets::RowArray<float>& features,
                                         std::span<const Label> labels) {
  for (std::int64_t i = 0; i < features.rows(); ++i) {
    float* const row = network_.input().row(i);
    Eigen::Map<Row>(row, lags) = (features.row(i) - feature_mean_) / feature_spread_;
    nets::put_one_hot(labels[static_cast<std::size_t>(i)], classes_, row + lags);
  }
  return nets::copied<float>(network_.forward(features.rows()), features.rows(), 2);
}

nets::RowArray<float> Inference::targets_of(const std::vector<twin::TwinPoint>& points,
                                            const std::vector<Label>& labels) const {
  const std::vector<PointScale> scales = scales_of(bounds_);
  nets::RowArray<float> targets(static_cast<std::int64_t>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [k, c] = scales[index_of(labels[i])];
    targets.row(static_cast<std::int64_t>(i))
        << static_cast<float>((std::log(points[i].k) - k.centre) / k.spread),
        static_cast<float>((std::log(points[i].c) - c.centre) / c.spread);
  }
  return targets;
}

double Inference::learn(const nets::RowArray<float>& features, std::span<const Label> labels,
                        const nets::RowArray<float>& targets, double learning_rate) {
  const nets::RowArray<float> error = forward(features, labels) - targets;
  nets::put<float>(error * (2.0F / static_cast<float>(error.size())), network_.output_gradient());
  network_.backward(error.rows(), 1, nets::no_rows);
  const nets::AdamStep step(++steps_, learning_rate);
  network_.take(step, 1, {.of_weights = error.rows(), .of_biases = error.rows()});
  return static_cast<double>(error.square().mean());
}

std::vector<twin::TwinPoint> Inference::infer(const signal::WindowSet& windows) {
  const nets::RowArray<float> features = features_of(windows);
  const std::vector<PointScale> scales = scales_of(bounds_);
  std::vector<twin::TwinPoint> points;
  for (std::int64_t begin = 0; begin < features.rows(); begin += batch_) {
    const std::int64_t rows = std::min(batch_, features.rows() - begin);
    const auto labels = std::span(windows.labels).subspan(static_cast<std::size_t>(begin));
    const nets::RowArray<float> found = forward(features.middleRows(begin, rows), labels);
    for (std::int64_t i = 0; i < rows; ++i) {
      const auto& [k, c] = scales[index_of(labels[static_cast<std::size_t>(i)])];
      points.push_back({std::exp(k.centre + k.spread * static_cast<double>(found(i, 0))),
                        std::exp(c.centre + c.spread * static_cast<double>(found(i, 1)))});
    }
  }
  return points;
}

void Inference::set_scale(const std::vector<Bounds>& bounds,
                          const nets::RowArray<float>& features) {
  bounds_ = bounds;
  const nets::RowArray<double> exact = features.cast<double>();
  const auto mean = exact.colwise().mean().eval();
  const auto variance =
      (exact.rowwise() - mean).square().colwise().sum() / static_cast<double>(exact.rows() - 1);
  feature_mean_ = mean.cast<float>();
  feature_spread_ = variance.sqrt().cast<float>().max(least_spread);
}

void Inference::write(artefact::Writer& writer) const {
  nets::write_parameters(writer, group, specs_,
                         parameters_->read(nets::Parameters<float>::Kept::value));
  writer.numbers(group + "/feature_mean", std::vector(feature_mean_.begin(), feature_mean_.end()));
  writer.numbers(group + "/feature_spread",
                 std::vector(feature_spread_.begin(), feature_spread_.end()));
  std::vector<double> flat;
  for (const auto& [low, high] : bounds_) {
    flat.insert(flat.end(), {low.k, high.k, low.c, high.c});
  }
  writer.numbers(group + "/bounds", flat, {bounds_.size(), 2, 2});
}

void Inference::read(const artefact::Reader& reader) {
  parameters_->write(nets::Parameters<float>::Kept::value,
                     nets::read_parameters(reader, group, specs_));
  const auto row = [&](const std::string& name) {
    const std::vector<float> values =
        reader.numbers<float>(group + "/" + name, {feature_lags}).values;
    return Row(Eigen::Map<const Row>(values.data(), lags));
  };
  feature_mean_ = row("feature_mean");
  feature_spread_ = row("feature_spread");
  if ((feature_spread_ <= 0).any()) reader.refuse(group + "/feature_spread", "is not positive");
  const auto classes = static_cast<std::size_t>(classes_);
  const auto flat = reader.numbers<double>(group + "/bounds", {classes, 2, 2}).values;
  reader.require_all(group + "/bounds", flat, twin::ranges::positive_coordinate);
  bounds_.clear();
  for (std::size_t i = 0; i < flat.size(); i += 4) {
    bounds_.push_back(
        {.low = {.k = flat[i], .c = flat[i + 2]}, .high = {.k = flat[i + 1], .c = flat[i + 3]}});
  }
}

void Inference::write_adam(artefact::Writer& writer) const {
  write_moments(writer, adam_group, *parameters_, network, steps_);
}

void Inference::read_adam(const artefact::Reader& reader) {
  steps_ = read_moments(reader, adam_group, *parameters_, network);
}

}  // namespace piae::phase
