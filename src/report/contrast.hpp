#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// A data set of a run, as one of two sides that are compared.
struct Side {
  std::filesystem::path run;
  std::string dataset;
  signal::Protocol protocol = signal::Protocol::random;  ///< of its splits
  std::vector<AccuracyRow> rows = {};                    ///< followed by their mean_rows
  std::vector<std::string> gaps = {};                    ///< gap_paragraphs() of its cells
};

/// The folders RUN/DATASET of both sides, whose last parts name the data sets.
struct Folders {
  std::filesystem::path with;
  std::filesystem::path without;
};

/// Effect of a condition: accuracies with it minus those without it, by method and ratio.
struct Contrast {
  Side with;
  Side without;
  std::vector<PairedRow> rows = {};  ///< by method, then ratio; then the means of ratios
};

/// Compares two sides, which must have the same methods, ratios and seeds. Throws Error(usage) if
/// dataset, protocol and run name are also the same, because the sides would then have the same
/// name.
Contrast contrast(Side with, Side without);

/// Reads the requested cells, which both sides must have, and all others that both have.
/// run/held.hpp explains `leave_out`. Throws as contrast(), resolve() and run::require_all() do.
Contrast read_contrast(const Folders& folders, const run::GridOptions& read,
                       const std::vector<std::string>& leave_out);

/// Returns CSV with,without,method,ratio,with_mean,with_std,without_mean,without_std and
/// paired_columns(). The sides are named by what differs: dataset, protocol, or else the run.
std::string contrast_csv(const Contrast& contrast);
/// The same for people.
Document contrast_document(const Contrast& contrast);

}  // namespace piae::report
