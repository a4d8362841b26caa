#include "figures/curves.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "augment/catalogue.hpp"
#include "twin/curves.hpp"

namespace piae::figures {

namespace {

struct NamedCurve {
  const char* name;
  std::vector<double> twin::Curves::*values;
};

constexpr NamedCurve losses[] = {{"reconstruction", &twin::Curves::reconstruction},
                                 {"differential", &twin::Curves::differential},
                                 {"twin", &twin::Curves::twin},
                                 {"total", &twin::Curves::total}};
constexpr NamedCurve weights[] = {{"alpha", &twin::Curves::alpha},
                                  {"beta", &twin::Curves::beta},
                                  {"gamma", &twin::Curves::gamma}};

/// Loss that belongs to each weight.
constexpr NamedCurve weighted_losses[] = {{"alpha", &twin::Curves::differential},
                                          {"beta", &twin::Curves::twin},
                                          {"gamma", &twin::Curves::reconstruction}};

/// Training of one seed.
struct SeedCurves {
  std::string seed;
  std::size_t epochs_in_a_row = 1;  ///< of the same stage
  twin::Curves curves;
};

/// Returns the length of a stage. The model stores it only in the options of `train`, as TOML.
std::size_t stage_epochs_of(const artefact::Reader& model) {
  const std::string options = model.strings("/provenance/options").at(0);
  const auto given = toml::parse(options)["stage-epochs"].value<std::string>();
  return given ? std::stoul(*given) : 1;
}

std::vector<SeedCurves> curves_of_all_seeds(Source& source) {
  std::vector<SeedCurves> all;
  const std::string& method = augment::paper_method();
  for (const std::int64_t seed : source.grid().seeds) {
    if (!source.has(method, seed, source.layout().model(method, seed))) continue;
    const artefact::Reader model = source.model(method, seed);
    SeedCurves one{
        .seed = std::to_string(seed), .epochs_in_a_row = stage_epochs_of(model), .curves = {}};
    one.curves.read(model);
    all.push_back(std::move(one));
  }
  if (all.empty()) throw LeftOut("the run has no model of the method " + method);
  return all;
}

/// Returns the mean over the seeds, up to the end of the shortest training.
std::vector<double> mean_curve(const std::vector<SeedCurves>& seeds, const NamedCurve& curve) {
  std::vector<double> mean = seeds.front().curves.*curve.values;
  for (const SeedCurves& seed : std::span(seeds).subspan(1)) {
    const std::vector<double>& values = seed.curves.*curve.values;
    mean.resize(std::min(mean.size(), values.size()));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += values[i];
  }
  for (double& value : mean) value /= static_cast<double>(seeds.size());
  return mean;
}

void add_curve(Numbers& numbers, const SeedCurves& seed, const std::string& name,
               const std::vector<double>& values) {
  for (std::size_t epoch = 0; epoch < values.size(); ++epoch) {
    const bool first_stage = epoch / seed.epochs_in_a_row % 2 == 0;
    numbers.row({seed.seed, first_stage ? "1" : "2", std::to_string(epoch + 1), name,
                 digits(values[epoch])});
  }
}

Numbers all_curves(const std::vector<SeedCurves>& seeds, std::span<const NamedCurve> curves) {
  Numbers numbers({"seed", "stage", "epoch", "curve", "value"});
  for (const NamedCurve& curve : curves) {
    for (const SeedCurves& seed : seeds) {
      add_curve(numbers, seed, curve.name, seed.curves.*curve.values);
    }
    SeedCurves mean{.seed = "mean", .epochs_in_a_row = seeds.front().epochs_in_a_row, .curves = {}};
    add_curve(numbers, mean, curve.name, mean_curve(seeds, curve));
  }
  return numbers;
}

/// Adds the minimum of eq. 23 for the mean loss L of each epoch, 1 / (2 L).
void add_stationary_weights(Numbers& numbers, const std::vector<SeedCurves>& seeds) {
  SeedCurves stationary{
      .seed = "stationary", .epochs_in_a_row = seeds.front().epochs_in_a_row, .curves = {}};
  for (const NamedCurve& loss : weighted_losses) {
    std::vector<double> weights;
    for (const double mean : mean_curve(seeds, loss)) {
      weights.push_back(1 / (2 * std::max(mean, std::numeric_limits<double>::min())));
    }
    add_curve(numbers, stationary, loss.name, weights);
  }
}

}  // namespace

Numbers loss_curves(Source& source) {
  const std::vector<SeedCurves> seeds = curves_of_all_seeds(source);
  return all_curves(seeds, losses);
}

Numbers weight_curves(Source& source) {
  const std::vector<SeedCurves> seeds = curves_of_all_seeds(source);
  Numbers numbers = all_curves(seeds, weights);
  add_stationary_weights(numbers, seeds);
  return numbers;
}

}  // namespace piae::figures
