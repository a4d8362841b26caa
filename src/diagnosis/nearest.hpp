#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnosis/band_powers.hpp"
#include "diagnosis/classifier.hpp"

namespace piae::diagnosis {

/// Numbers by which Nearest compares windows.
struct WindowFeatures {
  /// Returns [n, columns]. `what` names the set in errors. Throws Error(bad_input) for windows
  /// without such numbers.
  FeatureRows (*of)(const signal::WindowSet& windows, const std::string& what);
  Eigen::Index columns;
};

/// Returns band_powers(), for WindowFeatures.
FeatureRows band_power_features(const signal::WindowSet& windows, const std::string& what);
inline constexpr WindowFeatures by_band_powers{.of = band_power_features,
                                               .columns = number_of_bands};

/// Classifies a window by its nearest neighbour among the training windows. It is not trained
/// and is the baseline that a generator must beat. Windows are compared by their features. At equal
/// distances the first training window counts.
///
/// Scores are 1 for the predicted class and 0 for the others, because a neighbour gives no
/// certainty. Logits are minus half the squared distance to the nearest window of each class, as
/// for Gaussian kernels of unit width about the training windows; a class without windows has the
/// least logit.
class Nearest final : public Trained {
 public:
  /// Throws as the features do.
  explicit Nearest(const signal::WindowSet& training,
                   const WindowFeatures& features = by_band_powers);
  Nearest(const artefact::Reader& reader, const signal::DatasetInfo& info, std::size_t length,
          const WindowFeatures& features = by_band_powers);

  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override;
  void write(artefact::Writer& writer) const override;

 private:
  /// Adds the output for one window, given its squared distances to the training windows.
  void predict(const Eigen::VectorXd& squares, std::size_t window, Outputs& all) const;

  WindowFeatures features_;
  std::size_t length_;
  std::size_t classes_;
  std::vector<Label> labels_;  ///< of the training windows
  Neighbours training_;
};

Learned learn_nearest(const signal::WindowSet& normal, const signal::WindowSet& training,
                      double prewhitening, const Stream& stream, const EpochDone& epoch_done);
std::unique_ptr<Trained> read_nearest(const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier nearest{.name = "nearest",
                                    .what = "the nearest known or generated window, untrained",
                                    .input = "the log power in 128 bands",
                                    .learn = learn_nearest,
                                    .read = read_nearest};

}  // namespace piae::diagnosis
