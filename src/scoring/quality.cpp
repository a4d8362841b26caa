#include "scoring/quality.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "bearing/impact_frequency.hpp"
#include "scoring/mmd.hpp"
#include "scoring/waveform.hpp"
#include "spectra/lines.hpp"

namespace piae::scoring {

namespace {

constexpr std::array<Metric, 7> metrics{{
    {"mmd", &ClassQuality::mmd, "MMD²",
     "Squared maximum mean discrepancy, biased estimate; lower is better. It is almost blind to "
     "structure: noise of the right power scores better than a few repeated real windows.",
     true},
    {"rmse", &ClassQuality::rmse, "RMSE",
     "In the unit of the recordings; lower is better. Windows start at any angle of the shaft, so "
     "silence scores better than real windows do.",
     true},
    {"aligned_rmse", &ClassQuality::aligned_rmse, "aligned RMSE",
     "RMSE after the best circular shift, in the unit of the recordings; lower is better.", false},
    {"amplitude_ratio", &ClassQuality::amplitude_ratio, "amplitude ratio",
     "RMS of the generated windows / RMS of the real ones; 1 is right, 0 is silence.", false},
    {"spectral_distance_db", &ClassQuality::spectral_distance_db, "log-spectral distance, dB",
     "Between the mean power spectra; lower is better.", false},
    {"fault_line_db", &ClassQuality::fault_line_db, "fault line, dB",
     "Excess of the class's own fault lines (BPFO, BPFI or 2 BSF, and two harmonics) in the "
     "envelope spectrum of the generated windows; 0: no line. The target is the value of real "
     "windows: see the next section.",
     false, 1, true},
    {"fault_line_difference_db", &ClassQuality::fault_line_difference_db,
     "fault line, generated minus real, dB",
     "0 is right; below 0 the fault is fainter than in real windows, above 0 clearer. For 45 other "
     "real windows of a class the difference is mostly below 1 dB. If real windows do not show a "
     "line (below 2 dB; many ball faults), 0 means only that the method invented none. Opposite "
     "signs cancel in the mean.",
     false, 1, true},
}};

// Largest squared distance, as a part of the windows' mean square, that counts as rounding:
// distances are differences of squares.
constexpr double rounding = 1e-12;

[[noreturn]] void refuse(const std::string& line) { throw Error(Exit::bad_input, line); }

void require_comparable(const signal::WindowSet& generated, const signal::WindowSet& real) {
  const auto same_name = [](const signal::ClassInfo& a, const signal::ClassInfo& b) {
    return a.name == b.name;
  };
  if (generated.info.name != real.info.name ||
      !std::ranges::equal(generated.info.classes, real.info.classes, same_name)) {
    refuse("the generated windows belong to data set " + generated.info.name +
           ", the real ones to data set " + real.info.name +
           " or to other classes; score windows of one data set");
  }
  if (generated.length != real.length) {
    refuse("generated windows have " + std::to_string(generated.length) + " samples, real ones " +
           std::to_string(real.length) + "; generate from a model trained on the same split");
  }
  if (real.size() == 0) refuse("there are no real windows to compare with; give D.h5 of split");
}

/// Throws if the real windows of a class do not allow a comparison.
void require_reference(const std::string& name, const Windows& real, double squared_distance) {
  const Eigen::VectorXd means = real.rowwise().mean();
  if ((real.colwise() - means).isZero(0))
    refuse("class " + name +
           ": the real windows are constant; cut dead stretches out of the recording");
  const double mean_square = real.squaredNorm() / static_cast<double>(real.rows());
  if (squared_distance <= rounding * mean_square) {
    refuse("class " + name + ": all real windows are the same");
  }
}

/// Returns the height of the fault's line in these windows, the first of their class. The line of
/// each window is at its own shaft speed, or at the tested speed if the method records no speeds.
double line_db_of(const signal::WindowSet& set, Label label, const Windows& windows) {
  const signal::DatasetInfo& info = set.info;
  if (!has_line(info, label)) return 0;
  const std::vector<std::size_t> own = set.indices_of(label);
  std::map<double, std::vector<Eigen::Index>> by_speed;
  for (Eigen::Index i = 0; i < windows.rows(); ++i) {
    const bool has_speeds = !set.shaft_speed_rpm.empty();
    by_speed[has_speeds ? set.speed_rpm(own[static_cast<std::size_t>(i)]) : info.tested_speed_rpm()]
        .push_back(i);
  }
  double sum = 0;
  for (const auto& [speed_rpm, rows] : by_speed) {
    const double line_hz =
        bearing::impact_frequency_hz(info.bearing, info.class_of(label).defect, speed_rpm);
    const spectra::EnvelopeSpectrum spectrum =
        spectra::envelope_spectrum(windows(rows, every_column(windows)), info.sample_rate_hz);
    const double part = static_cast<double>(rows.size()) / static_cast<double>(windows.rows());
    sum += part * spectra::free_harmonics_db(spectrum, line_hz);
  }
  return sum;
}

ClassQuality quality_of(const signal::WindowSet& generated, const signal::WindowSet& real,
                        Label label) {
  const signal::ClassInfo& c = real.info.class_of(label);
  const std::string& name = c.name;
  const std::size_t count = std::min(generated.count_of(label), real.count_of(label));
  if (count == 0) {
    refuse("class " + name + " has " + std::to_string(generated.count_of(label)) +
           " generated and " + std::to_string(real.count_of(label)) +
           " real windows; give at least one of each");
  }
  const Windows reference = windows_of(real, label, real.count_of(label));
  if (reference.rows() < 2)
    refuse("class " + name + ": there is only one real window; give two or more");
  const double squared_distance = mean_squared_distance(reference);
  const Windows x = windows_of(generated, label, count);
  const Windows y = reference.topRows(static_cast<Eigen::Index>(count));
  require_reference(name, y, squared_distance);
  const double line_db = line_db_of(generated, label, x);
  const double real_line_db = line_db_of(real, label, y);
  return {.label = label,
          .windows = static_cast<std::int64_t>(count),
          .mmd = mmd_squared(x, y, squared_distance),
          .rmse = rmse(x, y),
          .aligned_rmse = aligned_rmse(x, y),
          .amplitude_ratio = amplitude_ratio(x, y),
          .spectral_distance_db = spectral_distance_db(x, y),
          .fault_line_db = line_db,
          .fault_line_difference_db = line_db - real_line_db};
}

}  // namespace

bool has_line(const signal::DatasetInfo& info, Label label) {
  return bearing::causes_impacts(info.class_of(label).defect);
}

std::span<const Metric> all_metrics() { return metrics; }

std::vector<ClassQuality> quality_by_class(const signal::WindowSet& generated,
                                           const signal::WindowSet& real) {
  require_comparable(generated, real);
  std::vector<ClassQuality> classes;
  for (const Label label : real.info.labels()) {
    if (real.count_of(label) + generated.count_of(label) == 0) continue;
    classes.push_back(quality_of(generated, real, label));
  }
  return classes;
}

}  // namespace piae::scoring
