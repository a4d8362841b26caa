#pragma once

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "cli/options.hpp"

namespace piae::zero {

enum class Switch { on, off };

/// What is believed of faults and paths of a machine of which no fault is known: the ranges from
/// which each window draws. Where each comes from, docs/piae-dt-zero.md says.
struct Prior {
  // The rhythm (rhythm.hpp).
  double slip = 0.012;        ///< of the rate of strikes: largest deviation / rate, either way
  double jitter = 0.015;      ///< of a strike: largest standard deviation / period, on a race
  double ball_jitter = 0.03;  ///< of a strike: the same, of a ball

  // How strong strikes are (load.hpp).
  Switch load_zone = Switch::on;
  double least_extent = 0.3;  ///< of the load zone (bearing/load_zone.hpp)
  double largest_extent = 1.5;
  double outer_angle_rad = 0.6;   ///< of an outer race's defect from the load: the largest
  double rotating = 0.6;          ///< load that turns with the shaft / load that stays: the largest
  double strength_scatter = 0.6;  ///< of a strike's logarithm: largest standard deviation

  // What a ball does beside that (ball.hpp).
  double other_race = 0.2;    ///< strength on the weaker race / on the other: the least; 1: alike
  double new_phase = 1;       ///< probability that a turn of the cage finds it turned: the largest
  double random_strikes = 1;  ///< share of strikes at any moment: the largest
  double least_on_track = 0.1;  ///< share of the time in which the spot meets a race: the least

  // What a ball meets (impacts.hpp).
  Switch edges = Switch::on;
  double least_size_mm = 0.1;  ///< of the defect
  double largest_size_mm = 3.5;
  double least_exit = 0.2;  ///< second blow / first
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

  // The background (background.hpp), and what else is heard (nuisances.hpp).
  double background_db = 3;     ///< of its path's gain at a knot: standard deviation
  double modulation = 0.3;      ///< depth at a rate of the bearing: the largest
  double stray_knocks = 0.3;    ///< probability of knocks without rhythm
  double least_level_db = -10;  ///< what is struck over the background
  double largest_level_db = 20;
};

void bind(const cli::Options& command, Prior& prior);

/// Throws Error(usage) for a range that ends before it begins.
void require_order(const Prior& prior);

/// In the artefact: attributes of the group /prior. Throws artefact::Refusal also for a range that
/// ends before it begins.
void write(artefact::Writer& writer, const Prior& prior);
Prior read_prior(const artefact::Reader& reader);

}  // namespace piae::zero
