#pragma once

#include "cli/stored_options.hpp"
#include "impacts/strengths.hpp"

namespace piae::zero {

enum class Switch { on, off };

/// What is believed of faults and paths of a machine of which no fault is known: the ranges from
/// which each window draws. Where each comes from, docs/piae-dt-zero.md says.
struct Prior {
  // The impact rate (impacts.hpp).
  double slip = 0.012;        ///< of the impact rate: largest deviation / rate, either way
  double jitter = 0.015;      ///< of an impact: largest standard deviation / period, on a race
  double ball_jitter = 0.03;  ///< of an impact: the same, of a ball

  // Strengths of impacts (impacts.hpp).
  Switch load_zone = Switch::on;
  impacts::LoadOptions load{
      .least_extent = 0.3, .largest_extent = 1.5, .rotating = 0.6, .scatter = 0.6};
  double outer_angle_rad = 0.6;  ///< of an outer race's defect from the load: the largest

  // Disorder of a ball (ball.hpp).
  double other_race = 0.2;    ///< strength on the weaker race / on the other: the least; 1: alike
  double new_phase = 1;       ///< probability that a turn of the cage finds it turned: the largest
  double random_strikes = 1;  ///< share of impacts at any moment: the largest
  double least_on_track = 0.1;  ///< share of the time in which the spot meets a race: the least

  // Both edges of the defect (impacts.hpp).
  Switch edges = Switch::on;
  double least_size_mm = 0.1;  ///< of the defect
  double largest_size_mm = 3.5;
  double least_exit = 0.2;  ///< strength at the second edge / at the first
  double roughness = 0.5;   ///< probability that the floor between both edges is rough

  // The structure (structure.hpp).
  int resonances = 6;        ///< the most
  double lowest_part = 0.1;  ///< of natural frequencies / half the sampling rate
  double highest_part = 0.95;
  double least_damping = 0.01;  ///< ratio
  double largest_damping = 0.08;
  double gain_scatter = 0.7;     ///< of a resonance's logarithm: standard deviation
  double healthy_structure = 1;  ///< power of the healthy amplitude spectrum: the largest
  double path_db = 10;           ///< of the path's gain at a knot: standard deviation
  double mass_kg = 1;            ///< M of eq. 13, by which a resonance has its k and c

  // The background, and all else that a window shows whatever is damaged (background.hpp).
  double background_db = 3;     ///< of its path's gain at a knot: standard deviation
  double modulation = 0.3;      ///< depth at a rate of the bearing: the largest
  double stray_knocks = 0.3;    ///< probability of knocks without a rate
  double least_level_db = -10;  ///< impacts over the background
  double largest_level_db = 20;
};

/// All of it, in the group /prior of a model.
cli::StoredOptions table_of(Prior& prior);

}  // namespace piae::zero
