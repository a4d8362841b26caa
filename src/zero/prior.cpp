#include "zero/prior.hpp"

#include "impacts/ranges.hpp"
#include "signal/ranges.hpp"

namespace piae::zero {

namespace ranges = impacts::ranges;

cli::StoredOptions table_of(Prior& o) {
  const std::vector<cli::Word<Switch>> switch_words{{"on", Switch::on}, {"off", Switch::off}};
  cli::StoredOptions table;
  table.in("/prior");
  table.add("load-zone", o.load_zone, switch_words,
            "whether a strike is as strong as the load on the ball, or all are alike");
  table.add("edges", o.edges, switch_words,
            "whether a ball strikes the second edge of a defect, too");
  table.add("resonances", o.resonances, ranges::resonances,
            "of the structure: the most; the fewest are two");
  table.add("slip", o.slip, ranges::slip,
            "of the rate of strikes: largest deviation from rolling without slip / rate");
  table.add("jitter", o.jitter, ranges::jitter,
            "of a strike on a race: largest standard deviation / period");
  table.add("ball-jitter", o.ball_jitter, ranges::jitter, "the same of a ball's defect");
  impacts::add_to(table, o.load);
  table.add("outer-angle-rad", o.outer_angle_rad, ranges::angle_rad,
            "of an outer race's defect from the direction of the load: largest, rad");
  table.add("both-races", o.other_race, ranges::part,
            "of a ball: strength on the race that is heard less / on the other: least; 1: alike");
  table.add("ball-phase", o.new_phase, ranges::part,
            "of a ball: largest probability that a turn of the cage finds it turned anyhow");
  table.add("ball-random", o.random_impacts, ranges::part,
            "of a ball: largest share of strikes at any moment");
  table.add("ball-track", o.least_on_track, ranges::part,
            "of a ball: least share of the time in which its spot meets a race; 1: always");
  table.add("size-from-mm", o.least_size_mm, ranges::size_mm, "least size of a defect, mm");
  table.add("size-to-mm", o.largest_size_mm, ranges::size_mm, "largest size of a defect, mm");
  table.add("edge-exit", o.least_exit, ranges::part,
            "blow at the second edge / that at the first, the other way: least; the largest is 1");
  table.add("roughness", o.roughness, ranges::part,
            "probability that the floor of a defect is rough");
  table.add("resonance-from", o.lowest_part, ranges::frequency_part,
            "lowest natural frequency / half the sampling rate");
  table.add("resonance-to", o.highest_part, ranges::frequency_part,
            "highest natural frequency / half the sampling rate");
  table.add("damping-ratio-from", o.least_damping, ranges::damping_ratio,
            "least damping ratio of a resonance");
  table.add("damping-ratio-to", o.largest_damping, ranges::damping_ratio,
            "largest damping ratio of a resonance");
  table.add("gain-scatter", o.gain_scatter, ranges::scatter,
            "of the logarithm of a resonance's height: standard deviation");
  table.add("healthy-structure", o.healthy_structure, ranges::part,
            "the structure is coloured by a power of the healthy spectrum, up to this");
  table.add(
      "path-db", o.path_db, ranges::spread_db,
      "of the path from a defect to the sensor: standard deviation of its gain at a knot, dB");
  table.add("mass-kg", o.mass_kg, signal::ranges::mass_kg,
            "M of eq. 13, by which windows have their k and c, kg");
  table.add("background-db", o.background_db, ranges::spread_db,
            "of the healthy window under a fault: standard deviation of its gain at a knot, dB");
  table.add("modulation", o.modulation, ranges::part,
            "of a window at the bearing's rates, whatever is damaged: largest depth");
  table.add("stray-knocks", o.stray_impacts, ranges::part,
            "probability of knocks that have no rhythm");
  table.add("level-from-db", o.least_level_db, ranges::level_db,
            "what is struck over the background: least, dB");
  table.add("level-to-db", o.largest_level_db, ranges::level_db,
            "what is struck over the background: largest, dB");
  return table;
}

}  // namespace piae::zero
