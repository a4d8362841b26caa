#include "inspection/time_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "base/error.hpp"
#include "raw/file.hpp"
#include "spectra/floors.hpp"

namespace piae::inspection {

namespace {

constexpr double regular_share = 0.9;
constexpr double regular_within = 0.25;  // of the median step, on either side
constexpr double steps_of_a_gap = 1.5;
constexpr std::size_t fewest_times = 20;

/// False for all binary formats: their first bytes hold a zero.
bool may_be_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 256> bytes{};
  in.read(bytes.data(), bytes.size());
  const std::string_view beginning(bytes.data(), static_cast<std::size_t>(in.gcount()));
  return beginning.find('\0') == std::string_view::npos;
}

}  // namespace

Dropouts dropouts_in(std::span<const double> times) {
  if (times.size() < fewest_times) return {};
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  if (std::ranges::any_of(steps, [](double step) { return step <= 0; })) return {};
  const double median = spectra::median(steps);
  double sum = 0;
  double regular = 0;
  for (const double step : steps) {
    if (std::abs(step - median) > regular_within * median) continue;
    sum += step;
    ++regular;
  }
  if (regular < regular_share * static_cast<double>(steps.size())) return {};
  const double usual = sum / regular;  // the median is rounded as the times are printed
  Dropouts found;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] <= steps_of_a_gap * usual) continue;
    const auto missing = static_cast<std::size_t>(std::round(steps[i] / usual)) - 1;
    ++found.gaps;
    found.missing += missing;
    if (missing <= found.longest) continue;
    found.longest = missing;
    found.longest_after = i;
  }
  return found;
}

Dropouts dropouts_of(const std::vector<std::filesystem::path>& files, const std::string& variable) {
  const std::string first_column = "1";
  if (variable == first_column || !may_be_text(files.front())) return {};
  Dropouts all;
  try {
    std::size_t samples = 0;  // in the files before
    raw::Signals signals = raw::read_all(files, first_column);
    std::span<const double> rest = signals.samples;
    for (const raw::Piece& piece : signals.pieces) {
      const auto times = rest.first(piece.samples);
      rest = rest.subspan(piece.samples);
      const Dropouts found = dropouts_in(times);
      all.gaps += found.gaps;
      all.missing += found.missing;
      if (found.longest > all.longest) {
        all.longest = found.longest;
        all.longest_after = samples + found.longest_after;
      }
      samples += times.size();
    }
  } catch (const Error&) {
    return {};  // such as a column of dates: the signal itself was read
  }
  return all;
}

}  // namespace piae::inspection
