#include "transfer/equaliser.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

#include "transfer/filter.hpp"
#include "transfer/ranges.hpp"

namespace piae::transfer {

namespace {

const std::string equaliser_group = "/equaliser";

}  // namespace

void bind(const cli::Options& command, EqualiserOptions& options) {
  command
      .add("--equaliser-db", options.spread_db,
           "of the random transfer path: standard deviation of its gain at a knot, dB")
      .check(cli::within(ranges::spread_db));
  command
      .add("--equaliser-knots", options.knots,
           "of the random transfer path: knots from 0 Hz to half the sampling rate")
      .check(cli::whole_number(static_cast<std::int64_t>(ranges::knots.low),
                               static_cast<std::int64_t>(ranges::knots.high)));
}

void write(artefact::Writer& writer, const EqualiserOptions& options) {
  writer.group(equaliser_group);
  writer.attribute(equaliser_group, "spread_db", options.spread_db);
  writer.attribute(equaliser_group, "knots", std::int64_t{options.knots});
}

EqualiserOptions read_equaliser_options(const artefact::Reader& reader) {
  return {.spread_db = reader.real(equaliser_group, "spread_db", ranges::spread_db),
          .knots = static_cast<int>(reader.integer(equaliser_group, "knots", ranges::knots))};
}

std::vector<double> draw_gains(Stream& random, std::size_t bins, const EqualiserOptions& options) {
  std::vector<double> knots_db(static_cast<std::size_t>(options.knots));
  for (double& db : knots_db) db = random.normal(0, options.spread_db);
  std::vector<double> gains(bins);
  const double knots_per_bin =
      static_cast<double>(knots_db.size() - 1) / static_cast<double>(bins - 1);
  for (std::size_t i = 0; i < bins; ++i) {
    const double place = static_cast<double>(i) * knots_per_bin;
    const auto below = std::min(static_cast<std::size_t>(place), knots_db.size() - 2);
    const double db =
        std::lerp(knots_db[below], knots_db[below + 1], place - static_cast<double>(below));
    gains[i] = std::pow(10, db / 20);
  }
  return gains;
}

void equalise(std::span<double> window, std::span<const double> gains) {
  Eigen::Map<Eigen::VectorXd> samples(window.data(), static_cast<Eigen::Index>(window.size()));
  const double before = samples.norm();
  filter(window, std::vector<std::complex<double>>(gains.begin(), gains.end()));
  const double after = samples.norm();
  if (after > 0) samples *= before / after;
}

}  // namespace piae::transfer
