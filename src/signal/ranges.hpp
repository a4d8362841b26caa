#pragma once

#include <numbers>
#include <string>

#include "base/range.hpp"

/// Permitted numbers and names of data sets, windows and simulations, in descriptions and in
/// artefacts. bearing::validate() checks a bearing's dimensions against each other.
namespace piae::signal::ranges {

inline constexpr Range sample_rate_hz{.low = 1, .high = 1e7, .unit = " Hz"};
/// Sample rate in a description. `ingest --check` warns of a rate in kHz or with three extra zeros.
inline constexpr Range described_rate_hz{.low = 1e-3, .high = 1e10, .unit = " Hz"};
inline constexpr Range shaft_speed_rpm{.low = 1e-2, .high = 1e6, .unit = " rpm"};
/// Pulses of a tachometer, or of an encoder.
inline constexpr Range pulses_per_turn{.low = 1e-2, .high = 1e5};
/// Length of the blocks of a speed over time: 20 ms, or a sample.
inline constexpr Range speed_block_s{.low = 0.02, .high = 1, .unit = " s"};
/// Range about a given speed in which it is taken from the signal (spectra/shaft_speed.hpp).
inline constexpr Range speed_search_percent{.low = 0, .high = 10, .unit = " %"};
/// Time between the starts of two snapshots: up to a year.
inline constexpr Range snapshot_interval_s{.low = 1e-3, .high = 3.2e7, .unit = " s"};
inline constexpr Range fault_order{.low = 1e-3, .high = 1e3};
inline constexpr Range unit_m_per_s2{.low = 1e-9, .high = 1e9, .unit = " m/s^2"};
/// A sample. Its square is still far below the limit of a double.
inline constexpr Range acceleration{.low = -1e30, .high = 1e30};
/// RMS or peak of a class's windows.
inline constexpr Range amplitude{.low = 1e-30, .high = 1e30};

/// Classes of a data set. Training and verification take time for each.
inline constexpr Range classes{.low = 1, .high = 1000};
inline constexpr Range balls{.low = 3, .high = 1000};
inline constexpr Range length_mm{.low = 1e-3, .high = 1e5, .unit = " mm"};
inline constexpr Range contact_angle_deg{.low = 0, .high = 89.999, .unit = " degrees"};
inline constexpr Range defect_size_mm{.low = 0, .high = 1e5, .unit = " mm"};

inline constexpr Range seed{.low = 0, .high = 9.3e18};
inline constexpr Range window_samples{.low = 1, .high = 1 << 20, .unit = " samples"};
inline constexpr Range first_sample{.low = 0, .high = 1e12};
/// Angle between two impacts: a full turn is 2 pi.
inline constexpr Range start_angle_rad{.low = 0, .high = 2 * std::numbers::pi, .unit = " rad"};
/// Parameters of eq. 13.
inline constexpr Range mass_kg{.low = 1e-6, .high = 1e9, .unit = " kg"};
inline constexpr Range nominal_stiffness_n_per_m{.low = 1e-3, .high = 1e15, .unit = " N/m"};
inline constexpr Range nominal_damping_ns_per_m{.low = 1e-6, .high = 1e12, .unit = " N s/m"};
inline constexpr Range clearance_um{.low = 1e-6, .high = 1e6, .unit = " micrometres"};
inline constexpr Range load_n{.low = 1e-6, .high = 1e12, .unit = " N"};
inline constexpr Range spread{.low = 0, .high = 0.3333};
inline constexpr Range slip{.low = 0, .high = 0.9999};
inline constexpr Range snr_db{.low = -200, .high = 200, .unit = " dB"};

/// Inferred or drawn (k, c). A network may infer a stiffness of 0.
inline constexpr Range stiffness_n_per_m{.low = 0, .high = 1e30, .unit = " N/m"};
inline constexpr Range damping_ns_per_m{.low = 0, .high = 1e30, .unit = " N s/m"};

/// True for a valid name. Names become folders, HDF5 paths, CSV columns and words of messages, so
/// they hold at most 100 letters, digits, '-', '_' and '.', and do not start with '.'.
bool is_plain_name(const std::string& name);
inline const std::string plain_name_rule =
    "may hold letters, digits, '-', '_' and '.' only, at most 100, and not begin with '.'";

}  // namespace piae::signal::ranges
