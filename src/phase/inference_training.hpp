#pragma once

#include <string>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "nets/trainee.hpp"
#include "phase/inference.hpp"
#include "phase/inference_options.hpp"
#include "signal/window_set.hpp"
#include "signal/window_simulation.hpp"

namespace piae::phase {

/// Trains an Inference on windows that solve eq. 13 for random (k, c), start angles, speeds and
/// slips, with white measurement noise of random strength. There are two rounds. The first draws
/// (k, c) from the full range of the options. The second, which has more windows, draws it only
/// from the neighbourhood of what the first round infers from the known windows of each class
/// (truncated sequential estimation, Deistler, Goncalves and Macke 2022).
class InferenceTraining final : public nets::Trainee {
 public:
  /// Throws Error(usage) if the options leave nothing between the bounds, and Error(bad_input) if
  /// known windows of a class are constant.
  InferenceTraining(const signal::WindowSet& known, const signal::SimulationOptions& simulation,
                    const InferenceOptions& options, const Stream& stream);

  [[nodiscard]] std::size_t epochs() const override;
  /// Returns the cost of one epoch, in units of learning from one lesson once. The first epoch of a
  /// round costs most, because it makes the lessons.
  [[nodiscard]] double effort(std::size_t epoch) const override;
  /// Throws Error(failed) if the loss is not finite.
  std::string run_epoch(std::size_t epoch) override;
  void write_state(artefact::Writer& writer) const override;
  void read_state(const artefact::Reader& reader) override;

  [[nodiscard]] const Inference& inference() const { return inference_; }
  [[nodiscard]] Inference& inference() { return inference_; }

 private:
  /// The simulated windows of a round, as features with noise.
  struct Lessons {
    std::vector<nets::RowArray<float>> features;  ///< one array per noise realisation
    std::vector<Label> labels;
    std::vector<twin::TwinPoint> points;
  };

  [[nodiscard]] std::size_t lessons_of_a_class(std::size_t round) const;
  void prepare_lessons(std::size_t round, const std::vector<Bounds>& bounds);
  /// Learns from every lesson once, in batches; returns the mean squared error of the standardised
  /// logarithms.
  double learn(const nets::RowArray<float>& features, Stream& shuffle, double learning_rate);
  [[nodiscard]] Bounds first_bounds() const;
  [[nodiscard]] std::vector<Bounds> bounds_around_known();

  signal::WindowSet known_;
  signal::WindowSimulation simulation_;
  InferenceOptions options_;
  Stream stream_;
  Inference inference_;
  Lessons lessons_;
};

}  // namespace piae::phase
