#pragma once

#include <memory>
#include <string>

#include "diagnosis/classifier.hpp"
#include "diagnosis/nearest.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

// Lines of a bearing keep their order at every shaft speed, and resonances of a structure keep
// their frequency. So both inputs are the log spectrum over log frequency, and next to it the log
// envelope spectrum over shaft orders (log_spectrum.hpp). Each window is measured at its own speed.
// `what` names the set in errors. Both throw Error(bad_input) for constant windows, for windows
// shorter than 256 samples, and as require_speeds() does.

/// Returns both spectra, each with half of the inputs that WDCNN needs, and scaled separately as in
/// both_log_spectra().
LabelledWindows frequency_and_order_spectra(const signal::WindowSet& windows,
                                            const std::string& what);

inline constexpr Classifier wdcnn_orders{
    .name = "wdcnn-orders",
    .what =
        "the same network on the spectrum over log frequency and that of the envelope over "
        "orders",
    .input = "the log spectrum over log frequency and the log envelope spectrum over shaft orders",
    .represent = frequency_and_order_spectra};

/// Returns [n, 224]: 128 bands over log frequency and 96 orders, each scaled to mean 0 and unit
/// standard deviation. The orders are multiplied by sqrt(128 / 96), so both spectra have the same
/// norm in every window and weigh alike in a distance, whatever their contrast.
FeatureRows order_features(const signal::WindowSet& windows, const std::string& what);

inline constexpr Eigen::Index frequency_bands = 128;
inline constexpr Eigen::Index shaft_orders = 96;
inline constexpr WindowFeatures by_orders{.of = order_features,
                                          .columns = frequency_bands + shaft_orders};

/// Return a Nearest by orders.
Learned learn_nearest_orders(const signal::WindowSet& normal, const signal::WindowSet& training,
                             const Stream& stream, const EpochDone& epoch_done);
std::unique_ptr<Trained> read_nearest_orders(const artefact::Reader& reader,
                                             const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier nearest_orders{
    .name = "nearest-orders",
    .what = "the nearest window by the spectrum and, over shaft orders, the envelope spectrum",
    .input =
        "the log spectrum in 128 bands of log frequency, the log envelope spectrum at 96 "
        "orders",
    .learn = learn_nearest_orders,
    .read = read_nearest_orders};

}  // namespace piae::diagnosis
