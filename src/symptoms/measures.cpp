#include "symptoms/measures.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "bearing/impact_frequency.hpp"
#include "bearing/kinematics.hpp"
#include "signal/amplitude.hpp"
#include "spectra/bands.hpp"
#include "spectra/lines.hpp"

namespace piae::symptoms {

namespace {

using Orders = std::array<double, number_of_fault_types>;

constexpr double bins_apart = 2;
constexpr double lowest_line = -1;
constexpr double lowest_height = -0.5;
constexpr double longest_window = 1e9;  // in samples, more than any recording

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(Exit::bad_input, what + ": " + why);
}

/// Returns the order that a spectrum must reach for all harmonics of these lines, with slip.
double last_order(const Orders& orders) {
  return most_harmonics * (1 + spectra::largest_slip) * *std::ranges::max_element(orders);
}

double smallest_gap(Orders orders) {
  std::ranges::sort(orders);
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < orders.size(); ++i) gap = std::min(gap, orders[i] - orders[i - 1]);
  return gap;
}

/// Throws if the windows cannot show the lines at this speed.
void require_lines_shown(const signal::WindowSet& windows, double speed_rpm, const Orders& orders,
                         const std::string& what) {
  if (!(speed_rpm > 0)) {
    refuse(what,
           fmt::format("the shaft speed is {} rpm; fault lines need a speed above 0", speed_rpm));
  }
  const double rate_hz = windows.info.sample_rate_hz;
  const double shaft_hz = speed_rpm / 60;
  const double last_hz = last_order(orders) * shaft_hz;
  if (last_hz > rate_hz / 2) {
    refuse(what,
           fmt::format("at {:g} rpm fault lines reach {:.0f} Hz, above half the sample rate of "
                       "{:g} Hz; use a higher sample rate or a lower speed",
                       speed_rpm, last_hz, rate_hz));
  }
  const double needed =
      std::ceil(bins_apart * rate_hz / (most_harmonics * smallest_gap(orders) * shaft_hz));
  if (needed > longest_window) {
    refuse(what,
           "the fault lines of two fault types coincide in this bearing; choose another "
           "--classifier, such as wdcnn");
  }
  if (static_cast<double>(windows.length) < needed) {
    refuse(what, fmt::format("windows of {} samples are too short to tell the fault lines apart at "
                             "{:g} rpm; use {:.0f} or more",
                             windows.length, speed_rpm, needed));
  }
}

void require_measurable(const signal::WindowSet& windows, const Orders& orders,
                        const std::string& what) {
  if (spectra::narrow_bands(windows.info.sample_rate_hz).empty()) {
    refuse(what, fmt::format("a sample rate of {:g} Hz is too low for envelope analysis, which "
                             "needs 1800 Hz or more",
                             windows.info.sample_rate_hz));
  }
  for (std::size_t i = 0; i < windows.size(); ++i) {
    require_lines_shown(windows, windows.speed_rpm(i), orders, what);
    if (signal::is_constant(windows.window(i))) {
      refuse(what,
             fmt::format("window {} is constant; cut dead stretches out of the recordings", i));
    }
  }
}

double log_kurtosis(const Eigen::RowVectorXd& window) {
  const Eigen::ArrayXd squares = (window.array() - window.mean()).square();
  return std::log(squares.square().mean() / (squares.mean() * squares.mean()));
}

Measures measure_one(const Eigen::RowVectorXd& window, const spectra::FilterBank& bank,
                     double shaft_hz, const Orders& orders, double prewhitening) {
  const spectra::OrderSpectrum spectrum =
      spectra::order_spectrum(window, bank, shaft_hz, last_order(orders), prewhitening);
  Measures measures;
  for (std::size_t fault_type = 0; fault_type < number_of_fault_types; ++fault_type) {
    measures.lines.at(fault_type) =
        spectra::common_slip_height(spectrum, orders.at(fault_type), most_harmonics, lowest_line);
    for (int n = 1; n <= most_harmonics; ++n) {
      measures.heights.at(fault_type).at(n - 1) =
          spectra::common_slip_height(spectrum, orders.at(fault_type), n, lowest_height);
    }
  }
  measures.log_kurtosis = log_kurtosis(window);
  measures.shape_db = spectra::spectral_shape_db(window);
  measures.levels_db = spectra::band_levels_db(window, bank);
  return measures;
}

}  // namespace

std::array<double, number_of_fault_types> line_orders(const bearing::Geometry& geometry) {
  constexpr double one_turn_a_second_rpm = 60;
  std::array<double, number_of_fault_types> orders{};
  std::ranges::transform(fault_types, orders.begin(), [&](bearing::Defect fault_type) {
    return bearing::impact_frequency_hz(geometry, fault_type, one_turn_a_second_rpm);
  });
  return orders;
}

double fewest_turns(const bearing::Geometry& geometry) {
  return bins_apart / (most_harmonics * smallest_gap(line_orders(geometry)));
}

std::vector<Measures> measure(const signal::WindowSet& windows, const std::string& what,
                              double prewhitening) {
  if (!windows.info.has_bearing) {
    throw Error(
        Exit::bad_input,
        "data set " + windows.info.name +
            " does not describe its bearing, which gives the fault lines; add [bearing] to its "
            "description, or choose another --classifier, such as wdcnn");
  }
  bearing::validate(windows.info.bearing);
  const Orders orders = line_orders(windows.info.bearing);
  require_measurable(windows, orders, what);
  const spectra::FilterBank bank =
      spectra::filter_bank(windows.info.sample_rate_hz, static_cast<Eigen::Index>(windows.length));
  std::vector<Measures> all(windows.size());
  parallel_for(windows.size(), [&](std::size_t i) {
    const auto samples = windows.window(i);
    const Eigen::RowVectorXd window = Eigen::Map<const Eigen::RowVectorXf>(
                                          samples.data(), static_cast<Eigen::Index>(samples.size()))
                                          .cast<double>();
    all[i] = measure_one(window, bank, windows.speed_rpm(i) / 60, orders, prewhitening);
  });
  return all;
}

}  // namespace piae::symptoms
