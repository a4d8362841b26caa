#include "diagnosis/nearest_orders.hpp"

#include "diagnosis/log_spectrum.hpp"
#include "diagnosis/standardise.hpp"

namespace piae::diagnosis {

FeatureRows order_features(const signal::WindowSet& windows, const std::string& what) {
  require_varying(windows, what);
  require_speeds(windows, "a spectrum over orders");
  FeatureRows rows(static_cast<Eigen::Index>(windows.size()), by_orders.columns);
  rows.leftCols(number_of_bands) = band_powers(windows);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const scoring::Windows window =
        Eigen::Map<const Eigen::RowVectorXf>(windows.window(i).data(),
                                             static_cast<Eigen::Index>(windows.length))
            .cast<double>();
    Eigen::ArrayXd amplitudes = log_order_spectrum(window, shaft_turns(windows, i), shaft_orders,
                                                   amplitude_floor * root_mean_square(window));
    amplitudes -= amplitudes.mean();
    rows.row(static_cast<Eigen::Index>(i)).tail(shaft_orders) =
        order_weight * 2 * amplitudes.transpose();
  }
  return rows;
}

Learned learn_nearest_orders(const signal::WindowSet& /*normal*/, const signal::WindowSet& training,
                             double /*prewhitening*/, const Stream& /*stream*/,
                             const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<Nearest>(training, by_orders), .training = {}};
}

std::unique_ptr<Trained> read_nearest_orders(const artefact::Reader& reader,
                                             const signal::DatasetInfo& info, std::size_t length) {
  return std::make_unique<Nearest>(reader, info, length, by_orders);
}

}  // namespace piae::diagnosis
