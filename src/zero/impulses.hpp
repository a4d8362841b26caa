#pragma once

#include "cli/stored_options.hpp"
#include "zero/machine.hpp"

namespace piae::zero {

/// What the common recipe draws for a window.
struct ImpulseOptions {
  double lowest_part = 1.0 / 6;     ///< of the resonance / half the sampling rate: 1 kHz at 12 kHz
  double highest_part = 11.0 / 12;  ///< 5.5 kHz at 12 kHz
  double least_damping = 0.01;      ///< ratio
  double largest_damping = 0.1;
  double modulation = 0.9;      ///< of the impulses' amplitude: the largest depth
  double least_level_db = -10;  ///< impulses over the healthy window
  double largest_level_db = 10;
};

/// All of it, in the group /impulses of a model.
cli::StoredOptions table_of(ImpulseOptions& options);

/// The common recipe for faults that are not known (McFadden and Smith 1984, of whom papers on
/// synthetic faults take it): impulses without slip or jitter at BPFO, BPFI or 2 BSF, each of which
/// excites one damped resonance,
///   exp(-2 pi f zeta t) sin(2 pi f t),
/// added to a healthy window. Their amplitude comes and goes once a turn of the shaft where the
/// inner race is damaged, and of the cage where a ball is. All is uniform but the damping ratio,
/// which is log-uniform.
signal::MadeWindow add_impulses(const Machine& machine, const ImpulseOptions& options,
                                const Scene& scene, const Stream& random);

}  // namespace piae::zero
