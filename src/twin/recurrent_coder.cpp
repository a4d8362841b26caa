#include "twin/recurrent_coder.hpp"

#include "nets/gru_layer.hpp"
#include "nets/last_position.hpp"
#include "nets/position_dense.hpp"

namespace piae::twin {

namespace {

std::string gru_name(std::int64_t i) { return "gru" + std::to_string(i); }

}  // namespace

RecurrentCoder::RecurrentCoder(const NetworkShape& shape, const TwinOptions& options)
    : shape_(shape),
      layers_(layers_except_dense(options.depth, "recurrent layer")),
      frames_(frames_of(shape.samples, frame, "read in turn")) {}

std::vector<nets::ParameterSpec> RecurrentCoder::specs() const {
  std::vector<nets::ParameterSpec> specs;
  const auto add = [&](const std::string& network, std::int64_t inputs, std::int64_t outputs) {
    for (std::int64_t i = 0; i < layers_; ++i) {
      append(specs, nets::gru_specs(network + "/" + gru_name(i), i == 0 ? inputs : units, units));
    }
    append(specs, nets::dense_specs(network + "/dense", units, outputs));
  };
  add(encoder_name, frame, 2);
  add(decoder_name, 2 + shape_.classes, frame);
  return specs;
}

template <class T>
Layers<T> RecurrentCoder::gru_layers(nets::GradientArray<T>& parameters,
                                     std::int64_t input_length) const {
  Layers<T> layers;
  for (std::int64_t i = 0; i < layers_; ++i) {
    layers.push_back(std::make_unique<nets::GruLayer<T>>(parameters, gru_name(i),
                                                         i == 0 ? input_length : frames_, frames_));
  }
  return layers;
}

template <class T>
Layers<T> RecurrentCoder::encoder_layers(nets::GradientArray<T>& parameters) const {
  Layers<T> layers = gru_layers(parameters, frames_);
  layers.push_back(std::make_unique<nets::LastPosition<T>>(
      nets::SequenceShape{.length = frames_, .width = units}));
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "dense", 1));
  return layers;
}

template <class T>
Layers<T> RecurrentCoder::decoder_layers(nets::GradientArray<T>& parameters) const {
  Layers<T> layers = gru_layers(parameters, 1);
  layers.push_back(std::make_unique<nets::PositionDense<T>>(parameters, "dense", frames_));
  return layers;
}

PIAE_INSTANTIATE_SEQUENCE_CODER(RecurrentCoder);

}  // namespace piae::twin
