#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "signal/recordings.hpp"
#include "signal/window_set.hpp"

namespace piae::classification {

/// A recording that nobody has labelled, in a file of its own.
struct LoneFile {
  std::filesystem::path file;
  std::string variable;  ///< raw_file.hpp
  double sample_rate_hz = 0;
  double shaft_speed_rpm = 0;
};

/// A recording at the classifier's sample rate.
struct Recording {
  std::string name;  ///< without what a terminal would obey
  double shaft_speed_rpm = 0;
  std::string said;  ///< the class that its description gives it; empty where none does
  std::vector<double> signal;
};

/// Throws Error as raw::read() does; Error(bad_input) for a sample that is not finite,
/// and as diagnosis::require_fitting_signal() does.
Recording read_lone_file(const LoneFile& lone, const signal::DatasetInfo& trained);

/// A record of a data set. Throws Error as diagnosis::require_fitting_signal() does.
Recording recording_of(const signal::Record& record, const signal::DatasetInfo& described,
                       const signal::DatasetInfo& trained);

/// The records of a description, those of these names, or all where none is named. Gives the files
/// of each to `note`, to be named in provenance. Throws Error(usage) for a name that no record has,
/// and as signal::RecordReader and recording_of() do.
std::vector<Recording> read_described(const std::filesystem::path& description,
                                      const std::filesystem::path& data_dir,
                                      const std::vector<std::string>& names,
                                      const signal::DatasetInfo& trained,
                                      const std::function<void(const signal::SourceFile&)>& note);

/// The windows of a recording, `step` samples from the start of one to that of the next. Throws
/// Error(bad_input) for a recording shorter than a window, and for a stretch in which nothing
/// moves: a dead channel.
signal::WindowSet windows_of(const Recording& recording, const signal::DatasetInfo& trained,
                             std::size_t length, std::size_t step);

}  // namespace piae::classification
