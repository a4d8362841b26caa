#pragma once

#include <string>
#include <vector>

#include "base/random.hpp"
#include "nets/trainee.hpp"
#include "phase/inference.hpp"
#include "phase/inference_options.hpp"
#include "signal/window_set.hpp"
#include "signal/window_simulation.hpp"

namespace piae::phase {

/// Teaches an Inference by windows that eq. 13 gives for drawn (k, c), start angles, speeds and
/// slips, with white measurement noise of drawn strength. Two rounds: the first looks everywhere
/// between the options' bounds; the second, with more windows, only around what the first infers
/// of the known windows of each class (truncated sequential estimation, Deistler, Goncalves and
/// Macke 2022).
class InferenceTraining final : public nets::Trainee {
 public:
  InferenceTraining(const signal::WindowSet& known, const signal::SimulationOptions& simulation,
                    const InferenceOptions& options, const Stream& stream);

  [[nodiscard]] std::size_t epochs() const override;
  std::string run_epoch(std::size_t epoch) override;
  void write_state(artefact::Writer& writer) const override;
  void read_state(const artefact::Reader& reader) override;

  [[nodiscard]] const Inference& inference() const { return inference_; }

 private:
  /// Simulated windows with noise, as features; a few realisations of the noise take turns.
  struct Lessons {
    std::vector<nets::RowArray<float>> features;
    std::vector<std::int32_t> labels;
    std::vector<twin::TwinPoint> points;
  };

  void prepare_lessons(std::size_t round, const std::vector<Bounds>& bounds);
  /// One pass; returns the mean squared error of the standardised logarithms.
  double learn(const nets::RowArray<float>& features, Stream& shuffle, double learning_rate);
  [[nodiscard]] Bounds first_bounds() const;
  [[nodiscard]] std::vector<Bounds> bounds_around_known() const;

  const signal::WindowSet& known_;
  signal::WindowSimulation simulation_;
  InferenceOptions options_;
  Stream stream_;
  Inference inference_;
  Lessons lessons_;
};

}  // namespace piae::phase
