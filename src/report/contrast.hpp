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
};

/// Reads the cells of a grid in a folder RUN/DATASET, which names the dataset. Throws as resolve()
/// and run::require_all() do.
Side read_side(const std::filesystem::path& folder, run::GridOptions options);

/// What a condition is worth: the accuracies with it minus those without it, by method and ratio.
struct Contrast {
  Side with;
  Side without;
  std::vector<PairedRow> rows = {};  ///< by method, then ratio, then the mean of ratios
};

/// Both sides must have the same methods, ratios and seeds. Throws Error(usage) when they have also
/// the same dataset and protocol and runs of the same name, so that nothing tells them apart.
Contrast contrast(Side with, Side without);

/// with,without,method,ratio,with_mean,with_std,without_mean,without_std and paired_header(). The
/// sides are named by what differs between them: dataset, protocol, or else the run.
std::string contrast_csv(const Contrast& contrast);
/// The same for people.
Document contrast_document(const Contrast& contrast);

}  // namespace piae::report
