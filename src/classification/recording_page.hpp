#pragma once

#include <string>

#include "classification/verdict.hpp"

namespace piae::classification {

/// Facts about the classifier that a page reports.
struct PageOrigin {
  const signal::DatasetInfo& info;
  bool is_calibrated = false;  ///< its probabilities
  std::string words;           ///< of origin_of()
};

/// Returns an HTML page about a recording, for a screen and two sheets of A4: its verdict and the
/// evidence in words of ISO 13373; its waveform, amplitude spectrum and envelope spectrum with the
/// fault lines of the bearing. A script adds cursors; without it the page shows everything else.
/// The page requests no other file.
std::string recording_page(const Verdict& verdict, const PageOrigin& origin);

}  // namespace piae::classification
