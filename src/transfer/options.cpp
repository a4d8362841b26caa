#include "transfer/options.hpp"

#include "base/error.hpp"
#include "impacts/ranges.hpp"
#include "signal/ranges.hpp"

namespace piae::transfer {

namespace {

namespace ranges = impacts::ranges;

const std::vector<cli::Word<Response>> response_words{
    {"minimum-phase", Response::minimum_phase}, {"ring", Response::ring}, {"cut", Response::cut}};
const std::vector<cli::Word<Set>> set_words{{"tested", Set::tested}, {"known", Set::known}};
const std::vector<cli::Word<BackgroundFrom>> background_words{{"struck", BackgroundFrom::struck},
                                                              {"healthy", BackgroundFrom::healthy}};
const std::vector<cli::Word<Strengths>> strength_words{
    {"known", Strengths::known}, {"load-zone", Strengths::load_zone}, {"alike", Strengths::alike}};

void bind_prior(const cli::Options& command, EdgePrior& o) {
  const auto add = [&](const char* name, double& value, const cli::Check& check, const char* help) {
    command.add(name, value, help).check(check);
  };
  const cli::Check positive = cli::positive_number();
  add("--edge-share", o.share, positive,
      "lag between both edges of a defect / time that a ball is over it: where spectra do not say "
      "otherwise");
  add("--edge-share-deviation", o.share_deviation, positive, "standard deviation of that");
  add("--edge-exit", o.exit, cli::share(),
      "blow at the second edge / that at the first, in the same sense");
  add("--edge-exit-deviation", o.exit_deviation, positive, "standard deviation of that");
  add("--edge-prior-weight", o.weight, cli::non_negative_number(),
      "of a squared standard deviation beside the squared error of the fit / its least");
}

}  // namespace

cli::StoredOptions table_of(CarryOptions& o) {
  cli::StoredOptions table;
  table.in("/carry");
  table.add("response", o.response, response_words,
            "how the machine answers a blow: as its spectrum says, as eq. 13's ring, or cut from "
            "known windows");
  table.add("edges", o.edges, set_words,
            "the lag between both edges of the defect: of the tested condition, or left");
  table.add("rhythm", o.rate_of, set_words,
            "the time between strikes: of the tested condition, or left");
  table.add("own-structure", o.own_structure, ranges::part,
            "of what tells the structure of a bearing from that of all: the least part kept");
  table.add("background", o.background, ranges::part,
            "largest part of the power that is not struck");
  table.add("background-from", o.background_from, background_words,
            "what colours it: the struck windows, or healthy ones of the tested condition");
  table.add("dispersion-ms", o.dispersion_ms, ranges::dispersion_ms,
            "of the random transfer path: standard deviation of its group delay at a knot, ms");
  table.add("strike-jitter", o.jitter, ranges::jitter, "of a strike: standard deviation / period",
            "jitter");
  table.add("lag-deviation", o.lag_deviation, ranges::lag_deviation,
            "of a window's lag: standard deviation / lag");
  table.add("tilt", o.tilt, ranges::tilt,
            "at a doubled speed the spectrum grows with a power of the frequency, drawn between 0 "
            "and this");
  table.add("size-factor", o.size_factor, ranges::size_factor,
            "a defect of unknown size is up to so many times as large or small as those known");
  table.in("/strengths");
  table.add("strengths", o.strengths.from, strength_words,
            "how strong strikes are: as in a known window (of another bearing: as in a load zone), "
            "as in a load zone, or all alike",
            "from");
  impacts::add_to(table, o.strengths.load,
                  {"least_extent", "largest_extent", "rotating", "scatter"});
  impacts::add_to(table, o.equaliser);
  table.in("/carry");
  table.add("other-bearing-db", o.other_bearing_db, ranges::spread_db,
            "the same where the tested bearing is not the known one, dB");
  table.add("mass-kg", o.mass_kg, signal::ranges::mass_kg,
            "M of eq. 13, by which windows have their k and c, kg");
  return table;
}

void bind(const cli::Options& command, CarryOptions& options) {
  table_of(options).bind(command);
  bind_prior(command, options.prior);
}

void require_sense(CarryOptions options, const signal::WindowSet& known,
                   const std::vector<HealthySpectrum>& healthy) {
  table_of(options).require_order();
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

}  // namespace piae::transfer
