#include "transfer/equaliser.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

#include "base/range.hpp"

namespace piae::transfer {

namespace {

const std::string group = "/equaliser";
constexpr Range spreads{.low = 0, .high = 60, .unit = " dB"};
constexpr Range knots{.low = 2, .high = 1000};

}  // namespace

void bind(const cli::Options& command, EqualiserOptions& options) {
  command
      .add("--equaliser-db", options.spread_db,
           "of the random transfer path: standard deviation of its gain at a knot, dB")
      .check(
          cli::number("from 0 to 60", spreads.rule(), [](double db) { return spreads.holds(db); }));
  command
      .add("--equaliser-knots", options.knots,
           "of the random transfer path: knots from 0 Hz to half the sampling rate")
      .check(cli::whole_number(static_cast<std::int64_t>(knots.low),
                               static_cast<std::int64_t>(knots.high)));
}

void write(artefact::Writer& writer, const EqualiserOptions& options) {
  writer.group(group);
  writer.attribute(group, "spread_db", options.spread_db);
  writer.attribute(group, "knots", std::int64_t{options.knots});
}

EqualiserOptions read_equaliser_options(const artefact::Reader& reader) {
  return {.spread_db = reader.real(group, "spread_db", spreads),
          .knots = static_cast<int>(reader.integer(group, "knots", knots))};
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
  if (gains.size() != window.size() / 2 + 1) {
    throw std::logic_error("equalise: one gain for each bin of the spectrum");
  }
  const Eigen::Map<Eigen::VectorXd> samples(window.data(),
                                            static_cast<Eigen::Index>(window.size()));
  const double before = samples.norm();
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> spectrum;
  std::vector<double> filtered(window.begin(), window.end());
  fft.fwd(spectrum, filtered);
  for (std::size_t i = 0; i < gains.size(); ++i) spectrum[i] *= gains[i];
  fft.inv(filtered, spectrum, static_cast<Eigen::Index>(window.size()));
  const double after = Eigen::Map<Eigen::VectorXd>(filtered.data(), samples.size()).norm();
  const double level = after > 0 ? before / after : 1;
  std::ranges::transform(filtered, window.begin(), [&](double x) { return level * x; });
}

}  // namespace piae::transfer
