#pragma once

#include "cli/stored_options.hpp"
#include "impacts/strengths.hpp"

namespace piae::zero {

enum class Switch { on, off };

/// Assumptions about faults and paths of a machine without known faults: the ranges from which each
/// window draws. pipeline/protocol.toml gives their sources.
struct Prior {
  // The impact rate (impacts.hpp).
  double slip = 0.012;    ///< largest relative deviation of the impact rate, either way
  double jitter = 0.015;  ///< largest standard deviation of an impact's time / period, on a race
  double ball_jitter = 0.03;  ///< the same for a defect of a ball

  // Strengths of impacts (impacts.hpp).
  Switch load_zone = Switch::on;
  impacts::LoadOptions load{
      .least_extent = 0.3, .largest_extent = 1.5, .rotating = 0.6, .scatter = 0.6};
  double outer_angle_rad = 0.6;  ///< largest angle between an outer race's defect and the load

  // Disorder of a ball (ball.hpp).
  double other_race = 0.2;  ///< least strength on the weaker race / on the other race; 1: equal
  double new_phase = 1;  ///< largest probability that a turn of the cage gives the ball a new phase
  double random_impacts = 1;    ///< largest fraction of impacts at random times
  double least_on_track = 0.1;  ///< least fraction of the time in which the defect meets a race

  // Both edges of the defect (impacts.hpp).
  Switch edges = Switch::on;
  double least_size_mm = 0.1;  ///< least size of a defect
  double largest_size_mm = 3.5;
  double least_exit = 0.2;  ///< least strength at the second edge / at the first
  double roughness = 0.5;   ///< probability that the floor between both edges is rough

  // The structure (structure.hpp).
  int resonances = 6;        ///< largest number of resonances
  double lowest_part = 0.1;  ///< lowest natural frequency / half the sampling rate
  double highest_part = 0.95;
  double least_damping = 0.01;  ///< damping ratio
  double largest_damping = 0.08;
  double gain_scatter = 0.7;     ///< standard deviation of the logarithm of a resonance's height
  double healthy_structure = 1;  ///< largest power of the healthy amplitude spectrum
  double path_db = 10;           ///< standard deviation of the path's gain at a knot
  double mass_kg = 1;            ///< M of eq. 13, which converts a resonance to k and c

  // The background and everything that a window shows independently of a fault (background.hpp).
  double background_db = 3;     ///< standard deviation of the background path's gain at a knot
  double modulation = 0.3;      ///< largest modulation depth at a rate of the bearing
  double stray_impacts = 0.3;   ///< probability of stray impacts without a rate
  double least_level_db = -10;  ///< level of the impacts over the background
  double largest_level_db = 20;
};

/// Returns all options, stored in the group /prior of a model.
cli::StoredOptions table_of(Prior& prior);

}  // namespace piae::zero
