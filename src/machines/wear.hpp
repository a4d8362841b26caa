#pragma once

#include "base/random.hpp"
#include "cli/stored_options.hpp"
#include "machines/machine.hpp"
#include "signal/window_set.hpp"
#include "zero/prior.hpp"

namespace piae::machines {

/// Noise of worn surfaces that roll on each other. A rough defect excites the structure all the
/// time that a ball is near, and a defect of a ball, whose axis wanders, without a steady rate:
/// most of CWRU's records of ball defects are as Gaussian as healthy ones (Smith and Randall 2015).
struct Wear {
  double on_ball = 0.9;         ///< probability for a defect of a ball
  double on_race = 0.3;         ///< probability for a defect of a race
  double ball_depth = 0.3;      ///< largest modulation depth at 2 BSF
  double race_depth = 0.6;      ///< least modulation depth at BPFO or BPFI; the largest is 1
  double least_level_db = -15;  ///< level over the window without it
  double largest_level_db = 25;
};

/// Returns all options, stored in the group /wear.
cli::StoredOptions table_of(Wear& wear);

/// Adds noise to fault windows of a machine: white noise, modulated at the impact rate of the
/// defect and at the speed of the shaft (races) or the cage (balls), through a structure of its
/// own.
void add_wear(const Machine& machine, const Wear& wear, const zero::Prior& prior,
              const Stream& stream, signal::WindowSet& faults);

}  // namespace piae::machines
