#pragma once

#include <string>
#include <vector>

#include "readings/reading.hpp"
#include "run/layout.hpp"

namespace piae::readings {

/// One number of one interpretation at one seed.
struct Measured {
  std::string quantity;
  std::string ratio;  ///< empty if the quantity does not depend on it
  double value = 0;
};

/// Measures the cells of an interpretation at one seed. Quantities:
///   accuracy, nearest        percent of the test windows that WDCNN, and the nearest neighbour by
///                            spectra (diagnosis/nearest.hpp), classifies correctly; at each ratio
///   <metric of score.h5>     mean over the classes
///   L_DDL, L_DT, L_Rec       means of the last epoch
///   alpha, beta, gamma       their weights (eq. 23) after it
///   alpha_of_stationary ...  the weight times 2 L: 1 at the stationary point
///   open_contacts            percent of the known windows whose contact is open at rest
///   low_damping              percent of the known windows with less than 10 N s/m, the least that
///                            the paper names (3.3.1)
///   stiffness, damping       mean over the known windows, N/m and N s/m
///   stiffness_spread, damping_spread   standard deviation over the known windows, divided by the
///                            mean
///   stiffness_between_classes, damping_between_classes   share of the variance that lies between
///                            the classes (scoring/statistics.hpp)
///   stiffness_r2, stiffness_bias, damping_r2, damping_bias   against the true ones of D, if known
///                            (scoring/identifiability.hpp)
/// Throws artefact::Refusal for files that are missing, damaged or of other cells.
std::vector<Measured> measure(const run::Layout& layout, const Readings& readings,
                              const Reading& reading, std::int64_t seed);

}  // namespace piae::readings
