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

/// Parameters of eq. 13, and their variation between windows.
struct SimulationOptions {
  bearing::DynamicsOptions dynamics;
  bearing::Variation variation;
};

/// Binds the options common to all methods on eq. 13: all but stiffness, damping and their spreads.
void bind(const cli::Options& command, SimulationOptions& options);

/// Returns the check for an option that is a spread of bearing::Variation.
cli::Check spread();

/// Parameters to solve eq. 13 for windows like the known ones. Methods on eq. 13 store it as their
/// model.
struct WindowSimulation {
  DatasetInfo info;
  std::size_t length = 0;   ///< samples in a window
  std::vector<double> rms;  ///< of each class's known windows (rms_by_class)
  SimulationOptions options;
  /// Conditions of the windows, in turn: the known ones to learn from eq. 13, the tested ones to
  /// generate. Not stored, because `info` holds both.
  std::vector<std::int32_t> conditions{every_condition};
};

/// Returns the simulation in the known conditions. Throws Error(bad_input) if the windows of a
/// class are constant, or if one window of each class needs too many steps of eq. 13.
WindowSimulation simulation_like(const WindowSet& known, const SimulationOptions& options);

/// Writes info, length and options as attributes of the root and of /simulation, and the RMS as
/// /classes/rms.
void write(artefact::Writer& writer, const WindowSimulation& simulation);
/// Reads the simulation, in the tested conditions.
WindowSimulation read_window_simulation(const artefact::Reader& reader);

/// Draws stiffness and damping of one window of a class, and returns them with the other parameters
/// of eq. 13.
using DrawDynamics = std::function<bearing::DynamicsOptions(Label label, Stream& stream)>;

/// Makes `count` windows of each class with a defect, class by class. Solves eq. 13 for each window
/// with the values of `draw`, the speed of its condition, and slip and angles from
/// bearing::draw_motion. Removes the mean and scales to the RMS of the class, because the path from
/// bearing to sensor is not modelled and eq. 13 does not give the amplitude. Window i of a class
/// draws from the stream's child "<class>/<i>". OpenMP parallel; the result does not depend on the
/// number of threads. Throws Error(failed) if eq. 13 diverges or gives a window without vibration.
WindowSet simulate_windows(const WindowSimulation& simulation, std::size_t count,
                           const Stream& stream, const DrawDynamics& draw);

}  // namespace piae::signal
