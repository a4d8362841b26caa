#include "signal/split.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "base/error.hpp"
#include "base/random.hpp"
#include "signal/amplitude.hpp"
#include "signal/stride.hpp"

namespace piae::signal {

namespace {

/// Where a window is cut.
struct Place {
  std::size_t record;  ///< index into Recordings::records
  std::size_t first_sample;
};

/// A role, and how many windows of a class it gets.
struct Share {
  Role role;
  std::size_t count;
};

[[noreturn]] void refuse_options(const std::string& what) { throw Error(Exit::usage, what); }

void require_sensible(const SplitOptions& options) {
  if (options.window == 0 || options.max_stride == 0 || options.test_per_class == 0 ||
      options.known_per_class == 0 || options.guard_windows == 0) {
    refuse_options(
        "window, max-stride, test-per-class, known-per-class and guard-windows must be "
        "at least 1");
  }
  if (options.windows_per_class <= options.test_per_class + options.known_per_class) {
    refuse_options("windows-per-class (" + std::to_string(options.windows_per_class) +
                   ") must exceed test-per-class plus known-per-class (" +
                   std::to_string(options.test_per_class) + " + " +
                   std::to_string(options.known_per_class) + ")");
  }
  if (options.seed < 0) refuse_options("seed must not be negative");
}

void require_a_fault_class(const DatasetInfo& info) {
  (void)info.healthy_label();
  if (info.classes.size() < 2) {
    throw Error(Exit::bad_input, "dataset " + info.name + ": has no fault class");
  }
}

/// What the windows of a class are dealt out to, in this order. It is the order in time, too, where
/// the protocol is blocked.
std::vector<Share> shares_of(bool healthy, const SplitOptions& options) {
  const std::size_t rest = options.windows_per_class - options.test_per_class;
  if (healthy) return {{Role::test, options.test_per_class}, {Role::healthy, rest}};
  return {{Role::test, options.test_per_class},
          {Role::known, options.known_per_class},
          {Role::hidden, rest - options.known_per_class}};
}

std::vector<std::size_t> records_of(const Recordings& recordings, Label label) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < recordings.records.size(); ++i) {
    if (recordings.records[i].label == label) indices.push_back(i);
  }
  return indices;
}

std::vector<std::size_t> lengths_of(const Recordings& recordings,
                                    const std::vector<std::size_t>& indices) {
  std::vector<std::size_t> lengths;
  lengths.reserve(indices.size());
  for (const std::size_t i : indices) lengths.push_back(recordings.records[i].signal.size());
  return lengths;
}

/// Where the class's windows start, in time order, record by record.
std::vector<Place> places_of(const Recordings& recordings, const std::vector<std::size_t>& records,
                             const WindowGrid& grid, std::size_t stride) {
  std::vector<Place> places;
  for (const std::size_t i : records) {
    const std::size_t count = windows_in(recordings.records[i].signal.size(), grid.window, stride);
    for (std::size_t k = 0; k < count; ++k) places.push_back({i, k * stride});
  }
  return places;
}

/// The order in which a class's windows are dealt out.
std::vector<std::size_t> order_of(std::size_t count, Protocol protocol, Stream& stream) {
  if (protocol == Protocol::random) return stream.permutation(count);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(stream.below(count));
  std::rotate(order.begin(), first, order.end());
  return order;
}

WindowGrid grid_of(const SplitOptions& options, std::size_t blocks) {
  const bool blocked = options.protocol == Protocol::blocked;
  return {.window = options.window,
          .max_stride = options.max_stride,
          .windows = options.windows_per_class,
          .blocks = blocked ? blocks : 0,
          .guard = options.guard_windows * options.window};
}

/// Appends the window at a place to a set whose record_names are those of all recordings.
void cut(WindowSet& set, const Record& record, const Place& place, bool with_parameters) {
  const auto first = record.signal.begin() + static_cast<std::ptrdiff_t>(place.first_sample);
  std::transform(first, first + static_cast<std::ptrdiff_t>(set.length),
                 std::back_inserter(set.samples), [](double x) { return static_cast<float>(x); });
  if (is_constant(std::span(set.samples).last(set.length))) {
    throw Error(Exit::bad_input, "record " + record.name + " of " + set.info.name +
                                     ": nothing moves in the window "
                                     "from sample " +
                                     std::to_string(place.first_sample) +
                                     " on; leave that part of the recording out");
  }
  set.labels.push_back(record.label);
  set.record.push_back(static_cast<std::int32_t>(place.record));
  set.first_sample.push_back(static_cast<std::int64_t>(place.first_sample));
  if (with_parameters) set.parameters.push_back(*record.parameters);
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

void split_class(const Recordings& recordings, Label label, const SplitOptions& options,
                 bool with_parameters, Split& out) {
  const DatasetInfo& info = recordings.info;
  const std::string& name = info.class_of(label).name;
  const auto shares = shares_of(label == info.healthy_label(), options);
  const auto records = records_of(recordings, label);
  const WindowGrid grid = grid_of(options, shares.size());
  const std::size_t stride = largest_stride("dataset " + info.name + ", class " + name,
                                            lengths_of(recordings, records), grid);
  const auto places = places_of(recordings, records, grid, stride);
  Stream stream(info.name + "/seed" + std::to_string(options.seed) + "/split/" + name);
  const auto order = order_of(places.size(), options.protocol, stream);
  const std::size_t skipped = grid.blocks > 0 ? skipped_windows(grid, stride) : 0;
  std::size_t next = 0;
  for (const Share& share : shares) {
    for (std::size_t i = 0; i < share.count; ++i) {
      const Place& place = places[order[next + i]];
      cut(out.of(share.role), recordings.records[place.record], place, with_parameters);
    }
    next += share.count + skipped;
  }
  out.strides.push_back(static_cast<std::int64_t>(stride));
}

}  // namespace

void bind(const cli::Options& command, SplitOptions& options) {
  constexpr std::int64_t most = 1000000000;
  command.add("--seed", options.seed, "The repeat: each seed has its own split")
      .required()
      .check(cli::whole_number(0, most));
  command.choose("--protocol", options.protocol, protocol_words(),
                 "random: the paper's; blocked: contiguous blocks with a guard gap");
  const auto count = [&](const char* name, std::size_t& value, const char* help) {
    command.add(name, value, help).check(cli::whole_number(1, most));
  };
  count("--window", options.window, "Samples in a window");
  count("--max-stride", options.max_stride,
        "Samples between two windows at most; less where the windows need it");
  count("--windows-per-class", options.windows_per_class, "Windows cut of each class");
  count("--test-per-class", options.test_per_class, "Windows of each class in A (test)");
  count("--known-per-class", options.known_per_class, "Windows of each fault class in C (known)");
  count("--guard-windows", options.guard_windows,
        "Window lengths left unused between two roles (blocked only)");
}

Split split(const Recordings& recordings, const SplitOptions& options) {
  require_sensible(options);
  require_a_fault_class(recordings.info);
  const bool with_parameters = std::ranges::all_of(
      recordings.records, [](const Record& record) { return record.parameters.has_value(); });
  Split out = empty_split(recordings, options);
  for (const Label label : recordings.info.labels()) {
    split_class(recordings, label, options, with_parameters, out);
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
