#pragma once

#include "diagnosis/adaptation.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/wdcnn_inputs.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Returns the unlabelled windows of the tested condition: all windows of D, and those of B that
/// were recorded in a tested condition, or in a data set without conditions. A machine runs healthy
/// most of the time, so an owner has such windows. All labels are those of the healthy class.
signal::WindowSet without_labels(const signal::WindowSet& normal, const signal::WindowSet& hidden);

inline constexpr Classifier dann{.name = "dann",
                                 .what = "wdcnn-orders, adapted to unlabelled windows of D",
                                 .input = wdcnn_orders.input,
                                 .represent = wdcnn_orders.represent,
                                 .adaptation = Adaptation::marginal};
inline constexpr Classifier cdan{.name = "cdan",
                                 .what = "the same, class by class",
                                 .input = wdcnn_orders.input,
                                 .represent = wdcnn_orders.represent,
                                 .adaptation = Adaptation::conditional};

}  // namespace piae::diagnosis
