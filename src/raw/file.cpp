#include "raw/file.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "raw/format.hpp"
#include "raw/times.hpp"

namespace piae::raw {

namespace {

/// Refuses even times in a declared unit that contradict the sample rate.
void require_agreeing_times(const std::filesystem::path& file, const Times& times,
                            double sample_rate_hz) {
  if (times.unit_s == 0 || times.step == 0) return;
  const auto other = contradicting_rate(times, sample_rate_hz);
  if (!other) return;
  refuse_file(
      file,
      fmt::format("is sampled at {:.5g} Hz by the times in column {}, which step by {:.5g} s, not "
                  "at {:g} Hz; correct its sample_rate_hz, or the unit in the name of that column",
                  other->hz, times.column, times.step * times.unit_s, sample_rate_hz));
}

}  // namespace

Signal signal_here(const std::filesystem::path& file, const std::string& variable,
                   std::optional<double> sample_rate_hz) {
  Signal signal = reader_of(file)(file, variable);
  const double own_hz = signal.sample_rate_hz.value_or(0);
  const bool differs =
      sample_rate_hz && own_hz > 0 && std::abs(own_hz / *sample_rate_hz - 1) > 1e-3;
  if (differs) {
    refuse_file(
        file,
        fmt::format("declares a sample rate of {:g} Hz, not {:g} Hz; correct its sample_rate_hz",
                    own_hz, *sample_rate_hz));
  }
  if (sample_rate_hz) require_agreeing_times(file, signal.times, *sample_rate_hz);
  if (signal.samples.empty()) refuse_file(file, variable + " holds no sample");
  if (signal.samples.size() == 1) {
    refuse_file(
        file,
        fmt::format("{} holds only one number, {:g}; name the variable that holds the samples",
                    variable, signal.samples.front()));
  }
  return signal;
}

std::vector<double> read_here(const std::filesystem::path& file, const std::string& variable,
                              std::optional<double> sample_rate_hz) {
  return signal_here(file, variable, sample_rate_hz).samples;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  constexpr std::size_t longest = 80;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    list += (list.empty() ? "" : ", ") + names[i].substr(0, longest);
  }
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " more";
  return list.empty() ? "none" : list;
}

void refuse_file(const std::filesystem::path& where, const std::string& what) {
  throw Error(Exit::bad_input, one_line(where.string() + ": " + what));
}

}  // namespace piae::raw
