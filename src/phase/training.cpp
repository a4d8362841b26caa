#include "phase/training.hpp"

#include <algorithm>
#include <optional>

#include "base/label.hpp"
#include "phase/alignment.hpp"
#include "phase/class_cycle.hpp"
#include "phase/inference_training.hpp"
#include "phase/states.hpp"
#include "signal/amplitude.hpp"
#include "twin/training.hpp"

namespace piae::phase {

namespace {

/// Cost of a decoder epoch per known window, in units of learning from one lesson of the inference
/// once. The value was measured; it only serves to estimate the remaining time.
constexpr double effort_of_a_window = 30;

/// The known windows, circularly shifted so that all of a class start at one angle, and their
/// original starts.
struct Aligned {
  signal::WindowSet windows;
  std::vector<std::int64_t> starts;  ///< in samples of the class's cycle
};

std::vector<double> without_mean(std::span<const float> window) {
  const double mean = signal::mean_of(window);
  std::vector<double> values;
  for (const float x : window) values.push_back(x - mean);
  return values;
}

Aligned shift_to_common_angle(const signal::WindowSet& known) {
  Aligned rotated{.windows = known, .starts = std::vector<std::int64_t>(known.size())};
  for (Label label = 0; index_of(label) < known.info.classes.size(); ++label) {
    const std::vector<std::size_t> indices = known.indices_of(label);
    if (indices.empty()) continue;
    const signal::Cycle cycle = cycle_of_class(known.info, label, known.length);
    std::vector<std::vector<double>> waveforms;
    waveforms.reserve(indices.size());
    for (const std::size_t i : indices) {
      waveforms.push_back(signal::closed_cycle(without_mean(known.window(i)), cycle));
    }
    const Alignment alignment = align(waveforms);
    for (std::size_t j = 0; j < indices.size(); ++j) {
      const std::size_t start = alignment.starts[j];
      const std::vector<double> window =
          signal::read(std::span<const double>(waveforms[j]), cycle.samples - start, known.length);
      std::copy(
          window.begin(), window.end(),
          rotated.windows.samples.begin() + static_cast<std::ptrdiff_t>(indices[j] * known.length));
      rotated.starts[indices[j]] = static_cast<std::int64_t>(start);
    }
  }
  return rotated;
}

class Training final : public PhaseTraining {
 public:
  Training(const signal::WindowSet& known, const PhaseOptions& options, const Stream& stream,
           twin::Engine engine)
      : known_(known),
        options_(options),
        stream_(stream),
        engine_(std::move(engine)),
        aligned_(shift_to_common_angle(known)),
        inference_(known, simulation_of(options), options.inference, stream.child("inference")) {}

  [[nodiscard]] std::size_t epochs() const override {
    return inference_.epochs() + static_cast<std::size_t>(options_.twin.epochs);
  }

  [[nodiscard]] double effort(std::size_t epoch) const override {
    if (epoch < inference_.epochs()) return inference_.effort(epoch);
    return effort_of_a_window * static_cast<double>(known_.size());
  }

  std::string run_epoch(std::size_t epoch) override {
    if (epoch < inference_.epochs()) return inference_.run_epoch(epoch);
    if (!twin_) make_twin();
    return twin_->run_epoch(epoch - inference_.epochs());
  }

  void write_state(artefact::Writer& writer) const override {
    inference_.write_state(writer);
    writer.attribute("/", "has_twin", std::int64_t{twin_ ? 1 : 0});
    if (twin_) twin_->write_state(writer);
  }

  void read_state(const artefact::Reader& reader) override {
    inference_.read_state(reader);
    if (reader.integer("/", "has_twin") == 0) return;
    make_twin();
    twin_->read_state(reader);
  }

  void write_model(artefact::Writer& writer) override {
    twin_->write_model(writer);
    inference_.inference().write(writer);
    writer.attribute("/inference", "width", std::int64_t{options_.inference.width});
    writer.numbers("/phase/labels", known_.labels);
    writer.attribute("/phase", "space_bins", std::int64_t{options_.twin.space_bins});
    writer.numbers("/phase/start", aligned_.starts);
  }

 private:
  static signal::SimulationOptions simulation_of(const PhaseOptions& options) {
    signal::SimulationOptions simulation;
    simulation.dynamics.mass_kg = options.twin.mass_kg;
    simulation.dynamics.load_n = options.twin.load_n;
    simulation.dynamics.clearance_um = options.twin.clearance_um;
    return simulation;
  }

  void make_twin() {
    const std::vector<twin::TwinPoint> points = inference_.inference().infer(known_);
    const StateScale scale(points, known_.labels, known_.info.classes.size());
    twin_ = twin::make_twin_training(
        aligned_.windows, options_.twin, twin::without_encoder, stream_.child("twin"), engine_,
        twin::KnownStates{.points = points,
                          .decoder_inputs = scale.standardised(points, known_.labels)});
  }

  signal::WindowSet known_;
  PhaseOptions options_;
  Stream stream_;
  twin::Engine engine_;
  Aligned aligned_;
  InferenceTraining inference_;
  std::unique_ptr<twin::TwinTraining> twin_;
};

}  // namespace

std::unique_ptr<PhaseTraining> make_phase_training(const signal::WindowSet& known,
                                                   const PhaseOptions& options,
                                                   const Stream& stream,
                                                   const twin::Engine& engine) {
  return std::make_unique<Training>(known, options, stream, engine);
}

}  // namespace piae::phase
