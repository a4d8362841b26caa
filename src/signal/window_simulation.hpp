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

/// The bearing of eq. 13, and how much it varies from window to window.
struct SimulationOptions {
  bearing::DynamicsOptions dynamics;
  bearing::Variation variation;
};

/// The options that every method on eq. 13 has: all but stiffness, damping and their spreads.
void bind(const cli::Options& command, SimulationOptions& options);

/// The check for an option that is a spread of bearing::Variation.
cli::Check spread();

/// All that is needed to solve eq. 13 for windows like the known ones. This is the model that the
/// methods on eq. 13 store.
struct WindowSimulation {
  DatasetInfo info;
  std::size_t length = 0;   ///< samples in a window
  std::vector<double> rms;  ///< for each class, of its known windows (rms_by_class)
  SimulationOptions options;
  /// In which conditions windows are made, in turn: in the known ones by who learns from what eq.
  /// 13 gives, in the tested ones by who generates. Not stored, as the info says both.
  std::vector<std::int32_t> conditions{every_condition};
};

/// That of the known conditions. Throws Error(bad_input) when the windows of a class are constant,
/// and where a window of each class would take eq. 13 a time without end.
WindowSimulation simulation_like(const WindowSet& known, const SimulationOptions& options);

/// Writes info, length and options as attributes of the root and of /simulation, and the RMS as
/// /classes/rms.
void write(artefact::Writer& writer, const WindowSimulation& simulation);
/// That of the tested conditions.
WindowSimulation read_window_simulation(const artefact::Reader& reader);

/// Draws the stiffness and the damping of one window of a class, and returns them with the other
/// numbers of eq. 13, which are those of the options.
using DrawDynamics = std::function<bearing::DynamicsOptions(Label label, Stream& stream)>;

/// Makes `count` windows of each class with a defect, class by class. For each window eq. 13 is
/// solved with what `draw` gives, and with the speed of its condition, slip and angles from
/// bearing::draw_motion. Then
/// its mean is removed, and it is scaled to the RMS of the class: the path from the bearing to the
/// sensor is not modelled, so eq. 13 says nothing of the amplitude. Window i of a class draws from
/// the stream's child "<class>/<i>". OpenMP parallel; the result does not depend on the number of
/// threads. Throws Error(failed) when eq. 13 diverges or gives a window without any vibration.
WindowSet simulate_windows(const WindowSimulation& simulation, std::size_t count,
                           const Stream& stream, const DrawDynamics& draw);

}  // namespace piae::signal
