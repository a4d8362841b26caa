#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "bearing/variation.hpp"
#include "cli/options.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// The bearing of eq. 13, and what differs from window to window.
struct SimulationOptions {
  bearing::DynamicsOptions dynamics;
  bearing::Variation variation;
};

/// The options that every method on eq. 13 has: all but stiffness, damping and their spreads.
void bind(const cli::Options& command, SimulationOptions& options);

/// Check of an option that is a spread of bearing::Variation.
cli::Check spread();

/// What solving eq. 13 for windows like the known ones takes; the model of the methods that do.
struct WindowSimulation {
  DatasetInfo info;
  std::size_t length = 0;   ///< samples in a window
  std::vector<double> rms;  ///< for each class, of its known windows (rms_by_class)
  SimulationOptions options;
};

/// Throws Error(bad_input) when the windows of a class are constant.
WindowSimulation simulation_like(const WindowSet& known, const SimulationOptions& options);

/// Info, length and options as attributes of the root and of /simulation, and /classes/rms.
void write(artefact::Writer& writer, const WindowSimulation& simulation);
WindowSimulation read_window_simulation(const artefact::Reader& reader);

/// Gives a window of a class its stiffness and damping; the rest is that of the options.
using DrawDynamics = std::function<bearing::DynamicsOptions(std::size_t label, Stream& stream)>;

/// `count` windows of each class with a defect, class by class: eq. 13 with what `draw` gives, and
/// speed, slip and angles drawn by bearing::draw_motion. Each window is freed of its mean and
/// scaled to the class's RMS: the path from the bearing to the sensor, and so the amplitude, is not
/// modelled. Window i of a class draws from the stream's child "<class>/<i>". OpenMP parallel; the
/// result does not depend on the number of threads. Throws Error(failed) when eq. 13 diverges or a
/// window stays silent.
WindowSet simulate_windows(const WindowSimulation& simulation, std::size_t count,
                           const Stream& stream, const DrawDynamics& draw);

}  // namespace piae::signal
