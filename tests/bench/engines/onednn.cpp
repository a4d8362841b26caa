#include <algorithm>
#include <array>
#include <oneapi/dnnl/dnnl.hpp>
#include <optional>
#include <string>
#include <unordered_map>

#include "bench/engines/backend.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "diagnosis/wdcnn_weights.hpp"
#include "nets/adam.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::bench {

namespace {

using diagnosis::BatchNormalisation;
using diagnosis::Convolution;
using diagnosis::WdcnnLayers;
using dnnl::memory;
using Dims = memory::dims;

memory::desc plain(const Dims& dims) {
  constexpr std::array tags{memory::format_tag::a, memory::format_tag::ab, memory::format_tag::abc,
                            memory::format_tag::abcd};
  return {dims, memory::data_type::f32, tags.at(dims.size() - 1)};
}
memory::desc any(const Dims& dims) {
  return {dims, memory::data_type::f32, memory::format_tag::any};
}

Dims dims_of(const memory::desc& layout) {
#if DNNL_VERSION_MAJOR >= 3
  return layout.get_dims();
#else
  return layout.dims();
#endif
}

/// Describes a primitive, by oneDNN 2 or 3.
template <class Primitive, class... Arguments>
typename Primitive::primitive_desc describe(const dnnl::engine& engine,
                                            const Arguments&... arguments) {
#if DNNL_VERSION_MAJOR >= 3
  return {engine, arguments...};
#else
  return {typename Primitive::desc(arguments...), engine};
#endif
}
/// Describes a primitive of the backward pass.
template <class Primitive, class Hint, class... Arguments>
typename Primitive::primitive_desc describe_backward(const dnnl::engine& engine, const Hint& hint,
                                                     const Arguments&... arguments) {
#if DNNL_VERSION_MAJOR >= 3
  return {engine, arguments..., hint};
#else
  return {typename Primitive::desc(arguments...), engine, hint};
#endif
}

const auto normalisation_flags = dnnl::normalization_flags::use_scale |
                                 dnnl::normalization_flags::use_shift |
                                 dnnl::normalization_flags::fuse_norm_relu;

dnnl::batch_normalization_forward::primitive_desc describe_normalisation(const dnnl::engine& engine,
                                                                         const memory::desc& data) {
  return describe<dnnl::batch_normalization_forward>(
      engine, dnnl::prop_kind::forward_training, data,
#if DNNL_VERSION_MAJOR >= 3
      data,
#endif
      static_cast<float>(BatchNormalisation::epsilon), normalisation_flags);
}

dnnl::batch_normalization_backward::primitive_desc describe_normalisation_backward(
    const dnnl::engine& engine, const dnnl::batch_normalization_forward::primitive_desc& forward,
    const memory::desc& data) {
  return describe_backward<dnnl::batch_normalization_backward>(
      engine, forward, dnnl::prop_kind::backward, data, data,
#if DNNL_VERSION_MAJOR >= 3
      data,
#endif
      static_cast<float>(BatchNormalisation::epsilon), normalisation_flags);
}

dnnl::pooling_forward::primitive_desc describe_pooling(const dnnl::engine& engine,
                                                       const memory::desc& from,
                                                       const memory::desc& to) {
  const Dims pooling{1, WdcnnLayers::pooling};
  return describe<dnnl::pooling_forward>(engine, dnnl::prop_kind::forward_training,
                                         dnnl::algorithm::pooling_max, from, to, pooling, pooling,
#if DNNL_VERSION_MAJOR >= 3
                                         Dims{0, 0},
#endif
                                         Dims{0, 0}, Dims{0, 0});
}

dnnl::pooling_backward::primitive_desc describe_pooling_backward(
    const dnnl::engine& engine, const dnnl::pooling_forward::primitive_desc& forward,
    const memory::desc& from, const memory::desc& to) {
  const Dims pooling{1, WdcnnLayers::pooling};
  return describe_backward<dnnl::pooling_backward>(engine, forward, dnnl::algorithm::pooling_max,
                                                   from, to, pooling, pooling,
#if DNNL_VERSION_MAJOR >= 3
                                                   Dims{0, 0},
#endif
                                                   Dims{0, 0}, Dims{0, 0});
}

// oneDNN 2.6 computes batch normalisation slowly unless windows have two axes: [batch, channels, 1,
// times].

/// A value of the network and its gradient, in the layout of the primitive that makes it.
struct Value {
  memory value;
  memory gradient;
};

class OnednnBackend final : public EngineBackend {
 public:
  OnednnBackend(diagnosis::LabelledWindows train, const diagnosis::WdcnnOptions& options,
                const Stream& initial)
      : EngineBackend(std::move(train)),
        batch_(options.batch),
        learning_rate_(options.learning_rate),
        input_(plain({batch_, 1, 1, length}), engine_),
        specs_(diagnosis::wdcnn_parameters(length, classes)) {
    build(initial);
  }

 private:
  static constexpr std::int64_t length = 1024;
  static constexpr std::int64_t classes = 10;
  using Arguments = std::unordered_map<int, memory>;
  struct Call {
    dnnl::primitive primitive;
    Arguments arguments;
  };
  /// A parameter and its place in the arrays of all parameters.
  struct Parameter {
    memory value;
    memory gradient;
  };

  void build(const Stream& initial);
  Value convolve(std::size_t i, const Value& from, bool by_input);
  Value dense(const std::string& name, const Value& from, bool with_bias);
  Value normalise(const std::string& name, const Value& from);
  Value pool(const Value& from);
  Value flatten(const Value& from);

  /// Returns a parameter in this layout, with its initial values.
  Parameter parameter(const std::string& name, const memory::desc& layout);
  /// Returns the memory in another layout, after a copy if it differs.
  memory in_layout(const memory& from, const memory::desc& layout, std::vector<Call>& calls);
  /// Adds what copies `from` into the given memory, or lets the primitive write there at once.
  void copy(const memory& from, const memory& to, std::vector<Call>& calls) {
    calls.push_back({dnnl::reorder(from, to), {{DNNL_ARG_FROM, from}, {DNNL_ARG_TO, to}}});
  }
  memory scratch(const memory::desc& layout) { return {layout, engine_}; }
  void add_backward(std::vector<Call> calls) {
    backward_.insert(backward_.begin(), calls.begin(), calls.end());
  }

  diagnosis::BatchOutcome learn(std::span<const float* const> windows,
                                std::span<const Label> labels) override;
  void run(const std::vector<Call>& calls) {
    for (const Call& call : calls) call.primitive.execute(stream_, call.arguments);
    stream_.wait();
  }

  std::int64_t batch_;
  double learning_rate_;
  dnnl::engine engine_{dnnl::engine::kind::cpu, 0};
  dnnl::stream stream_{engine_};
  memory input_;
  std::vector<nets::ParameterSpec> specs_;
  const Stream* initial_ = nullptr;
  std::vector<float> values_;
  std::vector<float> gradients_;
  std::vector<Call> forward_;
  std::vector<Call> backward_;  ///< in the order of their execution
  memory logits_;
  memory logits_gradient_;
  std::optional<nets::Adam<float>> adam_;
};

OnednnBackend::Parameter OnednnBackend::parameter(const std::string& name,
                                                  const memory::desc& layout) {
  const auto spec = std::ranges::find(specs_, name, &nets::ParameterSpec::name);
  std::vector<double> initial = nets::initial_values(*spec, *initial_);
  std::vector<float> rounded(initial.begin(), initial.end());
  const memory::desc own = plain(dims_of(layout));
  memory from(own, engine_, rounded.data());
  const std::size_t at = values_.size();
  constexpr std::size_t granule = 16;  // floats of a cache line
  const std::size_t size = (layout.get_size() / sizeof(float) + granule - 1) / granule * granule;
  values_.resize(at + size);  // within the capacity, so that earlier parameters stay in place
  gradients_.resize(at + size);
  Parameter made{memory(layout, engine_, values_.data() + at),
                 memory(layout, engine_, gradients_.data() + at)};
  dnnl::reorder(from, made.value).execute(stream_, from, made.value);
  stream_.wait();
  return made;
}

memory OnednnBackend::in_layout(const memory& from, const memory::desc& layout,
                                std::vector<Call>& calls) {
  if (from.get_desc() == layout) return from;
  memory to = scratch(layout);
  copy(from, to, calls);
  return to;
}

Value OnednnBackend::convolve(std::size_t i, const Value& from, bool by_input) {
  const Convolution& c = WdcnnLayers::convolutions.at(i);
  const Dims from_dims = dims_of(from.value.get_desc());
  const Dims to_dims{batch_, c.outputs, 1, c.output_length(from_dims[3])};
  const Dims weight_dims{c.outputs, c.inputs, 1, c.width};
  const Dims stride{1, c.stride};
  const Dims padding{0, c.padding};
  constexpr auto algorithm = dnnl::algorithm::convolution_direct;
  const auto forward = describe<dnnl::convolution_forward>(
      engine_, dnnl::prop_kind::forward_training, algorithm, any(from_dims), any(weight_dims),
      any(to_dims), stride, padding, padding);
  const Parameter weight = parameter(diagnosis::layer_name(i) + "/weight", forward.weights_desc());
  const memory source = in_layout(from.value, forward.src_desc(), forward_);
  const Value to{scratch(forward.dst_desc()), scratch(forward.dst_desc())};
  forward_.push_back(
      {dnnl::convolution_forward(forward),
       {{DNNL_ARG_SRC, source}, {DNNL_ARG_WEIGHTS, weight.value}, {DNNL_ARG_DST, to.value}}});

  std::vector<Call> calls;
  const auto by_weight = describe_backward<dnnl::convolution_backward_weights>(
      engine_, forward, algorithm, any(from_dims), any(weight_dims), any(to_dims), stride, padding,
      padding);
  const memory weight_gradient = by_weight.diff_weights_desc() == forward.weights_desc()
                                     ? weight.gradient
                                     : scratch(by_weight.diff_weights_desc());
  const memory source_again = in_layout(source, by_weight.src_desc(), calls);
  const memory gradient = in_layout(to.gradient, by_weight.diff_dst_desc(), calls);
  calls.push_back({dnnl::convolution_backward_weights(by_weight),
                   {{DNNL_ARG_SRC, source_again},
                    {DNNL_ARG_DIFF_DST, gradient},
                    {DNNL_ARG_DIFF_WEIGHTS, weight_gradient}}});
  if (weight_gradient != weight.gradient) copy(weight_gradient, weight.gradient, calls);
  if (by_input) {
    const auto by_source = describe_backward<dnnl::convolution_backward_data>(
        engine_, forward, algorithm, any(from_dims), any(weight_dims), any(to_dims), stride,
        padding, padding);
    const memory own_weight = in_layout(weight.value, by_source.weights_desc(), calls);
    const memory own_gradient = in_layout(to.gradient, by_source.diff_dst_desc(), calls);
    const bool same = by_source.diff_src_desc() == from.gradient.get_desc();
    const memory source_gradient = same ? from.gradient : scratch(by_source.diff_src_desc());
    calls.push_back({dnnl::convolution_backward_data(by_source),
                     {{DNNL_ARG_DIFF_DST, own_gradient},
                      {DNNL_ARG_WEIGHTS, own_weight},
                      {DNNL_ARG_DIFF_SRC, source_gradient}}});
    if (!same) copy(source_gradient, from.gradient, calls);
  }
  add_backward(std::move(calls));
  return to;
}

Value OnednnBackend::dense(const std::string& name, const Value& from, bool with_bias) {
  const Dims from_dims = dims_of(from.value.get_desc());
  const std::int64_t outputs = with_bias ? classes : WdcnnLayers::hidden;
  Dims weight_dims = from_dims;
  weight_dims[0] = outputs;
  const Dims to_dims{batch_, outputs};
  const memory::desc bias_desc = with_bias ? plain({outputs}) : memory::desc();
  const auto forward = describe<dnnl::inner_product_forward>(
      engine_, dnnl::prop_kind::forward_training, from.value.get_desc(), any(weight_dims),
      bias_desc, plain(to_dims));
  const Parameter weight = parameter(name + "/weight", forward.weights_desc());
  const Value to{scratch(plain(to_dims)), scratch(plain(to_dims))};
  Arguments arguments{
      {DNNL_ARG_SRC, from.value}, {DNNL_ARG_WEIGHTS, weight.value}, {DNNL_ARG_DST, to.value}};
  const auto by_weight = describe_backward<dnnl::inner_product_backward_weights>(
      engine_, forward, from.value.get_desc(), any(weight_dims), bias_desc, plain(to_dims));
  std::vector<Call> calls;
  const bool same = by_weight.diff_weights_desc() == forward.weights_desc();
  const memory weight_gradient = same ? weight.gradient : scratch(by_weight.diff_weights_desc());
  Arguments backward{{DNNL_ARG_SRC, from.value},
                     {DNNL_ARG_DIFF_DST, to.gradient},
                     {DNNL_ARG_DIFF_WEIGHTS, weight_gradient}};
  if (with_bias) {
    const Parameter bias = parameter(name + "/bias", bias_desc);
    arguments.emplace(DNNL_ARG_BIAS, bias.value);
    backward.emplace(DNNL_ARG_DIFF_BIAS, bias.gradient);
  }
  forward_.push_back({dnnl::inner_product_forward(forward), arguments});
  calls.push_back({dnnl::inner_product_backward_weights(by_weight), backward});
  if (!same) copy(weight_gradient, weight.gradient, calls);
  const auto by_source = describe_backward<dnnl::inner_product_backward_data>(
      engine_, forward, from.gradient.get_desc(), any(weight_dims), plain(to_dims));
  const memory own_weight = in_layout(weight.value, by_source.weights_desc(), calls);
  calls.push_back({dnnl::inner_product_backward_data(by_source),
                   {{DNNL_ARG_DIFF_DST, to.gradient},
                    {DNNL_ARG_WEIGHTS, own_weight},
                    {DNNL_ARG_DIFF_SRC, from.gradient}}});
  add_backward(std::move(calls));
  return to;
}

/// Copies [batch, channels, 1, 1] to [batch, channels], and the gradient back.
Value OnednnBackend::flatten(const Value& from) {
  const memory::desc flat = plain({batch_, dims_of(from.value.get_desc())[1]});
  const memory::desc four = plain(dims_of(from.value.get_desc()));
  const Value to{scratch(flat), scratch(flat)};
  copy(from.value, memory(four, engine_, to.value.get_data_handle()), forward_);
  std::vector<Call> calls;
  copy(memory(four, engine_, to.gradient.get_data_handle()), from.gradient, calls);
  add_backward(std::move(calls));
  return to;
}

Value OnednnBackend::normalise(const std::string& name, const Value& from) {
  const memory::desc layout = from.value.get_desc();
  const Dims channels{dims_of(layout)[1]};
  const auto forward = describe_normalisation(engine_, layout);
  const auto back = describe_normalisation_backward(engine_, forward, layout);
  const Parameter scale = parameter(name + "/scale", plain(channels));
  const Parameter shift = parameter(name + "/shift", plain(channels));
  const memory mean = scratch(plain(channels));
  const memory variance = scratch(plain(channels));
  const memory workspace = scratch(forward.workspace_desc());
  const Value to{scratch(layout), scratch(layout)};
  forward_.push_back({dnnl::batch_normalization_forward(forward),
                      {{DNNL_ARG_SRC, from.value},
                       {DNNL_ARG_DST, to.value},
                       {DNNL_ARG_MEAN, mean},
                       {DNNL_ARG_VARIANCE, variance},
                       {DNNL_ARG_SCALE, scale.value},
                       {DNNL_ARG_SHIFT, shift.value},
                       {DNNL_ARG_WORKSPACE, workspace}}});
  Arguments backward{{DNNL_ARG_SRC, from.value},
                     {DNNL_ARG_MEAN, mean},
                     {DNNL_ARG_VARIANCE, variance},
                     {DNNL_ARG_SCALE, scale.value},
                     {DNNL_ARG_DIFF_DST, to.gradient},
                     {DNNL_ARG_DIFF_SRC, from.gradient},
                     {DNNL_ARG_DIFF_SCALE, scale.gradient},
                     {DNNL_ARG_DIFF_SHIFT, shift.gradient},
                     {DNNL_ARG_WORKSPACE, workspace}};
  if (DNNL_VERSION_MAJOR < 3) backward.emplace(DNNL_ARG_SHIFT, shift.value);
  add_backward({{dnnl::batch_normalization_backward(back), backward}});
  return to;
}

Value OnednnBackend::pool(const Value& from) {
  const memory::desc layout = from.value.get_desc();
  Dims dims = dims_of(layout);
  dims[3] /= WdcnnLayers::pooling;
  const auto forward = describe_pooling(engine_, layout, any(dims));
  const memory workspace = scratch(forward.workspace_desc());
  const Value to{scratch(forward.dst_desc()), scratch(forward.dst_desc())};
  const auto back = describe_pooling_backward(engine_, forward, layout, forward.dst_desc());
  forward_.push_back(
      {dnnl::pooling_forward(forward),
       {{DNNL_ARG_SRC, from.value}, {DNNL_ARG_DST, to.value}, {DNNL_ARG_WORKSPACE, workspace}}});
  add_backward({{dnnl::pooling_backward(back),
                 {{DNNL_ARG_DIFF_DST, to.gradient},
                  {DNNL_ARG_DIFF_SRC, from.gradient},
                  {DNNL_ARG_WORKSPACE, workspace}}}});
  return to;
}

void OnednnBackend::build(const Stream& initial) {
  constexpr std::size_t enough = 1 << 20;  // WDCNN has 55,000 parameters
  values_.reserve(enough);
  gradients_.reserve(enough);
  initial_ = &initial;
  Value value{input_, memory()};
  for (std::size_t i = 0; i < WdcnnLayers::convolutions.size(); ++i) {
    value = pool(normalise(diagnosis::layer_name(i), convolve(i, value, i > 0)));
  }
  value = normalise("dense", dense("dense", flatten(value), /*with_bias=*/false));
  value = dense("classes", value, /*with_bias=*/true);
  logits_ = value.value;
  logits_gradient_ = value.gradient;
  adam_.emplace(values_.size());
  initial_ = nullptr;
}

diagnosis::BatchOutcome OnednnBackend::learn(std::span<const float* const> windows,
                                             std::span<const Label> labels) {
  auto* to = static_cast<float*>(input_.get_data_handle());
  for (const float* window : windows) to = std::copy_n(window, length, to);
  run(forward_);
  const diagnosis::BatchOutcome outcome = diagnosis::cross_entropy<float>(
      classes, classes, labels, static_cast<const float*>(logits_.get_data_handle()),
      static_cast<float*>(logits_gradient_.get_data_handle()));
  run(backward_);
  adam_->step(values_.data(), gradients_.data(), learning_rate_);
  return outcome;
}

}  // namespace

std::unique_ptr<diagnosis::WdcnnBackend> make_onednn_backend(diagnosis::LabelledWindows train,
                                                             const diagnosis::WdcnnOptions& options,
                                                             const Stream& initial) {
  return std::make_unique<OnednnBackend>(std::move(train), options, initial);
}

}  // namespace piae::bench
