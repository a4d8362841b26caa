#include "signal/amplitude.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

double mean_of(std::span<const float> window) {
  double sum = 0;
  for (const float x : window) sum += x;
  return sum / static_cast<double>(window.size());
}

double rms_of(std::span<const double> signal) {
  const auto n = static_cast<double>(signal.size());
  const double mean = std::accumulate(signal.begin(), signal.end(), 0.0) / n;
  double squares = 0;
  for (const double x : signal) squares += (x - mean) * (x - mean);
  return std::sqrt(squares / n);
}

bool is_constant(std::span<const float> window) {
  return std::ranges::all_of(window, [&](float x) { return x == window.front(); });
}

namespace {

/// Returns for each class the summary of its windows' samples, each window about its mean.
template <class Summary>
std::vector<double> by_class(const WindowSet& windows) {
  std::vector<double> all;
  for (const Label label : windows.info.labels()) {
    const std::vector<std::size_t> members = windows.indices_of(label);
    Summary summary;
    for (const std::size_t i : members) {
      const double mean = mean_of(windows.window(i));
      for (const float x : windows.window(i)) summary.add(x - mean);
    }
    const double value = members.empty() ? 1 : summary.value(members.size() * windows.length);
    if (!(value > 0)) {
      throw Error(
          Exit::bad_input,
          "class " + windows.info.class_of(label).name +
              ": its known windows are constant; the channel is dead: name another variable");
    }
    all.push_back(value);
  }
  return all;
}

class Rms {
 public:
  void add(double x) { squares_ += x * x; }
  [[nodiscard]] double value(std::size_t samples) const {
    return std::sqrt(squares_ / static_cast<double>(samples));
  }

 private:
  double squares_ = 0;
};

class Peak {
 public:
  void add(double x) { largest_ = std::max(largest_, std::abs(x)); }
  [[nodiscard]] double value(std::size_t /*samples*/) const { return largest_; }

 private:
  double largest_ = 0;
};

}  // namespace

std::vector<double> rms_by_class(const WindowSet& windows) { return by_class<Rms>(windows); }

std::vector<double> peak_by_class(const WindowSet& windows) { return by_class<Peak>(windows); }

std::vector<double> read_amplitudes(const artefact::Reader& reader, const std::string& path,
                                    const DatasetInfo& info) {
  std::vector<double> amplitudes = reader.numbers<double>(path, {info.classes.size()}).values;
  reader.require_all(path, amplitudes, ranges::amplitude);
  return amplitudes;
}

}  // namespace piae::signal
