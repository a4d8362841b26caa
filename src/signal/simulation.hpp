#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

#include "bearing/dynamics.hpp"
#include "bearing/variation.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// A dataset that is simulated (pipeline/datasets/simulated.toml). Its description begins as every
/// other one (signal/description.hpp), with sample_rate_hz and without [[record]]. A table
/// [simulation] with all of the keys below marks it as a simulated dataset.
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
///     snr_db = 10                 # may be left out: no noise
///
///     [[simulation.condition]]    # may be left out. All records are made in each of these, and
///     name = "900 rpm"            # [transfer] may say what for (described_conditions.hpp)
///     shaft_speed_rpm = 900
struct Simulation {
  DatasetInfo info;
  std::int64_t seed = 0;
  std::size_t records_per_class = 0;  ///< in each condition
  std::size_t samples = 0;            ///< of a record
  bearing::DynamicsOptions dynamics;  ///< with the mean stiffness and damping
  bearing::Variation variation;       ///< from record to record

  /// How far, in dB, the measurement noise lies below the mean power of the faintest faulty class.
  /// The noise is white and the same for the whole dataset, as that of one sensor would be. So a
  /// stronger fault has a better ratio of signal to noise, and the record of a healthy bearing
  /// holds the noise and the little vibration that the passing of the balls causes.
  std::optional<double> snr_db;

  /// How many records there are in all.
  [[nodiscard]] std::size_t records() const;
};

/// Throws Error(bad_input) with file, line and key for unknown and missing keys, wrong types and
/// values that cannot be simulated; Error(input_missing) when there is no such file.
Simulation read_simulation(const std::filesystem::path& file);

/// Simulates all records, OpenMP parallel over them; the result does not depend on the number of
/// threads. Random numbers come from Stream("<name>/seed<k>/simulate/<class>/<record>"). A defect
/// of the outer race sits in the middle of the load zone; all other angles are drawn for each
/// record. `done` is told how many records are done. Throws Error(failed) when eq. 13 diverges.
Recordings simulate(const Simulation& simulation,
                    const std::function<void(std::size_t)>& done = nullptr);

/// The standard deviation of the noise that simulate() adds to each sample; 0 where snr_db is left
/// out. It follows from all records, so that it takes as long as simulate().
double measurement_noise(const Simulation& simulation);

}  // namespace piae::signal
