#pragma once

#include "impacts/path.hpp"
#include "transfer/edge_fit.hpp"
#include "transfer/healthy.hpp"
#include "transfer/strengths.hpp"

namespace piae::transfer {

/// Whether something of a window is set to the tested condition or left as it is known.
enum class Set { tested, known };

/// Response of the machine to an impact: of its known spectrum, with minimum phase; of eq. 13's
/// ring (impacts/resonance.hpp); or cut from the known windows.
enum class Response { minimum_phase, ring, cut };

/// Colour of the background: the spectrum of the known windows, or of healthy windows of the tested
/// condition.
enum class BackgroundFrom { struck, healthy };

/// How windows are carried to the tested condition.
struct CarryOptions {
  Response response = Response::minimum_phase;
  Set edges = Set::tested;   ///< the lag between both edges of the defect
  Set rhythm = Set::tested;  ///< the time between impacts
  StrengthOptions strengths;
  double own_structure = 1;  ///< least part kept of what tells a bearing's structure from others'
  double background = 0;     ///< largest part of the power that is not struck
  BackgroundFrom background_from = BackgroundFrom::struck;
  double dispersion_ms = 0;  ///< of the random path's group delay: standard deviation
  double jitter = 0;         ///< of an impact: standard deviation / period
  double lag_deviation = 0;  ///< of the lag: standard deviation / lag
  double tilt = 0;           ///< largest power of the frequency for each doubling of the speed
  double size_factor = 1;    ///< how far beyond the known sizes one that is not known may lie
  impacts::EqualiserOptions equaliser;
  double other_bearing_db = 0;  ///< its spread_db where the tested bearing is not the known one
  double mass_kg = 1;           ///< M of eq. 13, by which a ring has its k and c
  EdgePrior prior;              ///< not stored: the edges that were found with it are
};

/// All that a model stores, of the groups /carry, /strengths and /equaliser.
cli::StoredOptions table_of(CarryOptions& options);

/// Adds the table and the options of the prior.
void bind(const cli::Options& command, CarryOptions& options);

/// Throws Error(usage) for options that do not go together, or not with the known windows: a load
/// zone that ends before it begins, and a background of healthy windows if a tested condition has
/// none.
void require_sense(CarryOptions options, const signal::WindowSet& known,
                   const std::vector<HealthySpectrum>& healthy);

}  // namespace piae::transfer
