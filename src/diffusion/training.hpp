#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diffusion/backend.hpp"
#include "diffusion/model.hpp"
#include "diffusion/options.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"

namespace piae::diffusion {

/// The start of a known window in a step of the training.
enum class Angle {
  known,  ///< as recorded
  drawn   ///< the window's fault cycle, read from a random start (phase/class_cycle.hpp)
};

/// Windows that a network learns from, and how long.
struct Lesson {
  std::vector<float> windows;  ///< [n, N], each without its mean, in units of its class's RMS
  std::vector<Label> labels;   ///< [n]
  /// [n] each window as a cycle that is read from a random start; empty if they start as recorded.
  std::vector<std::vector<float>> cycles;
  Course course;
};

/// Returns the lesson of a set of windows. Throws Error(bad_input) for a silent class, and with
/// Angle::drawn for a fault whose cycle does not fit into a window.
Lesson lesson_of(const signal::WindowSet& windows, const std::vector<double>& rms, Angle angle,
                 const Course& course);

/// Trains the networks of a model, one after the other, each in its lesson: to estimate the
/// velocity at random points of the path. The places u of a batch are stratified. Everything that
/// epoch i draws comes from the stream's child "epoch<i>".
class DiffusionTraining final : public nets::Trainee {
 public:
  using MakeBackend = std::function<std::unique_ptr<DiffusionBackend>(
      const Networks& networks, std::int64_t most_windows, const Stream& initial)>;

  /// Takes a lesson for each network of the model.
  DiffusionTraining(DiffusionModel model, std::vector<Lesson> lessons, double dropped,
                    const Stream& stream, const MakeBackend& make_backend);

  [[nodiscard]] std::size_t epochs() const override;
  [[nodiscard]] double effort(std::size_t epoch) const override;
  /// Throws Error(failed) if the loss, or a parameter after the last epoch, is not finite.
  std::string run_epoch(std::size_t epoch) override;
  void write_state(artefact::Writer& writer) const override;
  void read_state(const artefact::Reader& reader) override;

  /// Writes the model after the last epoch, with the whole state of the training and
  /// /curves/squared_error.
  void write_model(artefact::Writer& writer) const;

 private:
  /// An epoch of the whole training: which network, and which of its epochs.
  struct Place {
    std::size_t network;
    std::size_t epoch;
  };
  struct Drawn {
    NoisyBatch noisy;
    std::vector<float> velocities;  ///< [n, N]
  };
  [[nodiscard]] Place place_of(std::size_t epoch) const;
  [[nodiscard]] Drawn draw(const Lesson& lesson, std::span<const std::size_t> windows,
                           Stream& random) const;
  [[nodiscard]] std::vector<float> window_of(const Lesson& lesson, std::size_t i,
                                             Stream& random) const;

  DiffusionModel model_;
  std::vector<Lesson> lessons_;
  double dropped_;
  Stream stream_;
  std::unique_ptr<DiffusionBackend> backend_;
  std::vector<double> squared_errors_;  ///< mean over the steps of each epoch
};

}  // namespace piae::diffusion
