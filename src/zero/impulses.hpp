#pragma once

#include "cli/stored_options.hpp"
#include "zero/machine.hpp"

namespace piae::zero {

/// Parameters that the common recipe draws for a window.
struct ImpulseOptions {
  double lowest_part = 1.0 / 6;     ///< lowest resonance / half the sampling rate: 1 kHz at 12 kHz
  double highest_part = 11.0 / 12;  ///< highest resonance: 5.5 kHz at 12 kHz
  double least_damping = 0.01;      ///< ratio
  double largest_damping = 0.1;
  double modulation = 0.9;      ///< largest modulation depth of the impulses' amplitude
  double least_level_db = -10;  ///< level of the impulses over the healthy window
  double largest_level_db = 10;
};

/// Returns all options, stored in the group /impulses of a model.
cli::StoredOptions table_of(ImpulseOptions& options);

/// The common recipe for unknown faults (McFadden and Smith 1984, the source of papers on synthetic
/// faults). Adds impulses at BPFO, BPFI or 2 BSF to a healthy window, without slip or jitter. Each
/// impulse excites one damped resonance,
///  exp(-2 pi f zeta t) sin(2 pi f t).
/// The amplitude varies once per shaft turn for a fault of the inner race, and once per cage turn
/// for a fault of a ball. All parameters are uniform, except the damping ratio, which is
/// log-uniform.
signal::MadeWindow add_impulses(const Machine& machine, const ImpulseOptions& options,
                                const Scene& scene, const Stream& random);

}  // namespace piae::zero
