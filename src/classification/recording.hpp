#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "signal/recordings.hpp"
#include "signal/window_set.hpp"
#include "spectra/shaft_speed.hpp"

namespace piae::classification {

/// An unlabelled recording in a file of its own.
struct LoneFile {
  std::filesystem::path file;
  std::string variable;  ///< see raw/file.hpp
  double sample_rate_hz = 0;
  double shaft_speed_rpm = 0;
};

/// A recording at the classifier's sample rate.
struct Recording {
  std::string name;  ///< without terminal control characters
  double given_speed_rpm = 0;
  /// Speed that the signal shows, within 10 % of the given one; empty if too short.
  std::optional<spectra::ShaftSpeed> shaft = std::nullopt;
  double shaft_speed_rpm = 0;  ///< the shown speed if it was searched and is certain, or the given
  /// Speed over time, if it was recorded; its mean is then the given speed, and none is searched.
  std::optional<signal::SpeedCourse> speeds = std::nullopt;
  std::string true_class;  ///< class according to its description; empty without one
  std::vector<double> signal;
};

/// Requirements on recordings.
struct Fit {
  const diagnosis::Classifier& classifier;
  const signal::DatasetInfo& trained;  ///< of the classifier
  /// Range about the given speed in which it is taken from the signal; 0: the given speed counts.
  double speed_search_percent = 0;
};

/// Reads a recording. Throws Error as raw::read() does; Error(bad_input) for a sample that is not
/// finite, and as diagnosis::require_fitting_signal() does.
Recording read_lone_file(const LoneFile& lone, const Fit& fit);

/// Converts a record of a data set. Throws Error as diagnosis::require_fitting_signal() does.
Recording recording_of(const signal::Record& record, const signal::DatasetInfo& described,
                       const Fit& fit);

/// Reads the named records of a description, or all if `names` is empty. Its own
/// speed_search_percent counts if it has one. Passes the files of each
/// to `note`, for the provenance. Throws Error(usage) for an unknown name, and as
/// signal::RecordReader and recording_of() do.
std::vector<Recording> read_described(const std::filesystem::path& description,
                                      const std::filesystem::path& data_dir,
                                      const std::vector<std::string>& names, const Fit& fit,
                                      const std::function<void(const signal::SourceFile&)>& note);

/// Returns the named records of records.h5, or all if `names` is empty. Throws Error(usage) for an
/// unknown name, and as signal::read_recordings() and recording_of() do.
std::vector<Recording> read_recorded(const artefact::Reader& records,
                                     const std::vector<std::string>& names, const Fit& fit);

/// Returns the signal of a recording for its lines as a whole, at the classifier's rate: at even
/// steps of the shaft's angle (signal/even_angle.hpp), if its speed over time was recorded.
std::vector<double> signal_for_lines(const Recording& recording, double rate_hz);

/// Returns the windows of a recording, which start every `step` samples, at the speed of their own
/// time if that was recorded. Throws Error(bad_input) for a recording shorter than a window, and
/// for a constant stretch, which is a dead channel.
signal::WindowSet windows_of(const Recording& recording, const signal::DatasetInfo& trained,
                             std::size_t length, std::size_t step);

}  // namespace piae::classification
