#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "report/transfer_group.hpp"

namespace piae::report {

/// A group of datasets, as [transfer.GROUP] of pipeline/protocol.toml describes it, and the cells
/// that a table of it is made of.
struct TransferOptions {
  std::string group = {};
  std::vector<std::string> datasets = {};
  std::string against = {};
  std::vector<std::string> inputs = {};       ///< "none=wdcnn-spectrum", see parse_input_choice()
  std::vector<std::string> kind_inputs = {};  ///< the same for telling kinds; may be empty
  std::vector<std::string> methods = {};
  std::string ratio = {};  ///< of the generated windows; `none` is taken at 100to1
  std::vector<std::string> classifiers = {};
  std::vector<std::string> seeds = {};
};

/// Binds all but --group, which a program needs before the others (cli::Stage::choose_variant).
void bind(const cli::Options& command, TransferOptions& options);

/// Reads the cells from the folder of a run, such as results/paper. Throws Error(usage) as
/// run::resolve() and parse_input_choice() do, for a method with two inputs, for a ratio at which
/// nothing is generated, and where the input that is recorded for a method is not among the
/// classifiers; Error as run::require_all() for cells that are missing or refused; and
/// Error(bad_input) for datasets that were split by different protocols.
TransferGroup read_transfer(const std::filesystem::path& run, const TransferOptions& options);

}  // namespace piae::report
