#include "transfer/options.hpp"

#include "base/error.hpp"
#include "signal/ranges.hpp"
#include "transfer/ranges.hpp"
#include "transfer/words.hpp"

namespace piae::transfer {

namespace {

const std::string carry_group = "/carry";

void bind_prior(const cli::Options& command, EdgePrior& o) {
  command
      .add("--edge-share", o.share,
           "lag between both edges of a defect / time that a ball is over it: where spectra do not "
           "say otherwise")
      .check(cli::positive_number());
  command.add("--edge-share-deviation", o.share_deviation, "standard deviation of that")
      .check(cli::positive_number());
  command
      .add("--edge-exit", o.exit, "blow at the second edge / that at the first, in the same sense")
      .check(cli::share());
  command.add("--edge-exit-deviation", o.exit_deviation, "standard deviation of that")
      .check(cli::positive_number());
  command
      .add("--edge-prior-weight", o.weight,
           "of a squared standard deviation beside the squared error of the fit / its least")
      .check(cli::non_negative_number());
}

const Words<Set>& set_words() {
  static const Words<Set> words{{"tested", Set::tested}, {"known", Set::known}};
  return words;
}

const Words<Response>& response_words() {
  static const Words<Response> words{
      {"minimum-phase", Response::minimum_phase}, {"ring", Response::ring}, {"cut", Response::cut}};
  return words;
}

const Words<BackgroundFrom>& background_words() {
  static const Words<BackgroundFrom> words{{"struck", BackgroundFrom::struck},
                                           {"healthy", BackgroundFrom::healthy}};
  return words;
}

}  // namespace

void bind(const cli::Options& command, CarryOptions& o) {
  command.choose(
      "--response", o.response, response_words(),
      "how the machine answers a blow: as its spectrum says, as eq. 13's ring, or cut from "
      "known windows");
  command.choose("--edges", o.edges, set_words(),
                 "the lag between both edges of the defect: of the tested condition, or left");
  command.choose("--rhythm", o.rhythm, set_words(),
                 "the time between strikes: of the tested condition, or left");
  command
      .add("--own-structure", o.own_structure,
           "of what tells the structure of a bearing from that of all: the least part kept")
      .check(cli::share());
  command.add("--background", o.background, "largest part of the power that is not struck")
      .check(cli::share());
  command.choose("--background-from", o.background_from, background_words(),
                 "what colours it: the struck windows, or healthy ones of the tested condition");
  command
      .add("--dispersion-ms", o.dispersion_ms,
           "of the random transfer path: standard deviation of its group delay at a knot, ms")
      .check(cli::within(ranges::dispersion_ms));
  command.add("--strike-jitter", o.jitter, "of a strike: standard deviation / period")
      .check(cli::within(ranges::jitter));
  command.add("--lag-deviation", o.lag_deviation, "of a window's lag: standard deviation / lag")
      .check(cli::within(ranges::lag_deviation));
  command
      .add("--tilt", o.tilt,
           "at a doubled speed the spectrum grows with a power of the frequency, drawn between 0 "
           "and this")
      .check(cli::within(ranges::tilt));
  command
      .add("--size-factor", o.size_factor,
           "a defect of unknown size is up to so many times as large or small as those known")
      .check(cli::within(ranges::size_factor));
  bind(command, o.strengths);
  bind(command, o.equaliser);
  command
      .add("--other-bearing-db", o.other_bearing_db,
           "the same where the tested bearing is not the known one, dB")
      .check(cli::within(ranges::spread_db));
  command.add("--mass-kg", o.mass_kg, "M of eq. 13, by which windows have their k and c, kg")
      .check(cli::within(signal::ranges::mass_kg));
  bind_prior(command, o.prior);
}

void require_sense(const CarryOptions& options, const signal::WindowSet& known,
                   const std::vector<HealthySpectrum>& healthy) {
  if (options.strengths.least_extent > options.strengths.largest_extent) {
    throw Error(Exit::usage, "--load-zone-from is above --load-zone-to; it must not be");
  }
  if (options.background_from != BackgroundFrom::healthy) return;
  for (const std::int32_t condition : known.info.tested_conditions()) {
    if (find_spectrum(healthy, condition) == nullptr) {
      throw Error(
          Exit::usage,
          "--background-from healthy: needs healthy windows of the tested condition; give "
          "--healthy B.h5, of a data set whose [transfer] takes healthy windows from there");
    }
  }
}

void write(artefact::Writer& writer, const CarryOptions& options) {
  writer.group(carry_group);
  writer.attribute(carry_group, "response", word_of(options.response, response_words()));
  writer.attribute(carry_group, "edges", word_of(options.edges, set_words()));
  writer.attribute(carry_group, "rhythm", word_of(options.rhythm, set_words()));
  writer.attribute(carry_group, "own_structure", options.own_structure);
  writer.attribute(carry_group, "background", options.background);
  writer.attribute(carry_group, "background_from",
                   word_of(options.background_from, background_words()));
  writer.attribute(carry_group, "dispersion_ms", options.dispersion_ms);
  writer.attribute(carry_group, "jitter", options.jitter);
  writer.attribute(carry_group, "lag_deviation", options.lag_deviation);
  writer.attribute(carry_group, "tilt", options.tilt);
  writer.attribute(carry_group, "size_factor", options.size_factor);
  writer.attribute(carry_group, "other_bearing_db", options.other_bearing_db);
  writer.attribute(carry_group, "mass_kg", options.mass_kg);
  write(writer, options.strengths);
  write(writer, options.equaliser);
}

CarryOptions read_carry_options(const artefact::Reader& reader) {
  return {.response = read_word(reader, carry_group, "response", response_words()),
          .edges = read_word(reader, carry_group, "edges", set_words()),
          .rhythm = read_word(reader, carry_group, "rhythm", set_words()),
          .strengths = read_strength_options(reader),
          .own_structure = reader.real(carry_group, "own_structure", ranges::part),
          .background = reader.real(carry_group, "background", ranges::part),
          .background_from = read_word(reader, carry_group, "background_from", background_words()),
          .dispersion_ms = reader.real(carry_group, "dispersion_ms", ranges::dispersion_ms),
          .jitter = reader.real(carry_group, "jitter", ranges::jitter),
          .lag_deviation = reader.real(carry_group, "lag_deviation", ranges::lag_deviation),
          .tilt = reader.real(carry_group, "tilt", ranges::tilt),
          .size_factor = reader.real(carry_group, "size_factor", ranges::size_factor),
          .equaliser = read_equaliser_options(reader),
          .other_bearing_db = reader.real(carry_group, "other_bearing_db", ranges::spread_db),
          .mass_kg = reader.real(carry_group, "mass_kg", signal::ranges::mass_kg),
          .prior = {}};
}

}  // namespace piae::transfer
