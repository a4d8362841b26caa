#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/band_powers.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/episodes.hpp"
#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"

namespace piae::diagnosis {

/// Settings of the classifier prototypes.
struct PrototypeTraining {
  static constexpr std::int64_t epochs = 50;
  static constexpr std::int64_t episodes = 20;   ///< of an epoch; each takes one step of Adam
  static constexpr EpisodeSize size = {};        ///< windows of a class in an episode
  static constexpr double learning_rate = 1e-3;  ///< of Adam (Snell et al. 2017)
  static constexpr std::int64_t hidden = 64;     ///< units of the hidden layer
  static constexpr std::int64_t embedding = 32;  ///< numbers of an embedding
};

/// A prototypical network (Snell, Swersky and Zemel 2017), made for classes with few windows: a
/// dense layer of 64 with ReLU and one of 32 embed a window, and the nearest prototype, a mean
/// embedding of a class, predicts it. The input is that of nearest-orders: so the difference
/// between both is the learned distance, and 224 inputs keep a training below a second. With
/// band_powers() alone the mean accuracy on HIT-SM's pairs of speeds is 57 instead of 72 % (seeds
/// 100 to 104, none).
class Prototypes final : public Trained {
 public:
  /// Makes an untrained network, for windows of `length` samples. Initial values come from the
  /// stream.
  Prototypes(std::int64_t classes, std::size_t length, const Stream& initial);
  Prototypes(const artefact::Reader& reader, const signal::DatasetInfo& info, std::size_t length);

  /// Trains by episodes and sets the prototypes to the mean embeddings of all training windows.
  /// Episodes of epoch e, counted from 1, come from stream.child("epoch<e>"). Throws
  /// Error(bad_input) if a class has no window or none has two, and as order_features() does.
  Training train(const signal::WindowSet& training, const Stream& stream,
                 const EpochDone& epoch_done);

  /// Hidden units are the embedding, logits minus the squared distances to the prototypes.
  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override;

  /// Writes /learned/embedding/0/weight and so on, and /learned/prototypes float64 [classes, 32].
  void write(artefact::Writer& writer) const override;

 private:
  /// Runs the network on the chosen rows.
  Embeddings embed(const FeatureRows& rows);
  void run_epoch(const FeatureRows& rows, const std::vector<std::vector<std::size_t>>& windows_of,
                 Stream random, Training& training);

  std::int64_t classes_;
  std::size_t length_;
  std::int64_t most_rows_;
  std::shared_ptr<nets::Parameters<float>> parameters_;
  nets::DenseChain<float> network_;
  std::int64_t steps_ = 0;
  Embeddings prototypes_;  ///< [classes, 32]
};

/// Trains a network on all windows of `training`. Initial values come from
/// stream.child("initial").
Learned train_prototypes(const signal::WindowSet& normal, const signal::WindowSet& training,
                         double prewhitening, const Stream& stream,
                         const EpochDone& epoch_done = {});
std::unique_ptr<Trained> read_prototypes(const artefact::Reader& reader,
                                         const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier prototypes{
    .name = "prototypes",
    .what = "the nearest mean of a class, in an embedding learned by episodes",
    .input = "the log power in 128 bands, and that of the envelope at 96 shaft orders",
    .learn = train_prototypes,
    .read = read_prototypes,
    .own_epochs = PrototypeTraining::epochs};

}  // namespace piae::diagnosis
