#include "transfer/options.hpp"

#include "transfer/ranges.hpp"

namespace piae::transfer {

namespace {

const std::string group = "/carry";

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

/// Stored as a word, so that a model says what it does.
std::string to_string(Set set) { return set == Set::tested ? "tested" : "known"; }

Set read_set(const artefact::Reader& reader, const std::string& name) {
  const std::string word = reader.text(group, name);
  for (const Set set : {Set::tested, Set::known}) {
    if (word == to_string(set)) return set;
  }
  reader.refuse(group + ", attribute " + name, "is " + word + ", must be tested or known");
}

std::string to_string(Response response) {
  return response == Response::cut ? "cut" : "minimum-phase";
}

Response read_response(const artefact::Reader& reader) {
  const std::string word = reader.text(group, "response");
  for (const Response response : {Response::minimum_phase, Response::cut}) {
    if (word == to_string(response)) return response;
  }
  reader.refuse(group + ", attribute response", "is " + word + ", must be minimum-phase or cut");
}

}  // namespace

void bind(const cli::Options& command, CarryOptions& o) {
  command.choose("--response", o.response,
                 {{"minimum-phase", Response::minimum_phase}, {"cut", Response::cut}},
                 "how the machine answers a blow: as its spectrum says, or cut from known windows");
  command
      .add("--least-own", o.least_own,
           "of what tells a bearing's structure from the others': the least part that is kept")
      .check(cli::within(ranges::part));
  command.add("--background", o.background, "largest part of the power that is not struck")
      .check(cli::within(ranges::part));
  command
      .add("--dispersion-s", o.dispersion_s, "group delay of the random path: standard deviation")
      .check(cli::within(ranges::dispersion_s));
  command
      .add("--strengths", o.strengths, "0: strikes are alike; 1: they differ as in known windows")
      .check(cli::within(ranges::part));
  const std::vector<cli::Word<Set>> words{{"tested", Set::tested}, {"known", Set::known}};
  command.choose("--edges", o.edges, words,
                 "the lag between both edges of the defect: of the tested condition, or left");
  command.choose("--rhythm", o.rhythm, words,
                 "the time between strikes: of the tested condition, or left");
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
  bind(command, o.equaliser);
  bind_prior(command, o.prior);
}

void write(artefact::Writer& writer, const CarryOptions& options) {
  writer.group(group);
  writer.attribute(group, "response", to_string(options.response));
  writer.attribute(group, "least_own", options.least_own);
  writer.attribute(group, "background", options.background);
  writer.attribute(group, "dispersion_s", options.dispersion_s);
  writer.attribute(group, "strengths", options.strengths);
  writer.attribute(group, "edges", to_string(options.edges));
  writer.attribute(group, "rhythm", to_string(options.rhythm));
  writer.attribute(group, "jitter", options.jitter);
  writer.attribute(group, "lag_deviation", options.lag_deviation);
  writer.attribute(group, "tilt", options.tilt);
  writer.attribute(group, "size_factor", options.size_factor);
  write(writer, options.equaliser);
}

CarryOptions read_carry_options(const artefact::Reader& reader) {
  return {.response = read_response(reader),
          .least_own = reader.real(group, "least_own", ranges::part),
          .background = reader.real(group, "background", ranges::part),
          .dispersion_s = reader.real(group, "dispersion_s", ranges::dispersion_s),
          .strengths = reader.real(group, "strengths", ranges::part),
          .edges = read_set(reader, "edges"),
          .rhythm = read_set(reader, "rhythm"),
          .jitter = reader.real(group, "jitter", ranges::jitter),
          .lag_deviation = reader.real(group, "lag_deviation", ranges::lag_deviation),
          .tilt = reader.real(group, "tilt", ranges::tilt),
          .size_factor = reader.real(group, "size_factor", ranges::size_factor),
          .equaliser = read_equaliser_options(reader),
          .prior = {}};
}

}  // namespace piae::transfer
