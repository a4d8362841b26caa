#include "monitor/samples.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "base/error.hpp"

namespace piae::monitor {

namespace {

static_assert(std::endian::native == std::endian::little,
              "WAV and f32be are read only on such machines");

template <class T, bool swapped = false>
T value_at(const void* from) {
  std::array<unsigned char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), from, sizeof(T));
  if constexpr (swapped) std::ranges::reverse(bytes);
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

/// Returns the value of three bytes, lowest first.
std::int32_t value_of_24_bits(const void* from) {
  std::array<unsigned char, 4> bytes{};
  std::memcpy(bytes.data() + 1, from, 3);
  std::int32_t value = 0;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value / 256;
}

/// True if a vibration may have this value, in any unit. Holds for a third of random bytes.
bool is_plausible(double x) {
  constexpr double least = 1e-12;
  constexpr double most = 1e12;
  return x == 0 || (std::abs(x) >= least && std::abs(x) <= most);
}

template <class T, bool swapped = false>
std::vector<double> values_in(std::string_view bytes) {
  std::vector<double> values;
  for (; bytes.size() >= sizeof(T); bytes.remove_prefix(sizeof(T))) {
    values.push_back(static_cast<double>(value_at<T, swapped>(bytes.data())));
  }
  return values;
}

double share_of_plausible(const std::vector<double>& values) {
  const auto count = std::ranges::count_if(values, is_plausible);
  return values.empty() ? 0 : static_cast<double>(count) / static_cast<double>(values.size());
}

/// Returns the share of values below a quarter of the range, which recordings in integers rarely
/// exceed; three quarters of random values do. Returns 0 if the values do not vary.
double share_of_small(const std::vector<double>& values, double range) {
  const auto count =
      std::ranges::count_if(values, [&](double x) { return std::abs(x) < range / 4; });
  const bool varies = !values.empty() && std::ranges::min(values) < std::ranges::max(values);
  return varies ? static_cast<double>(count) / static_cast<double>(values.size()) : 0;
}

/// True if every other value is 0, as when floats are read from doubles with few digits.
bool has_zeros_in_turn(const std::vector<double>& values) {
  std::size_t even = 0;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0) ++(i % 2 == 0 ? even : odd);
  }
  const auto [few, many] = std::minmax(even, odd);
  return many > 10 && many >= values.size() / 2 && few < many / 2;
}

/// True if each value seems to be two samples of 16 bits: both halves vary and are small. The low
/// half of a larger whole number fills its range, and the high half of a small one is 0 or -1.
bool has_two_samples_each(std::string_view bytes) {
  std::array<std::vector<double>, 2> halves;  // low, high
  const std::vector<double> all = values_in<std::int16_t>(bytes);
  for (std::size_t i = 0; i < all.size(); ++i) halves.at(i % 2).push_back(all[i]);
  constexpr double nearly_all = 0.99;
  const auto are_samples = [](const std::vector<double>& half) {
    return share_of_small(half, std::ldexp(1, 15)) >= nearly_all &&
           (std::ranges::min(half) < -1 || std::ranges::max(half) > 0);
  };
  return std::ranges::all_of(halves, are_samples);
}

/// Returns the share of values that vibration may have if the bytes are in this format.
double share_that_fits(SampleFormat format, std::string_view bytes) {
  switch (format) {
    case SampleFormat::f32:
    case SampleFormat::f32be: {
      const auto values =
          format == SampleFormat::f32 ? values_in<float>(bytes) : values_in<float, true>(bytes);
      return has_zeros_in_turn(values) ? 0 : share_of_plausible(values);
    }
    case SampleFormat::f64:
      return share_of_plausible(values_in<double>(bytes));
    case SampleFormat::f64be:
      return share_of_plausible(values_in<double, true>(bytes));
    case SampleFormat::i16:
      return share_of_small(values_in<std::int16_t>(bytes), std::ldexp(1, 15));
    case SampleFormat::i32:
      if (has_two_samples_each(bytes)) return 0;
      return share_of_small(values_in<std::int32_t>(bytes), std::ldexp(1, 31));
    case SampleFormat::wav:
    case SampleFormat::text:
      return 0;
  }
  return 0;
}

}  // namespace

std::vector<cli::Word<SampleFormat>> sample_format_words() {
  return {{"f32", SampleFormat::f32},     {"f64", SampleFormat::f64},
          {"f32be", SampleFormat::f32be}, {"f64be", SampleFormat::f64be},
          {"i16", SampleFormat::i16},     {"i32", SampleFormat::i32},
          {"wav", SampleFormat::wav},     {"text", SampleFormat::text}};
}

/// Reads whole samples of `size` bytes, and keeps the bytes of an incomplete sample.
template <std::size_t size, class Read>
void SampleDecoder::add_binary(std::span<const std::byte> bytes, const Read& read) {
  const auto keep = [&](std::size_t count) {
    waiting_.append(reinterpret_cast<const char*>(bytes.data()), count);
    bytes = bytes.subspan(count);
  };
  if (!waiting_.empty()) {
    keep(std::min(size - waiting_.size(), bytes.size()));
    if (waiting_.size() < size) return;
    read(waiting_.data());
    waiting_.clear();
  }
  for (; bytes.size() >= size; bytes = bytes.subspan(size)) read(bytes.data());
  keep(bytes.size());
}

template <class T, bool swapped>
void SampleDecoder::add_values(std::span<const std::byte> bytes, std::vector<double>& samples) {
  add_binary<sizeof(T)>(bytes, [&](const void* from) {
    samples.push_back(static_cast<double>(value_at<T, swapped>(from)));
  });
}

void SampleDecoder::add_wav(std::span<const std::byte> bytes, std::vector<double>& samples) {
  const auto whole = [&](auto value, unsigned bits) {
    samples.push_back(std::ldexp(static_cast<double>(value), 1 - static_cast<int>(bits)));
  };
  while (!bytes.empty()) {
    const std::span<const std::byte> part = wav_.next(bytes);
    const unsigned bits = wav_.coding().bits;
    if (part.empty()) return;
    if (wav_.coding().is_float && bits == 32) {
      add_values<float>(part, samples);
    } else if (wav_.coding().is_float) {
      add_values<double>(part, samples);
    } else if (bits == 16) {
      add_binary<2>(part, [&](const void* from) { whole(value_at<std::int16_t>(from), bits); });
    } else if (bits == 24) {
      add_binary<3>(part, [&](const void* from) { whole(value_of_24_bits(from), bits); });
    } else {
      add_binary<4>(part, [&](const void* from) { whole(value_at<std::int32_t>(from), bits); });
    }
  }
}

void SampleDecoder::add(std::span<const std::byte> bytes, std::vector<double>& samples) {
  const std::size_t more = std::min<std::size_t>(shown_bytes - beginning_.size(), bytes.size());
  beginning_.append(reinterpret_cast<const char*>(bytes.data()), more);
  if (more > 0) require_binary();
  note_recent(bytes);
  switch (format_) {
    case SampleFormat::f32:
      return add_values<float>(bytes, samples);
    case SampleFormat::f64:
      return add_values<double>(bytes, samples);
    case SampleFormat::f32be:
      return add_values<float, true>(bytes, samples);
    case SampleFormat::f64be:
      return add_values<double, true>(bytes, samples);
    case SampleFormat::i16:
      return add_values<std::int16_t>(bytes, samples);
    case SampleFormat::i32:
      return add_values<std::int32_t>(bytes, samples);
    case SampleFormat::wav:
      return add_wav(bytes, samples);
    case SampleFormat::text:
      return text_.add(bytes, samples);
  }
}

/// Keeps the last bytes of the stream, starting where samples of any size start.
void SampleDecoder::note_recent(std::span<const std::byte> bytes) {
  constexpr std::size_t enough = 1 << 16;
  for (; !bytes.empty();) {
    if (recent_.size() == 2 * enough) recent_.erase(0, enough);
    const auto some = bytes.first(std::min(bytes.size(), 2 * enough - recent_.size()));
    recent_.append(reinterpret_cast<const char*>(some.data()), some.size());
    bytes = bytes.subspan(some.size());
  }
}

void SampleDecoder::require_binary() const {
  if (beginning_.starts_with("\x93NUMPY")) {
    throw Error(Exit::bad_input,
                name_ +
                    ": begins like a NumPy file; pipe in only its samples: python3 -c "
                    "\"import numpy, sys; sys.stdout.buffer.write(numpy.load('FILE').astype('<f4')."
                    "tobytes())\"");
  }
  if (format_ == SampleFormat::text || format_ == SampleFormat::wav) return;
  // Binary samples almost never consist of these bytes alone.
  const bool is_text =
      beginning_.find_first_not_of("0123456789+-.,;eE \t\r\n") == std::string::npos;
  if (beginning_.size() < shown_bytes || !is_text) return;
  throw Error(Exit::bad_input,
              name_ + ": begins like text, not like binary samples; is it --format text?");
}

void SampleDecoder::finish(std::vector<double>& samples) { text_.finish(samples); }

void SampleDecoder::restart() {
  waiting_.clear();
  beginning_.clear();
  recent_.clear();
  text_.restart();
  wav_.restart();
}

std::string SampleDecoder::likelier_format() const {
  constexpr double nearly_all = 0.99;
  constexpr double too_few = 0.9;
  if (format_ == SampleFormat::text || format_ == SampleFormat::wav) return "";
  if (beginning_.starts_with("RIFF")) return "wav";
  if (share_that_fits(format_, recent_) > too_few) return "";
  for (const auto& [name, format] : sample_format_words()) {
    if (share_that_fits(format, recent_) >= nearly_all) return name;
  }
  return "";
}

}  // namespace piae::monitor
