#include "zero/prior.hpp"

#include "signal/ranges.hpp"
#include "transfer/words.hpp"
#include "zero/ranges.hpp"
#include "zero/settings.hpp"

namespace piae::zero {

namespace {

const std::string prior_group = "/prior";

constexpr Setting<Prior> prior_settings[] = {
    {"slip", &Prior::slip, ranges::slip,
     "of the rate of strikes: largest deviation from rolling without slip / rate"},
    {"jitter", &Prior::jitter, ranges::jitter,
     "of a strike on a race: largest standard deviation / period"},
    {"ball-jitter", &Prior::ball_jitter, ranges::jitter, "the same of a ball's defect"},
    {"load-zone-from", &Prior::least_extent, ranges::extent,
     "least extent of the load zone: 0.5 is half a turn, less with clearance"},
    {"load-zone-to", &Prior::largest_extent, ranges::extent,
     "largest extent of the load zone: more than 0.5 with preload"},
    {"outer-angle-rad", &Prior::outer_angle_rad, ranges::angle_rad,
     "of an outer race's defect from the direction of the load: largest, rad"},
    {"rotating-load", &Prior::rotating, ranges::part,
     "load that turns with the shaft / load that stays: largest part"},
    {"strength-scatter", &Prior::strength_scatter, ranges::scatter,
     "of the logarithm of a strike's strength: largest standard deviation"},
    {"both-races", &Prior::other_race, ranges::part,
     "of a ball: strength on the race that is heard less / on the other: least; 1: alike"},
    {"ball-phase", &Prior::new_phase, ranges::part,
     "of a ball: largest probability that a turn of the cage finds it turned anyhow"},
    {"ball-random", &Prior::random_strikes, ranges::part,
     "of a ball: largest share of strikes at any moment"},
    {"ball-track", &Prior::least_on_track, ranges::part,
     "of a ball: least share of the time in which its spot meets a race; 1: always"},
    {"size-from-mm", &Prior::least_size_mm, ranges::size_mm, "least size of a defect, mm"},
    {"size-to-mm", &Prior::largest_size_mm, ranges::size_mm, "largest size of a defect, mm"},
    {"edge-exit", &Prior::least_exit, ranges::part,
     "blow at the second edge / that at the first, the other way: least; the largest is 1"},
    {"roughness", &Prior::roughness, ranges::part,
     "probability that the floor of a defect is rough"},
    {"resonance-from", &Prior::lowest_part, ranges::frequency_part,
     "lowest natural frequency / half the sampling rate"},
    {"resonance-to", &Prior::highest_part, ranges::frequency_part,
     "highest natural frequency / half the sampling rate"},
    {"damping-ratio-from", &Prior::least_damping, ranges::damping_ratio,
     "least damping ratio of a resonance"},
    {"damping-ratio-to", &Prior::largest_damping, ranges::damping_ratio,
     "largest damping ratio of a resonance"},
    {"gain-scatter", &Prior::gain_scatter, ranges::scatter,
     "of the logarithm of a resonance's height: standard deviation"},
    {"healthy-structure", &Prior::healthy_structure, ranges::part,
     "the structure is coloured by a power of the healthy spectrum, up to this"},
    {"path-db", &Prior::path_db, ranges::spread_db,
     "of the path from a defect to the sensor: standard deviation of its gain at a knot, dB"},
    {"mass-kg", &Prior::mass_kg, signal::ranges::mass_kg,
     "M of eq. 13, by which windows have their k and c, kg"},
    {"background-db", &Prior::background_db, ranges::spread_db,
     "of the healthy window under a fault: standard deviation of its gain at a knot, dB"},
    {"modulation", &Prior::modulation, ranges::part,
     "of a window at the bearing's rates, whatever is damaged: largest depth"},
    {"stray-knocks", &Prior::stray_knocks, ranges::part,
     "probability of knocks that have no rhythm"},
    {"level-from-db", &Prior::least_level_db, ranges::level_db,
     "what is struck over the background: least, dB"},
    {"level-to-db", &Prior::largest_level_db, ranges::level_db,
     "what is struck over the background: largest, dB"},
};

const transfer::Words<Switch>& switch_words() {
  static const transfer::Words<Switch> words{{"on", Switch::on}, {"off", Switch::off}};
  return words;
}

}  // namespace

void bind(const cli::Options& command, Prior& prior) {
  command.choose("--load-zone", prior.load_zone, switch_words(),
                 "whether a strike is as strong as the load on the ball, or all are alike");
  command.choose("--edges", prior.edges, switch_words(),
                 "whether a ball strikes the second edge of a defect, too");
  command.add("--resonances", prior.resonances, "of the structure: the most; the fewest are two")
      .check(cli::whole_number(static_cast<std::int64_t>(ranges::resonances.low),
                               static_cast<std::int64_t>(ranges::resonances.high)));
  bind<Prior>(command, prior, prior_settings);
}

void require_order(const Prior& prior) { require_order<Prior>(prior, prior_settings); }

void write(artefact::Writer& writer, const Prior& prior) {
  write<Prior>(writer, prior_group, prior, prior_settings);
  writer.attribute(prior_group, "load_zone", transfer::word_of(prior.load_zone, switch_words()));
  writer.attribute(prior_group, "edges", transfer::word_of(prior.edges, switch_words()));
  writer.attribute(prior_group, "resonances", std::int64_t{prior.resonances});
}

Prior read_prior(const artefact::Reader& reader) {
  Prior prior;
  read<Prior>(reader, prior_group, prior, prior_settings);
  prior.load_zone = transfer::read_word(reader, prior_group, "load_zone", switch_words());
  prior.edges = transfer::read_word(reader, prior_group, "edges", switch_words());
  prior.resonances =
      static_cast<int>(reader.integer(prior_group, "resonances", ranges::resonances));
  return prior;
}

}  // namespace piae::zero
