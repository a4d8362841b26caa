#pragma once

#include <string>

#include "diagnosis/classifier.hpp"
#include "diagnosis/standardise.hpp"
#include "scoring/diagnosis_record.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

// Spectra of windows as the input of WDCNN. The floor of their logarithms is amplitude_floor times
// each window's root mean square. Each spectrum is scaled to mean 0 over the bands and unit
// standard deviation, so that the gain of a recording does not reveal its class; a constant
// spectrum becomes all zeros. There are at least as many inputs as a window has samples, and at
// least as many as the network needs: 1024 for windows of up to 1024 samples that divide it. `what`
// names the set in errors. All throw Error(bad_input) for a constant window, as standardise() does.

/// Returns the log_spectrum() of each window.
LabelledWindows log_spectra(const signal::WindowSet& windows, const std::string& what);

/// Returns the log_envelope_spectrum() of each window, standardised, with its label.
LabelledWindows log_envelope_spectra(const signal::WindowSet& windows, const std::string& what);

/// Returns both side by side, the log_spectrum() first, each with half of the inputs and scaled
/// separately.
LabelledWindows both_log_spectra(const signal::WindowSet& windows, const std::string& what);

/// Returns the log_spectrum() of each window and next to it the log_order_spectrum(), each with
/// half of the inputs and scaled separately. Resonances keep their frequency at every speed, and
/// lines keep their order. Throws also as require_speeds() does.
LabelledWindows spectra_by_order(const signal::WindowSet& windows, const std::string& what);

inline constexpr Classifier wdcnn{.name = scoring::paper_classifier,
                                  .what = "the paper's network",
                                  .input = "the waveform",
                                  .represent = standardise};
inline constexpr Classifier wdcnn_spectrum{.name = "wdcnn-spectrum",
                                           .what = "the same network on spectra",
                                           .input = "the log amplitude spectrum",
                                           .represent = log_spectra};
inline constexpr Classifier wdcnn_envelope{.name = "wdcnn-envelope",
                                           .what = "the same network on envelope spectra",
                                           .input = "the log envelope spectrum",
                                           .represent = log_envelope_spectra};
inline constexpr Classifier wdcnn_spectra{
    .name = "wdcnn-spectra",
    .what = "the same network on both spectra side by side",
    .input = "the log amplitude spectrum and the log envelope spectrum",
    .represent = both_log_spectra};
inline constexpr Classifier wdcnn_orders{
    .name = "wdcnn-orders",
    .what = "the same network on the spectrum and, over shaft orders, the envelope spectrum",
    .input = "the log amplitude spectrum and the log envelope spectrum over shaft orders",
    .represent = spectra_by_order};

}  // namespace piae::diagnosis
