#include "transfer/strengths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/kinematics.hpp"
#include "bearing/load_zone.hpp"
#include "transfer/ranges.hpp"
#include "transfer/words.hpp"

namespace piae::transfer {

namespace {

const std::string strengths_group = "/strengths";

const Words<Strengths>& strength_words() {
  static const Words<Strengths> words{{"known", Strengths::known},
                                      {"load-zone", Strengths::load_zone},
                                      {"alike", Strengths::alike}};
  return words;
}

/// How fast a defect goes round in the load zone, in rad/s.
double turning(const bearing::Speeds& speeds, bearing::Defect kind) {
  switch (kind) {
    case bearing::Defect::inner:
      return speeds.shaft;
    case bearing::Defect::roller:
      return speeds.cage;
    default:
      return 0;
  }
}

}  // namespace

void bind(const cli::Options& command, StrengthOptions& o) {
  command.choose(
      "--strengths", o.from, strength_words(),
      "how strong strikes are: as in a known window (of another bearing: as in a load zone), as in "
      "a load zone, or all alike");
  command
      .add("--load-zone-from", o.least_extent,
           "least extent of the load zone: 0.5 is half a turn, less with clearance")
      .check(cli::within(ranges::extent));
  command
      .add("--load-zone-to", o.largest_extent,
           "largest extent of the load zone: more than 0.5 with preload")
      .check(cli::within(ranges::extent));
  command
      .add("--rotating-load", o.rotating,
           "load that turns with the shaft / load that stays: largest part")
      .check(cli::share());
  command
      .add("--strength-scatter", o.scatter,
           "of the logarithm of a strike's strength: largest standard deviation")
      .check(cli::within(ranges::scatter));
}

void write(artefact::Writer& writer, const StrengthOptions& options) {
  writer.group(strengths_group);
  writer.attribute(strengths_group, "from", word_of(options.from, strength_words()));
  writer.attribute(strengths_group, "least_extent", options.least_extent);
  writer.attribute(strengths_group, "largest_extent", options.largest_extent);
  writer.attribute(strengths_group, "rotating", options.rotating);
  writer.attribute(strengths_group, "scatter", options.scatter);
}

StrengthOptions read_strength_options(const artefact::Reader& reader) {
  const StrengthOptions options{
      .from = read_word(reader, strengths_group, "from", strength_words()),
      .least_extent = reader.real(strengths_group, "least_extent", ranges::extent),
      .largest_extent = reader.real(strengths_group, "largest_extent", ranges::extent),
      .rotating = reader.real(strengths_group, "rotating", ranges::part),
      .scatter = reader.real(strengths_group, "scatter", ranges::scatter)};
  if (options.least_extent > options.largest_extent) {
    reader.refuse(strengths_group, "has a load zone whose least extent is above the largest");
  }
  return options;
}

std::vector<double> load_zone_strengths(const Struck& struck, std::size_t count,
                                        const StrengthOptions& options, Stream& random) {
  const double extent =
      std::lerp(options.least_extent, options.largest_extent, random.uniform(0, 1));
  const double scatter = random.uniform(0, 1) * options.scatter;
  const double rotating = random.uniform(0, 1) * options.rotating;
  const double other_race = random.uniform(0, 1);
  const bearing::Speeds speeds = bearing::speeds(struck.geometry, struck.shaft_speed_rpm);
  const double rad_per_s = turning(speeds, struck.kind);
  const double start = rad_per_s > 0 ? random.uniform(0, 2 * std::numbers::pi) : 0;
  const double shaft_start = random.uniform(0, 2 * std::numbers::pi);
  std::vector<double> strengths(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = struck.period_s * static_cast<double>(i);
    const double angle = start + rad_per_s * time_s;
    // Seen from the inner race, this load stands still.
    const double comes_and_goes =
        struck.kind == bearing::Defect::inner
            ? 1
            : 1 + rotating * std::cos(shaft_start + speeds.shaft * time_s);
    const bool on_other_race = struck.kind == bearing::Defect::roller && i % 2 == 1;
    strengths[i] = bearing::load_share(angle, extent) * comes_and_goes *
                   std::exp(random.normal(0, scatter)) * (on_other_race ? other_race : 1);
  }
  // A window may be so short that its defect never is in the load zone, and it would be silent.
  if (std::ranges::max(strengths) <= 0) std::ranges::fill(strengths, 1.0);
  return strengths;
}

std::vector<double> repeated_strengths(std::span<const double> known, std::size_t count,
                                       Stream& random) {
  const std::size_t first = random.below(known.size());
  std::vector<double> strengths(count);
  for (std::size_t i = 0; i < count; ++i) strengths[i] = known[(first + i) % known.size()];
  return strengths;
}

}  // namespace piae::transfer
