#include "diagnosis/order_inputs.hpp"

#include <cmath>
#include <cstdlib>

#include "diagnosis/log_spectrum.hpp"
#include "diagnosis/wdcnn_inputs.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

Eigen::ArrayXd over_log_frequency(const scoring::Windows& window, double /*turns*/, Index points,
                                  double floor) {
  return log_frequency_spectrum(window, points, floor);
}

LabelledWindows both_spectra(const signal::WindowSet& windows, const std::string& what, Index bands,
                             Index orders) {
  require_speeds(windows, "a spectrum over orders");
  return side_by_side(windows, what, {{over_log_frequency, bands}, {log_order_spectrum, orders}});
}

}  // namespace

LabelledWindows frequency_and_order_spectra(const signal::WindowSet& windows,
                                            const std::string& what) {
  const Index half = spectral_inputs(windows) / 2;
  return both_spectra(windows, what, half, half);
}

FeatureRows order_features(const signal::WindowSet& windows, const std::string& what) {
  const LabelledWindows seen = both_spectra(windows, what, frequency_bands, shaft_orders);
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  FeatureRows rows =
      Eigen::Map<const Rows>(seen.samples.data(), std::ssize(seen.labels), by_orders.columns)
          .cast<double>();
  rows.rightCols(shaft_orders) *=
      std::sqrt(static_cast<double>(frequency_bands) / static_cast<double>(shaft_orders));
  return rows;
}

Learned learn_nearest_orders(const signal::WindowSet& /*normal*/, const signal::WindowSet& training,
                             const Stream& /*stream*/, const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<Nearest>(training, by_orders), .training = {}};
}

std::unique_ptr<Trained> read_nearest_orders(const artefact::Reader& reader,
                                             const signal::DatasetInfo& info, std::size_t length) {
  return std::make_unique<Nearest>(reader, info, length, by_orders);
}

}  // namespace piae::diagnosis
