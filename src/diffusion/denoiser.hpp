#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "nets/network.hpp"
#include "nets/parameters.hpp"

namespace piae::diffusion {

/// Size of a denoiser.
struct DenoiserSize {
  int channels = 0;  ///< a multiple of 16
  int blocks = 0;    ///< residual blocks
};

/// A network that estimates the velocity of a noisy window (path.hpp). It reads the window as
/// frames of 16 samples, each followed by features of u and the one-hot class; zeros mean that the
/// class is not told. A dense layer turns frames into channels, residual blocks of two dilated
/// convolutions follow (van den Oord et al. 2016; Kong et al. 2021 for diffusion), and a dense
/// layer turns channels into frames.
struct Denoiser {
  std::string name;          ///< of its parameters: "net/denoiser"
  std::int64_t samples = 0;  ///< N, whole frames
  std::int64_t classes = 0;  ///< 0: of healthy windows alone, so no class is an input
  DenoiserSize size;

  static constexpr std::int64_t frame = 16;
  static constexpr std::int64_t kernel = 3;
  static constexpr std::int64_t features =
      8;  ///< of u: sin and cos of pi u / 2, pi u, 2 pi u, 4 pi u

  [[nodiscard]] std::int64_t positions() const { return samples / frame; }
  /// Returns the numbers of a frame in the input, without padding.
  [[nodiscard]] std::int64_t inputs() const { return frame + features + classes; }
  /// Returns the dilation of a block: 1, 2, 4, 8, 16, 32, 1, ...
  static std::int64_t dilation(std::int64_t block);
};

/// Throws Error(bad_input) if windows of this length are not whole frames.
void require_whole_frames(std::size_t samples);

/// Returns the features of u.
std::array<double, Denoiser::features> features_of(double u);

/// Returns <name>/frames, <name>/block<i>/conv0, <name>/block<i>/conv1 and <name>/velocity.
std::vector<nets::ParameterSpec> denoiser_specs(const Denoiser& denoiser);

/// Makes the network for batches of up to `most_rows` windows. Its output row is a window [N]. A
/// row of its input has padding: fill_input() fills it.
template <class T>
std::unique_ptr<nets::Network<T>> make_network(const Denoiser& denoiser,
                                               const std::shared_ptr<nets::Parameters<T>>& all,
                                               std::int64_t most_rows);

/// Fills a row of the network's input: window [N], u, and the class if one is given and an input.
template <class T>
void fill_input(const Denoiser& denoiser, const float* window, double u, std::optional<Label> label,
                T* row);

}  // namespace piae::diffusion
