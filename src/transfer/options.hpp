#pragma once

#include "impacts/path.hpp"
#include "transfer/edge_fit.hpp"
#include "transfer/healthy.hpp"
#include "transfer/strengths.hpp"

namespace piae::transfer {

/// Selects whether a property of a window is set to the tested condition or left as known.
enum class Set { tested, known };

/// Response of the machine to an impact: its known spectrum with minimum phase; eq. 13's resonance
/// (impacts/resonance.hpp); or cut from the known windows.
enum class Response { minimum_phase, ring, cut };

/// Colour of the background: the spectrum of the known windows, or of healthy windows of the tested
/// condition.
enum class BackgroundFrom { struck, healthy };

/// Options that carry windows to the tested condition.
struct CarryOptions {
  Response response = Response::minimum_phase;
  Set edges = Set::tested;    ///< lag between both edges of the defect
  Set rate_of = Set::tested;  ///< time between impacts
  StrengthOptions strengths;
  double own_structure = 1;  ///< least part kept of a bearing's deviation from the mean structure
  double background = 0;     ///< largest fraction of the power that impacts do not excite
  BackgroundFrom background_from = BackgroundFrom::struck;
  double dispersion_ms = 0;  ///< standard deviation of the random path's group delay
  double jitter = 0;         ///< standard deviation of an impact's time / period
  double lag_deviation = 0;  ///< standard deviation of the lag / lag
  double tilt = 0;           ///< largest power of the frequency per doubling of the speed
  double size_factor = 1;    ///< largest factor by which an unknown size may exceed the known sizes
  impacts::EqualiserOptions equaliser;
  double other_bearing_db = 0;  ///< spread_db if the tested bearing is not the known one
  double mass_kg = 1;           ///< M of eq. 13, which converts a resonance to k and c
  EdgePrior prior;              ///< not stored, unlike the edges found with it
};

/// Returns all options that a model stores, in the groups /carry, /strengths and /equaliser.
cli::StoredOptions table_of(CarryOptions& options);

/// Adds the table and the options of the prior.
void bind(const cli::Options& command, CarryOptions& options);

/// Throws Error(usage) if options contradict each other or the known windows: a load zone that ends
/// before it begins, or a background of healthy windows that a tested condition lacks.
void require_sense(CarryOptions options, const signal::WindowSet& known,
                   const std::vector<HealthySpectrum>& healthy);

}  // namespace piae::transfer
