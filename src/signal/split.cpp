#include "signal/split.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <stdexcept>

#include "base/error.hpp"
#include "base/random.hpp"
#include "signal/amplitude.hpp"
#include "signal/sources.hpp"
#include "signal/stride.hpp"

namespace piae::signal {

namespace {

/// Start of a window.
struct Place {
  std::size_t record;  ///< index into Recordings::records
  std::size_t first_sample;
};

/// A count that is both an option and a setting of a description.
struct Setting {
  const char* name;
  std::size_t SplitOptions::*value;
  const char* help;
  std::int64_t least = 1;
};
constexpr std::int64_t most_of_a_setting = 1000000000;
constexpr Setting settings[] = {
    {"window", &SplitOptions::window, "Samples in a window"},
    {"max-stride", &SplitOptions::max_stride,
     "Largest distance between window starts, samples; smaller if the windows need it"},
    {"windows-per-class", &SplitOptions::windows_per_class, "Windows cut from each class"},
    {"test-per-class", &SplitOptions::test_per_class, "Windows of each class in A (test)"},
    {known_per_class, &SplitOptions::known_per_class,
     "Windows of each fault class in C (known); 0 if no fault is known", 0},
    {"guard-windows", &SplitOptions::guard_windows,
     "Window lengths left unused between two roles (blocked only)"},
};

[[noreturn]] void refuse_options(const std::string& what) { throw Error(Exit::usage, what); }

void require_a_fault_class(const DatasetInfo& info) {
  (void)info.healthy_label();
  if (info.classes.size() < 2) {
    throw Error(Exit::bad_input, "data set " + info.name + ": has no fault class");
  }
}

std::vector<RecordPlace> places_of(const Recordings& recordings) {
  std::vector<RecordPlace> places;
  for (const Record& record : recordings.records) {
    places.push_back({.label = record.label,
                      .condition = record.condition,
                      .shaft_speed_rpm = record.shaft_speed_rpm});
  }
  return places;
}

/// Returns the lengths of the stretches that no window crosses: records, or pieces of records.
std::vector<std::size_t> lengths_of(const Recordings& recordings,
                                    const std::vector<std::size_t>& indices) {
  std::vector<std::size_t> lengths;
  for (const std::size_t i : indices) {
    std::ranges::copy(recordings.records[i].piece_lengths(), std::back_inserter(lengths));
  }
  return lengths;
}

/// Returns the starts of a source's windows, in time order, record by record.
std::vector<Place> places_of(const Recordings& recordings, const std::vector<std::size_t>& records,
                             const WindowGrid& grid, std::size_t stride) {
  std::vector<Place> places;
  for (const std::size_t i : records) {
    std::size_t first = 0;
    for (const std::size_t length : recordings.records[i].piece_lengths()) {
      const std::size_t count = windows_in(length, grid.window, stride);
      for (std::size_t k = 0; k < count; ++k) places.push_back({i, first + k * stride});
      first += length;
    }
  }
  return places;
}

/// Returns the order in which the windows of a source are assigned.
std::vector<std::size_t> order_of(std::size_t count, Protocol protocol, Stream& stream) {
  if (protocol == Protocol::random) return stream.permutation(count);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(stream.below(count));
  std::rotate(order.begin(), first, order.end());
  return order;
}

WindowGrid grid_of(const SplitOptions& options, const Source& source) {
  const bool blocked = options.protocol == Protocol::blocked;
  return {.window = options.window,
          .max_stride = options.max_stride,
          .windows = source.windows(),
          .blocks = blocked ? source.shares.size() : 0,
          .guard = options.guard_windows * options.window};
}

/// Appends the window at a place, with the data of its record, to a set whose record_names are
/// those of all recordings.
void cut(WindowSet& set, const Recordings& recordings, const Place& place) {
  const Record& record = recordings.records[place.record];
  const auto first = record.signal.begin() + static_cast<std::ptrdiff_t>(place.first_sample);
  std::transform(first, first + static_cast<std::ptrdiff_t>(set.length),
                 std::back_inserter(set.samples), [](double x) { return static_cast<float>(x); });
  if (is_constant(std::span(set.samples).last(set.length))) {
    throw Error(Exit::bad_input, "record " + record.name + " of " + set.info.name +
                                     ": the signal is constant in the window from sample " +
                                     std::to_string(place.first_sample) +
                                     "; remove that part of the recording");
  }
  set.labels.push_back(record.label);
  set.record.push_back(static_cast<std::int32_t>(place.record));
  set.first_sample.push_back(static_cast<std::int64_t>(place.first_sample));
  if (recordings.have_parameters()) set.parameters.push_back(*record.parameters);
  const bool has_conditions = !set.info.conditions.empty();
  if (has_conditions || recordings.have_speeds()) {
    set.shaft_speed_rpm.push_back(
        record.speed_rpm(place.first_sample, set.length, set.info.sample_rate_hz));
  }
  if (!has_conditions) return;
  set.condition.push_back(record.condition);
  if (recordings.have_sizes()) {
    set.defect_size_mm.push_back(
        record.defect_size_mm.value_or(set.info.class_of(record.label).defect_size_mm));
  }
}

Split empty_split(const Recordings& recordings, const SplitOptions& options) {
  WindowSet set;
  set.info = recordings.info;
  set.length = options.window;
  for (const Record& record : recordings.records) set.record_names.push_back(record.name);
  Split split;
  split.sets.fill(set);
  return split;
}

/// Returns the random stream of a source.
Stream stream_of(const Stream& of_class, const DatasetInfo& info, const Source& source) {
  if (source.shaft_speed_rpm) return of_class.child(speed_label(*source.shaft_speed_rpm));
  if (source.condition == every_condition) return of_class;
  return of_class.child(info.conditions[static_cast<std::size_t>(source.condition)].name);
}

/// Assigns the windows of one source to roles, and returns their stride.
std::size_t split_source(const Recordings& recordings, Label label, const Source& source,
                         const SplitOptions& options, Stream stream, Split& out) {
  const WindowGrid grid = grid_of(options, source);
  const std::size_t stride = largest_stride(name_of(recordings.info, label, source),
                                            lengths_of(recordings, source.records), grid);
  const auto places = places_of(recordings, source.records, grid, stride);
  const auto order = order_of(places.size(), options.protocol, stream);
  const std::size_t skipped = grid.blocks > 0 ? skipped_windows(grid, stride) : 0;
  std::size_t next = 0;
  for (const Share& share : source.shares) {
    for (std::size_t i = 0; i < share.count; ++i) {
      cut(out.of(share.role), recordings, places[order[next + i]]);
    }
    next += share.count + skipped;
  }
  return stride;
}

void split_class(const Recordings& recordings, Label label, const SplitOptions& options,
                 Split& out) {
  const DatasetInfo& info = recordings.info;
  const Stream stream(info.name + "/seed" + std::to_string(options.seed) + "/split/" +
                      info.class_of(label).name);
  std::size_t least = options.max_stride;
  for (const Source& source :
       sources_of(info, label, places_of(recordings), counts_of(options), stream)) {
    const Stream own = stream_of(stream, info, source);
    least = std::min(least, split_source(recordings, label, source, options, own, out));
  }
  out.strides.push_back(static_cast<std::int64_t>(least));
}

}  // namespace

void bind(const cli::Options& command, SplitOptions& options) {
  command.add("--seed", options.seed, "Number of the repeat; each seed has its own split")
      .required()
      .check(cli::whole_number(0, most_of_a_setting));
  command.choose("--protocol", options.protocol, protocol_words(),
                 "random, as in the paper; or blocked: contiguous blocks with a guard gap");
  for (const Setting& setting : settings) {
    command.add(std::string("--") + setting.name, options.*setting.value, setting.help)
        .check(cli::whole_number(setting.least, most_of_a_setting));
  }
}

std::vector<SplitSetting> split_settings() {
  std::vector<SplitSetting> list;
  for (const Setting& setting : settings) {
    list.push_back({.name = setting.name,
                    .range = {.low = static_cast<double>(setting.least),
                              .high = static_cast<double>(most_of_a_setting)}});
  }
  return list;
}

void set(SplitOptions& options, const std::string& name, std::size_t value) {
  const auto* const setting = std::ranges::find(settings, name, &Setting::name);
  if (setting == std::end(settings)) throw std::logic_error("split has no setting " + name);
  options.*(setting->value) = value;
}

void require_sensible(const SplitOptions& options) {
  if (options.window == 0 || options.max_stride == 0 || options.test_per_class == 0 ||
      options.guard_windows == 0) {
    refuse_options("window, max-stride, test-per-class and guard-windows must be at least 1");
  }
  if (options.windows_per_class <= options.test_per_class + options.known_per_class) {
    refuse_options("windows-per-class (" + std::to_string(options.windows_per_class) +
                   ") must exceed test-per-class plus known-per-class (" +
                   std::to_string(options.test_per_class) + " + " +
                   std::to_string(options.known_per_class) + ")");
  }
  if (options.seed < 0) refuse_options("seed must not be negative");
}

Counts counts_of(const SplitOptions& options) {
  return {.all = options.windows_per_class,
          .test = options.test_per_class,
          .known = options.known_per_class};
}

Split split(const Recordings& recordings, const SplitOptions& options) {
  require_sensible(options);
  require_a_fault_class(recordings.info);
  Split out = empty_split(recordings, options);
  for (const Label label : recordings.info.labels()) {
    split_class(recordings, label, options, out);
  }
  return out;
}

void write(artefact::Writer& writer, const Split& split, Role role, const SplitOptions& options,
           const std::string& records_digest) {
  write(writer, split.of(role));
  writer.numbers("/classes/stride", split.strides);
  writer.attribute("/", "role", to_string(role));
  writer.attribute("/", "protocol", to_string(options.protocol));
  writer.attribute("/", "seed", options.seed);
  writer.attribute("/", "records_digest", records_digest);
}

}  // namespace piae::signal
