#include "augment/physics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/label.hpp"
#include "base/parallel.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"

namespace piae::augment {

namespace {

using twin::damping_scale_ns_per_m;
using twin::stiffness_scale_n_per_m;

/// Fits all known windows. Each epoch fits the windows of one fault class.
class Fitting final : public nets::Trainee {
 public:
  Fitting(const signal::WindowSet& known, const signal::WindowSimulation& simulation,
          const FitOptions& options)
      : known_(known), simulation_(simulation), options_(options) {
    for (Label label = 0; index_of(label) < known.info.classes.size(); ++label) {
      if (known.info.classes[index_of(label)].defect != signal::Defect::none) {
        labels_.push_back(label);
      }
    }
  }

  [[nodiscard]] std::size_t epochs() const override { return labels_.size(); }

  std::string run_epoch(std::size_t epoch) override {
    const Label label = labels_[epoch];
    const SpectralFit spectral_fit(simulation_, label, options_);
    const std::vector<std::size_t> windows = known_.indices_of(label);
    std::vector<twin::TwinPoint> fitted(windows.size());
    parallel_for_parts(
        1, windows.size(), bearing::courses_at_once, [&](std::size_t first, std::size_t count) {
          std::vector<SpectralFit::Window> some;
          for (std::size_t i = 0; i < count; ++i) {
            some.push_back(known_.window(windows[first + i]));
          }
          std::ranges::transform(spectral_fit.fit(some),
                                 fitted.begin() + static_cast<std::ptrdiff_t>(first),
                                 [](const auto& p) { return twin::without_units(p); });
        });
    points_.insert(points_.end(), fitted.begin(), fitted.end());
    return known_.info.classes[index_of(label)].name;
  }

  void write_state(artefact::Writer& writer) const override {
    twin::write_points(writer, "/points", points_);
  }

  void read_state(const artefact::Reader& reader) override {
    points_ = twin::read_points(reader, "/points");
  }

  [[nodiscard]] const std::vector<twin::TwinPoint>& points() const { return points_; }

 private:
  signal::WindowSet known_;
  signal::WindowSimulation simulation_;
  FitOptions options_;
  std::vector<Label> labels_;            // fault classes
  std::vector<twin::TwinPoint> points_;  // fitted so far
};

}  // namespace

void bind(const cli::Options& command, PhysicsOptions& options) {
  bind(command, options.simulation);
  bind(command, options.fit);
  command
      .add("--space-bins", options.space_bins, "bins of the digital twin space along k and along c")
      .check(cli::whole_number(1, 1000));
}

void Physics::bind(const cli::Options& command) { augment::bind(command, options_); }

void Physics::train(const signal::WindowSet& known, const Stream& /*stream*/,
                    const Compute& /*compute*/, const nets::Checkpoint& checkpoint,
                    artefact::Writer& model) {
  const signal::WindowSimulation simulation = signal::simulation_like(known, options_.simulation);
  Fitting fitting(known, simulation, options_.fit);
  nets::run_epochs(fitting, checkpoint);
  write(model, simulation);
  twin::TwinSpace(fitting.points(), options_.space_bins).write(model);
}

signal::WindowSet Physics::generate(const artefact::Reader& model, std::size_t count,
                                    const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSimulation simulation = signal::read_window_simulation(model);
  const twin::TwinSpace space(model);
  return signal::simulate_windows(simulation, count, stream, [&](Label /*label*/, Stream& random) {
    const twin::TwinPoint point = space.sample(random);
    bearing::DynamicsOptions dynamics = simulation.options.dynamics;
    dynamics.stiffness_n_per_m = point.k * stiffness_scale_n_per_m;
    dynamics.damping_ns_per_m = point.c * damping_scale_ns_per_m;
    return dynamics;
  });
}

}  // namespace piae::augment
