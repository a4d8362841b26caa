#include "diagnosis/training_set.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/label.hpp"
#include "signal/described_conditions.hpp"
#include "symptoms/baseline.hpp"

namespace piae::diagnosis {

namespace {

using signal::WindowSet;

/// Throws Error(bad_input) with the problem of a set and the option that named its file.
[[noreturn]] void refuse(const std::string& option, const std::string& what) {
  throw Error(Exit::bad_input, option + ": " + what);
}

std::string in_quotes(const WindowSet& windows, Label label) {
  return "'" + windows.info.classes[index_of(label)].name + "'";
}

void require_alike(const WindowSet& set, const std::string& option, const WindowSet& other,
                   const std::string& other_option) {
  const auto require_equal = [&](const std::string& what, const std::string& own,
                                 const std::string& others) {
    if (own == others) return;
    refuse(option, what + " " + own + ", but " + other_option + " has " + others +
                       "; give files of one split");
  };
  require_equal("is of data set", set.info.name, other.info.name);
  require_equal("has sample rate (Hz)", std::to_string(set.info.sample_rate_hz),
                std::to_string(other.info.sample_rate_hz));
  require_equal("has windows of length", std::to_string(set.length), std::to_string(other.length));
  require_equal("has the number of classes", std::to_string(set.info.classes.size()),
                std::to_string(other.info.classes.size()));
  for (std::size_t i = 0; i < set.info.classes.size(); ++i) {
    require_equal("has class " + std::to_string(i), set.info.classes[i].name,
                  other.info.classes[i].name);
  }
}

void require_windows_of_class(const WindowSet& set, const std::string& option, Label label,
                              bool belongs) {
  if ((set.count_of(label) > 0) == belongs) return;
  refuse(option, belongs ? "has no window of class " + in_quotes(set, label) +
                               "; give the file that split or "
                               "generate made for this option"
                         : "holds windows of class " + in_quotes(set, label) +
                               ", which do not belong in it; give the file that split or generate "
                               "made for this option");
}

/// Throws if a set lacks a class that it needs, or has one that it must not have.
void require_classes(const WindowSet& set, const std::string& option, bool healthy, bool faults) {
  const Label healthy_label = set.info.healthy_label();
  for (Label label = 0; index_of(label) < set.info.classes.size(); ++label) {
    require_windows_of_class(set, option, label, label == healthy_label ? healthy : faults);
  }
}

void require_enough(const WindowSet& generated, Label label, std::size_t needed) {
  const std::size_t there = generated.count_of(label);
  if (there >= needed) return;
  refuse("--generated", "holds " + std::to_string(there) + " windows of class " +
                            in_quotes(generated, label) + ", but the ratio needs " +
                            std::to_string(needed) + "; generate with --count " +
                            std::to_string(needed) + " or more, or choose another --ratio");
}

/// Returns the shaft speed of generated windows without recorded speeds and parents: the middle of
/// the speeds of B, C and all conditions if these are the same; otherwise NaN.
double unsaid_speed_rpm(const signal::DatasetInfo& info, std::vector<double> speeds) {
  std::ranges::transform(info.conditions, std::back_inserter(speeds),
                         &signal::Condition::shaft_speed_rpm);
  const auto [slowest, fastest] = std::ranges::minmax(speeds);
  return symptoms::is_same_speed(slowest, fastest) ? std::midpoint(slowest, fastest)
                                                   : std::numeric_limits<double>::quiet_NaN();
}

/// Returns the known windows that generated window i was made from: its parents, or all of its
/// class if it does not store any.
std::vector<std::size_t> sources_of(const WindowSet& generated, std::size_t i,
                                    const WindowSet& known) {
  if (generated.parents.empty() || generated.parents[i].empty()) {
    return known.indices_of(generated.labels[i]);
  }
  std::vector<std::size_t> sources;
  for (const std::int32_t parent : generated.parents[i]) {
    sources.push_back(static_cast<std::size_t>(parent));
    if (sources.back() < known.size()) continue;
    refuse("--generated", fmt::format("a window was made from known window {}, but --known holds "
                                      "{} windows; give files of one split",
                                      parent, known.size()));
  }
  return sources;
}

/// Returns the shaft speed of a window made from these known windows: the first one's, or the
/// middle if their speeds differ, but belong to one condition; NaN otherwise.
double speed_of_sources_rpm(const WindowSet& known, const std::vector<std::size_t>& sources) {
  if (sources.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> speeds;
  for (const std::size_t source : sources) speeds.push_back(known.speed_rpm(source));
  const auto [slowest, fastest] = std::ranges::minmax(speeds);
  if (symptoms::is_same_speed(slowest, fastest)) return speeds.front();
  return fastest <= signal::largest_speed_ratio * slowest
             ? std::midpoint(slowest, fastest)
             : std::numeric_limits<double>::quiet_NaN();
}

/// Appends the shaft speed of each window.
void append_speeds(std::vector<double>& speeds, const WindowSet& windows) {
  for (std::size_t i = 0; i < windows.size(); ++i) speeds.push_back(windows.speed_rpm(i));
}

void append_all(WindowSet& training, const WindowSet& set) {
  for (std::size_t i = 0; i < set.size(); ++i) training.append(set, i);
}

void require_enough_of_each(const WindowSet& generated, std::size_t per_class) {
  for (const Label label : generated.info.fault_labels()) {
    require_enough(generated, label, per_class);
  }
}

void require_generated_where_used(const WindowSet* generated, std::int64_t per_class) {
  if (generated == nullptr && per_class > 0) {
    throw Error(Exit::usage, "--generated is missing, but the ratio needs " +
                                 std::to_string(per_class) +
                                 " generated windows for each fault class; give E.h5, or choose "
                                 "--ratio 100to1");
  }
  if (generated != nullptr && per_class == 0) {
    throw Error(Exit::usage,
                "--generated: this ratio does not use generated windows; leave the option out, or "
                "choose another --ratio, such as 10to1");
  }
}

}  // namespace

WindowSet compose_training_set(const WindowSet& normal, const WindowSet& known,
                               const WindowSet* generated, std::int64_t generated_per_class) {
  require_generated_where_used(generated, generated_per_class);
  require_alike(known, "--known", normal, "--normal");
  require_classes(normal, "--normal", /*healthy=*/true, /*faults=*/false);
  if (known.size() > 0) require_classes(known, "--known", /*healthy=*/false, /*faults=*/true);
  WindowSet training = normal;
  std::vector<double> speeds_rpm;
  append_speeds(speeds_rpm, normal);
  append_all(training, known);
  append_speeds(speeds_rpm, known);
  if (generated != nullptr) {
    require_alike(*generated, "--generated", normal, "--normal");
    require_classes(*generated, "--generated", /*healthy=*/false, /*faults=*/true);
    const auto per_class = static_cast<std::size_t>(generated_per_class);
    require_enough_of_each(*generated, per_class);
    const bool silent = generated->shaft_speed_rpm.empty();
    const double unsaid_rpm = unsaid_speed_rpm(normal.info, speeds_rpm);
    for (const std::size_t i : first_of_each_fault(*generated, per_class)) {
      training.append(*generated, i);
      if (!silent) {
        speeds_rpm.push_back(generated->speed_rpm(i));
      } else if (std::isnan(unsaid_rpm)) {
        speeds_rpm.push_back(speed_of_sources_rpm(known, sources_of(*generated, i, known)));
      } else {
        speeds_rpm.push_back(unsaid_rpm);
      }
    }
  }
  training.shaft_speed_rpm = std::move(speeds_rpm);
  return training;
}

std::vector<std::size_t> first_of_each_fault(const WindowSet& generated, std::size_t per_class) {
  std::vector<std::size_t> first;
  for (const Label label : generated.info.fault_labels()) {
    const std::vector<std::size_t> own = generated.indices_of(label);
    const std::size_t count = std::min(per_class, own.size());
    first.insert(first.end(), own.begin(), own.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return first;
}

void require_faults(const WindowSet& training, const Classifier& classifier,
                    const std::string& known_file) {
  if (classifier.rule || training.count_of(training.info.healthy_label()) < training.size()) return;
  const std::vector<std::string> there = rules();
  const std::string cure =
      there.empty() ? "" : fmt::format(", or a rule by --classifier: {}", fmt::join(there, ", "));
  throw Error(
      Exit::bad_input,
      fmt::format("{}: has no known fault windows (known-per-class = 0), and {} cannot learn "
                  "faults without any; give --generated windows of a method that does not "
                  "need known windows{}",
                  known_file, classifier.name, cure));
}

void require_fitting_test_set(const WindowSet& test, const WindowSet& training) {
  require_alike(test, "--test", training, "--normal");
  require_classes(test, "--test", /*healthy=*/true, /*faults=*/true);
}

}  // namespace piae::diagnosis
