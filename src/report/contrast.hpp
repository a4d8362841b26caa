#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// One of two sides that are shown beside each other: a dataset of a run.
struct Side {
  std::filesystem::path run;
  std::string dataset;
  signal::Protocol protocol = signal::Protocol::random;  ///< of its splits
  std::vector<AccuracyRow> rows = {};                    ///< followed by their mean_rows
  std::vector<std::string> gaps = {};                    ///< gap_paragraphs() of its cells
};

/// The folders RUN/DATASET of both sides, whose last parts name the datasets.
struct Folders {
  std::filesystem::path with;
  std::filesystem::path without;
};

/// What a condition is worth: the accuracies with it minus those without it, by method and ratio.
struct Contrast {
  Side with;
  Side without;
  std::vector<PairedRow> rows = {};  ///< by method, then ratio; then the means of ratios
};

/// Both sides must have the same methods, ratios and seeds. Throws Error(usage) when they have also
/// the same dataset and protocol and runs of the same name, so that nothing tells them apart.
Contrast contrast(Side with, Side without);

/// Reads the cells that are asked for, which both sides must have, and all others that both have
/// (run/held.hpp, which says what `leave_out` is). Throws as contrast(), resolve() and
/// run::require_all() do.
Contrast read_contrast(const Folders& folders, const run::GridOptions& asked,
                       const std::vector<std::string>& leave_out);

/// with,without,method,ratio,with_mean,with_std,without_mean,without_std and paired_columns(). The
/// sides are named by what differs between them: dataset, protocol, or else the run.
std::string contrast_csv(const Contrast& contrast);
/// The same for people.
Document contrast_document(const Contrast& contrast);

}  // namespace piae::report
