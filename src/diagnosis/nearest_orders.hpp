#pragma once

#include <memory>
#include <string>

#include "diagnosis/nearest.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

inline constexpr Eigen::Index shaft_orders = 96;

/// Returns [n, 224]: band_powers(), and next to them the logarithm of the power of the envelope at
/// 96 shaft orders (log_order_spectrum()), less its mean over the orders, times `order_weight`.
/// Each window is measured at its own speed. Throws Error(bad_input) as band_powers(),
/// require_varying() and require_speeds() do; `what` names the set.
FeatureRows order_features(const signal::WindowSet& windows, const std::string& what);

/// Makes both halves weigh alike: healthy windows then scatter equally by bands and by orders,
/// within 14 %, on HIT-SM and CWRU. On HIT-SM's pairs of speeds (seeds 100 to 104, none) 1, 0.7 and
/// 0.5 give a mean of 69.9, 71.4 and 69.7 %; bands of equal width in log frequency give at most 63
/// %, whatever their weight.
inline constexpr double order_weight = 0.7;

inline constexpr WindowFeatures by_orders{.of = order_features,
                                          .columns = number_of_bands + shaft_orders};

/// Return a Nearest by these features.
Learned learn_nearest_orders(const signal::WindowSet& normal, const signal::WindowSet& training,
                             double prewhitening, const Stream& stream,
                             const EpochDone& epoch_done);
std::unique_ptr<Trained> read_nearest_orders(const artefact::Reader& reader,
                                             const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier nearest_orders{
    .name = "nearest-orders",
    .what = "the nearest window by the spectrum and, over shaft orders, the envelope spectrum",
    .input = "the log power in 128 bands, and that of the envelope at 96 shaft orders",
    .learn = learn_nearest_orders,
    .read = read_nearest_orders};

}  // namespace piae::diagnosis
