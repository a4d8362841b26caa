#include "transfer/edge_fit.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index smooth_cosines = 5;
constexpr int most_rounds = 12;
constexpr double least_share = 0.7;
constexpr double largest_share = 1.15;
constexpr double share_step = 0.01;

/// One point of the grid.
struct Place {
  double share;
  double exit;
  double spread;
};

std::vector<Place> grid() {
  std::vector<Place> places;
  const auto shares = static_cast<int>(std::lround((largest_share - least_share) / share_step));
  for (int i = 0; i <= shares; ++i) {
    for (const double exit : {0.0, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9}) {
      for (const double spread : {0.0, 0.015, 0.03, 0.05}) {
        places.push_back({.share = least_share + i * share_step, .exit = exit, .spread = spread});
      }
    }
  }
  return places;
}

impacts::Edges edges_at(const Place& place, double passage_s) {
  return {.lag_s = place.share * passage_s, .exit = place.exit, .spread = place.spread};
}

/// Returns the distance of each place from the prior, in squared standard deviations.
ArrayXd surprise(const std::vector<Place>& places, const EdgePrior& prior) {
  ArrayXd all(static_cast<Index>(places.size()));
  for (Index i = 0; i < all.size(); ++i) {
    const Place& place = places[static_cast<std::size_t>(i)];
    all[i] = std::pow((place.share - prior.share) / prior.share_deviation, 2) +
             std::pow((place.exit - prior.exit) / prior.exit_deviation, 2);
  }
  return all;
}

/// Removes the smooth part of curves over the band.
class Detrend {
 public:
  explicit Detrend(Index bins) {
    MatrixXd cosines(bins, smooth_cosines);
    for (Index i = 0; i < bins; ++i) {
      const double place =
          std::numbers::pi * static_cast<double>(i) / static_cast<double>(bins - 1);
      for (Index j = 0; j < smooth_cosines; ++j) {
        cosines(i, j) = std::cos(static_cast<double>(j) * place);
      }
    }
    smooth_ = cosines.householderQr().householderQ() * MatrixXd::Identity(bins, smooth_cosines);
  }

  [[nodiscard]] MatrixXd operator()(const MatrixXd& curves) const {
    return curves - smooth_ * (smooth_.transpose() * curves);
  }

 private:
  MatrixXd smooth_;  ///< orthonormal
};

/// Candidates for one bearing.
struct Trial {
  VectorXd seen;       ///< log|Y|, without its smooth part
  MatrixXd explained;  ///< log|E| at every point of the grid, by column, without its smooth part
  Index best = 0;

  [[nodiscard]] VectorXd left() const { return seen - explained.col(best); }
};

Trial trial_of(const SeenBearing& bearing, const Band& band, const std::vector<Place>& places,
               const Detrend& detrend) {
  const Index bins = band.last - band.first + 1;
  MatrixXd explained(bins, static_cast<Index>(places.size()));
  for (Index j = 0; j < explained.cols(); ++j) {
    const impacts::Edges edges = edges_at(places[static_cast<std::size_t>(j)], bearing.passage_s);
    for (Index i = 0; i < bins; ++i) {
      const double hz = static_cast<double>(band.first + i) * band.bin_hz;
      explained(i, j) = std::log(edges.amplitude(hz));
    }
  }
  return {.seen = detrend(bearing.log_amplitude.segment(band.first, bins).matrix()),
          .explained = detrend(explained)};
}

/// Returns the mean of what all other bearings leave unexplained.
VectorXd structure_and_edges(const std::vector<Trial>& trials, std::size_t own) {
  VectorXd sum = VectorXd::Zero(trials[own].seen.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (i != own) sum += trials[i].left();
  }
  return sum / static_cast<double>(trials.size() - 1);
}

}  // namespace

std::vector<impacts::Edges> fit_edges(const std::vector<SeenBearing>& bearings, const Band& band,
                                      const EdgePrior& prior) {
  const std::vector<Place> places = grid();
  const ArrayXd unlikely = prior.weight * surprise(places, prior);
  const Detrend detrend(band.last - band.first + 1);
  std::vector<Trial> trials;
  for (const SeenBearing& bearing : bearings) {
    trials.push_back(trial_of(bearing, band, places, detrend));
    unlikely.minCoeff(&trials.back().best);
  }
  bool changed = trials.size() > 1;
  for (int round = 0; changed && round < most_rounds; ++round) {
    changed = false;
    for (std::size_t b = 0; b < trials.size(); ++b) {
      const VectorXd own = trials[b].seen - structure_and_edges(trials, b);
      const ArrayXd errors =
          (trials[b].explained.colwise() - own).colwise().squaredNorm().transpose();
      Index best = 0;
      (errors / errors.minCoeff() + unlikely).minCoeff(&best);
      changed |= best != trials[b].best;
      trials[b].best = best;
    }
  }
  std::vector<impacts::Edges> found;
  for (std::size_t b = 0; b < trials.size(); ++b) {
    found.push_back(
        edges_at(places[static_cast<std::size_t>(trials[b].best)], bearings[b].passage_s));
  }
  return found;
}

}  // namespace piae::transfer
