#pragma once

#include <array>

#include "bearing/defect.hpp"
#include "bearing/geometry.hpp"
#include "symptoms/order_spectrum.hpp"

namespace piae::symptoms {

/// The kinds of defects, in the order in which they stand everywhere here.
inline constexpr std::array kinds{bearing::Defect::inner, bearing::Defect::roller,
                                  bearing::Defect::outer};
inline constexpr std::size_t number_of_kinds = kinds.size();

/// How many harmonics of a line count at most.
inline constexpr int most_harmonics = 4;

/// How often a defect of each kind is struck in a turn of the shaft, without slip: BPFI, 2 BSF and
/// BPFO by the frequency of the shaft.
std::array<double, number_of_kinds> line_orders(const bearing::Geometry& geometry);

/// The order that a spectrum must reach for all harmonics of these lines, with slip.
double last_order(const std::array<double, number_of_kinds>& orders);

/// The height of a line that stands at `order` without slip: the mean over its harmonics 1 ..
/// `harmonics` of the heights in the spectrum, clipped to `lowest` .. 2.5, at the one slip of up to
/// 1.2 % either way, in steps of 0.1 %, at which that mean is greatest (Randall and Antoni 2011:
/// bearings slip by 1 to 2 %). A common slip, since lines of something else near one of them
/// rarely are in tune.
double line_height(const OrderSpectrum& spectrum, double order, int harmonics, double lowest);

}  // namespace piae::symptoms
