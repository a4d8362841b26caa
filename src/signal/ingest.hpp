#pragma once

#include <filesystem>
#include <functional>

#include "signal/description.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// Called after each record that was read, with how many are done.
using RecordsDone = std::function<void(std::size_t)>;

/// Reads the raw files of a dataset below `data_dir`, checks them, and brings every record to the
/// dataset's sample rate. Samples keep the unit of their source. Throws Error(input_missing) for a
/// file that is not there, and Error(bad_input), with the file and the record, for
///   - a file whose sha256 is not the declared one, or that cannot be read (raw_file.hpp),
///   - a signal that is empty, has a NaN or infinite sample (with its index), or never changes,
///   - two records with the same samples, under one label or two.
Recordings ingest(const Description& description, const std::filesystem::path& data_dir,
                  const RecordsDone& done = {});

}  // namespace piae::signal
