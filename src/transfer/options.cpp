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
      "prior mean of the lag between both edges of a defect / time that a ball is over it");
  add("--edge-share-deviation", o.share_deviation, positive,
      "prior standard deviation of --edge-share");
  add("--edge-exit", o.exit, cli::share(),
      "prior mean of the impact at the second edge / at the first, of the same sign");
  add("--edge-exit-deviation", o.exit_deviation, positive,
      "prior standard deviation of --edge-exit");
  add("--edge-prior-weight", o.weight, cli::non_negative_number(),
      "weight of squared deviations from the prior against the squared error of the fit / its "
      "least");
}

}  // namespace

cli::StoredOptions table_of(CarryOptions& o) {
  cli::StoredOptions table;
  table.in("/carry");
  table.add("response", o.response, response_words,
            "response of the machine to an impact: from its spectrum (minimum-phase), the ring of "
            "eq. 13, or cut from known windows");
  table.add("edges", o.edges, set_words,
            "lag between both edges of the defect: of the tested condition, or as known");
  table.add("rhythm", o.rate_of, set_words,
            "time between impacts: of the tested condition, or as known");
  table.add("own-structure", o.own_structure, ranges::part,
            "least part kept of a bearing's deviation from the mean structure");
  table.add("background", o.background, ranges::part,
            "largest part of the power that impacts do not excite");
  table.add(
      "background-from", o.background_from, background_words,
      "spectrum of the background: of the windows with impacts (struck), or of healthy windows of "
      "the tested condition");
  table.add("dispersion-ms", o.dispersion_ms, ranges::dispersion_ms,
            "standard deviation of the group delay at a knot of the random transfer path, ms");
  table.add("strike-jitter", o.jitter, ranges::jitter,
            "standard deviation of an impact time / period", "jitter");
  table.add("lag-deviation", o.lag_deviation, ranges::lag_deviation,
            "standard deviation of a window's lag / lag");
  table.add("tilt", o.tilt, ranges::tilt,
            "largest power of the frequency by which the spectrum grows at a doubled speed; drawn "
            "from 0 to this");
  table.add("size-factor", o.size_factor, ranges::size_factor,
            "largest factor between the size of an unknown defect and the known sizes");
  table.in("/strengths");
  table.add(
      "strengths", o.strengths.from, strength_words,
      "strengths of impacts: of a known window (for another bearing: of a load zone), of a load "
      "zone, or all equal (alike)",
      "from");
  impacts::add_to(table, o.strengths.load,
                  {"least_extent", "largest_extent", "rotating", "scatter"});
  impacts::add_to(table, o.equaliser);
  table.in("/carry");
  table.add("other-bearing-db", o.other_bearing_db, ranges::spread_db,
            "--equaliser-db if the tested bearing is not the known one, dB");
  table.add("mass-kg", o.mass_kg, signal::ranges::mass_kg,
            "mass M of eq. 13, which converts a resonance to k and c, kg");
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
      throw Error(Exit::usage,
                  "--background-from healthy: needs healthy windows of the tested condition; give "
                  "--healthy B.h5 of a data set whose [transfer] includes them");
    }
  }
}

}  // namespace piae::transfer
