#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "cli/options.hpp"

namespace piae::transfer {

/// Where the strengths of strikes come from: from a known window, as long as its own bearing is the
/// tested one, which is loaded as it was; from the load that a ball carries in a load zone; or they
/// are all alike.
enum class Strengths { known, load_zone, alike };

/// How strong the strikes of a window are.
struct StrengthOptions {
  Strengths from = Strengths::known;
  double least_extent = 0.2;  ///< of the load zone (bearing/load_zone.hpp), drawn for each window
  double largest_extent = 1;
  double rotating = 0;  ///< load that turns with the shaft / load that stays: the largest
  double scatter = 0;   ///< of a strike's logarithm: largest standard deviation
};

/// Adds --strengths, --load-zone-from, --load-zone-to, --rotating-load and --strength-scatter.
void bind(const cli::Options& command, StrengthOptions& options);

/// In the artefact: attributes of the group /strengths. Throws artefact::Refusal also for a load
/// zone that ends before it begins.
void write(artefact::Writer& writer, const StrengthOptions& options);
StrengthOptions read_strength_options(const artefact::Reader& reader);

/// What is struck, and how fast: a defect of this kind every `period_s`, at this speed.
struct Struck {
  bearing::Geometry geometry;
  bearing::Defect kind = bearing::Defect::outer;
  double shaft_speed_rpm = 0;
  double period_s = 0;
};

/// The strengths of `count` strikes, one behind the other. An inner race carries its defect through
/// the load zone with the shaft, a ball with the cage; a defect of the outer race stays in the
/// middle of it. A load that turns with the shaft, such as that of an unbalance, comes and goes for
/// the balls on outer race and cage: a factor of 1 + m cos(angle of the shaft). A ball strikes both
/// races in turn, and one of them is heard less, by a part that is drawn. The extent of the zone,
/// where in it the window begins, m, and the standard deviation by which single strikes scatter,
/// both up to those of the options, are drawn, too. At least one is positive.
std::vector<double> load_zone_strengths(const Struck& struck, std::size_t count,
                                        const StrengthOptions& options, Stream& random);

/// `count` strengths that follow each other as those given, from a random one on. There must be
/// one.
std::vector<double> repeated_strengths(std::span<const double> known, std::size_t count,
                                       Stream& random);

}  // namespace piae::transfer
