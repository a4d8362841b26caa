#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "nets/gradient_array.hpp"
#include "nets/sequence_chain.hpp"
#include "nets/sequence_network.hpp"
#include "twin/coder.hpp"
#include "twin/specs.hpp"

namespace piae::twin {

/// Layers of a network on sequences.
template <class T>
using Layers = typename nets::SequenceChain<T>::Layers;

/// A coder whose networks are chains of layers on sequences. `Own` derives from SequenceCoder<Own>
/// and has encoder_layers<T>(parameters) and decoder_layers<T>(parameters), for float and double.
/// They name parameters relative to their network.
template <class Own>
class SequenceCoder : public Coder {
 public:
  [[nodiscard]] std::unique_ptr<Network> encoder(const std::shared_ptr<Parameters>& parameters,
                                                 std::int64_t most_rows) const override {
    return make_encoder<float>(parameters, most_rows);
  }
  [[nodiscard]] std::unique_ptr<Network> decoder(const std::shared_ptr<Parameters>& parameters,
                                                 std::int64_t most_rows) const override {
    return make_decoder<float>(parameters, most_rows);
  }

  /// encoder() and decoder() in float and in double.
  template <class T>
  [[nodiscard]] std::unique_ptr<nets::Network<T>> make_encoder(
      const std::shared_ptr<nets::Parameters<T>>& all, std::int64_t most_rows) const {
    auto parameters = std::make_unique<nets::GradientArray<T>>(all, encoder_name);
    auto layers = own().template encoder_layers<T>(*parameters);
    return network_of<T>(std::move(parameters), std::move(layers), most_rows);
  }
  template <class T>
  [[nodiscard]] std::unique_ptr<nets::Network<T>> make_decoder(
      const std::shared_ptr<nets::Parameters<T>>& all, std::int64_t most_rows) const {
    auto parameters = std::make_unique<nets::GradientArray<T>>(all, decoder_name);
    auto layers = own().template decoder_layers<T>(*parameters);
    return network_of<T>(std::move(parameters), std::move(layers), most_rows);
  }

 private:
  [[nodiscard]] const Own& own() const { return static_cast<const Own&>(*this); }

  template <class T>
  static std::unique_ptr<nets::Network<T>> network_of(
      std::unique_ptr<nets::GradientArray<T>> parameters, Layers<T> layers,
      std::int64_t most_rows) {
    return std::make_unique<nets::SequenceNetwork<T>>(
        std::move(parameters), std::make_unique<nets::SequenceChain<T>>(std::move(layers)),
        most_rows);
  }
};

/// Returns `depth` minus the dense layer at (k, c). Throws Error(usage) if nothing is left;
/// `layers` names the layers in the message: "recurrent layer".
std::int64_t layers_except_dense(int depth, const std::string& layers);

/// Returns the number of frames of `frame` samples in a window. Throws Error(usage) if it is not
/// whole; `handled` describes the use of frames in the message: "read in turn".
std::int64_t frames_of(std::int64_t samples, std::int64_t frame, const std::string& handled);

// Each coder instantiates its layers in its own file.
#define PIAE_INSTANTIATE_SEQUENCE_CODER(Own)                                       \
  template Layers<float> Own::encoder_layers(nets::GradientArray<float>&) const;   \
  template Layers<double> Own::encoder_layers(nets::GradientArray<double>&) const; \
  template Layers<float> Own::decoder_layers(nets::GradientArray<float>&) const;   \
  template Layers<double> Own::decoder_layers(nets::GradientArray<double>&) const

}  // namespace piae::twin
