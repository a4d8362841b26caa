#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

#include "bearing/dynamics.hpp"
#include "bearing/variation.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// A simulated data set (pipeline/datasets/simulated.toml). Its description begins like all others
/// (signal/description.hpp), with sample_rate_hz and without [[record]]. A table [simulation] with
/// the keys below marks a simulated data set.
///
///     [simulation]
///     seed = 0                    # another seed, another realisation
///     records_per_class = 40      # "IR007-01" ... "IR007-40"
///     record_s = 0.7              # length of each
///     mass_kg = 1.0               # eq. 13; bearing::DynamicsOptions
///     stiffness_n_per_m = 1e8     # mean over the records
///     stiffness_spread = 0.1      # standard deviation / mean
///     damping_ns_per_m = 500
///     damping_spread = 0.2
///     clearance_um = 2
///     load_n = 1000
///     slip_max = 0.01             # loss of cage and spin speed: uniform from 0 to this
///     speed_spread = 0.001        # standard deviation of the shaft speed / its mean
///     snr_db = 10                 # optional; default: no noise
///
///     [[simulation.condition]]    # optional. All records are simulated in each condition;
///     name = "900 rpm"            # [transfer] may set its use (described_conditions.hpp)
///     shaft_speed_rpm = 900
struct Simulation {
  DatasetInfo info;
  std::int64_t seed = 0;
  std::size_t records_per_class = 0;  ///< in each condition
  std::size_t samples = 0;            ///< of a record
  bearing::DynamicsOptions dynamics;  ///< with the mean stiffness and damping
  bearing::Variation variation;       ///< from record to record

  /// Measurement noise, in dB below the mean power of the weakest faulty class. The noise is white
  /// and the same for the whole dataset, like a single sensor's. So a stronger fault has a better
  /// signal-to-noise ratio. A healthy record holds the noise and the weak vibration of passing
  /// balls.
  std::optional<double> snr_db;

  /// Returns the number of all records.
  [[nodiscard]] std::size_t records() const;
};

/// Reads a simulation. Throws Error(bad_input) with file, line and key for unknown and missing
/// keys, wrong types and values that cannot be simulated; Error(input_missing) if the file is
/// missing.
Simulation read_simulation(const std::filesystem::path& file);

/// Simulates all records, OpenMP parallel over them. The result does not depend on the number of
/// threads. Random numbers come from Stream("<name>/seed<k>/simulate/<class>/<record>"). A defect
/// of the outer race sits in the middle of the load zone; other angles are drawn for each record.
/// Calls `done` with the number of finished records. Throws Error(failed) if eq. 13 diverges.
Recordings simulate(const Simulation& simulation,
                    const std::function<void(std::size_t)>& done = nullptr);

/// Returns the standard deviation of the noise that simulate() adds; 0 without snr_db. It depends
/// on all records, so computing it takes as long as simulate().
double measurement_noise(const Simulation& simulation);

}  // namespace piae::signal
