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
            "scale impacts by the load on the ball (on), or make them all equal (off)");
  table.add("edges", o.edges, switch_words,
            "add the impact of a ball at the second edge of a defect");
  table.add("resonances", o.resonances, ranges::resonances,
            "largest number of resonances of the structure; the least is 2");
  table.add("slip", o.slip, ranges::slip,
            "largest deviation of the impact rate from rolling without slip / rate");
  table.add("jitter", o.jitter, ranges::jitter,
            "largest standard deviation of an impact time on a race / period");
  table.add("ball-jitter", o.ball_jitter, ranges::jitter,
            "largest standard deviation of an impact time of a ball defect / period");
  impacts::add_to(table, o.load);
  table.add("outer-angle-rad", o.outer_angle_rad, ranges::angle_rad,
            "largest angle between an outer race defect and the load, rad");
  table.add("both-races", o.other_race, ranges::part,
            "least strength of a ball's impacts on the weaker race / on the other; 1: equal");
  table.add("ball-phase", o.new_phase, ranges::part,
            "largest probability that a cage turn gives the ball a new phase");
  table.add("ball-random", o.random_impacts, ranges::part,
            "largest share of a ball's impacts at random times");
  table.add("ball-track", o.least_on_track, ranges::part,
            "least share of the time in which a ball's defect meets a race; 1: always");
  table.add("size-from-mm", o.least_size_mm, ranges::size_mm, "least size of a defect, mm");
  table.add("size-to-mm", o.largest_size_mm, ranges::size_mm, "largest size of a defect, mm");
  table.add("edge-exit", o.least_exit, ranges::part,
            "least impact at the second edge / at the first, of opposite sign; the largest is 1");
  table.add("roughness", o.roughness, ranges::part,
            "probability that the floor of a defect is rough");
  table.add("resonance-from", o.lowest_part, ranges::frequency_part,
            "lowest natural frequency / half the sample rate");
  table.add("resonance-to", o.highest_part, ranges::frequency_part,
            "highest natural frequency / half the sample rate");
  table.add("damping-ratio-from", o.least_damping, ranges::damping_ratio,
            "least damping ratio of a resonance");
  table.add("damping-ratio-to", o.largest_damping, ranges::damping_ratio,
            "largest damping ratio of a resonance");
  table.add("gain-scatter", o.gain_scatter, ranges::scatter,
            "standard deviation of the logarithm of a resonance's height");
  table.add("healthy-structure", o.healthy_structure, ranges::part,
            "largest power of the healthy spectrum that colours the structure");
  table.add("path-db", o.path_db, ranges::spread_db,
            "standard deviation of the gain at a knot of the path from defect to sensor, dB");
  table.add("mass-kg", o.mass_kg, signal::ranges::mass_kg,
            "mass M of eq. 13, which converts a resonance to k and c, kg");
  table.add("background-db", o.background_db, ranges::spread_db,
            "standard deviation of the gain at a knot of the healthy background, dB");
  table.add("modulation", o.modulation, ranges::part,
            "largest modulation depth of a window at the rates of the bearing");
  table.add("stray-knocks", o.stray_impacts, ranges::part,
            "probability of stray impacts at irregular times");
  table.add("level-from-db", o.least_level_db, ranges::level_db,
            "least level of the impacts over the background, dB");
  table.add("level-to-db", o.largest_level_db, ranges::level_db,
            "largest level of the impacts over the background, dB");
  return table;
}

}  // namespace piae::zero
