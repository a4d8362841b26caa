#include "monitor/samples.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.hpp"

namespace piae::monitor {

namespace {

static_assert(std::endian::native == std::endian::little,
              "WAV and f32be are read for such machines");

template <class T, bool swapped = false>
T value_at(const void* from) {
  std::array<unsigned char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), from, sizeof(T));
  if constexpr (swapped) std::ranges::reverse(bytes);
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

/// Three bytes, the lowest first.
std::int32_t value_of_24_bits(const void* from) {
  std::array<unsigned char, 4> bytes{};
  std::memcpy(bytes.data() + 1, from, 3);
  std::int32_t value = 0;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value / 256;
}

/// True if a vibration has samples of this size, in any unit. A third of random bytes do.
bool is_plausible(double x) {
  constexpr double least = 1e-12;
  constexpr double most = 1e12;
  return x == 0 || (std::abs(x) >= least && std::abs(x) <= most);
}

}  // namespace

std::vector<cli::Word<SampleFormat>> sample_format_words() {
  return {{"f32", SampleFormat::f32},     {"f64", SampleFormat::f64},
          {"f32be", SampleFormat::f32be}, {"f64be", SampleFormat::f64be},
          {"i16", SampleFormat::i16},     {"i32", SampleFormat::i32},
          {"wav", SampleFormat::wav},     {"text", SampleFormat::text}};
}

/// Reads whole samples of so many bytes, and keeps those of a sample that is not whole.
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
void SampleDecoder::add_floats(std::span<const std::byte> bytes, std::vector<double>& samples) {
  add_binary<sizeof(T)>(bytes, [&](const void* from) {
    const auto value = static_cast<double>(value_at<T, swapped>(from));
    ++floats_;
    plausible_ += is_plausible(value) ? 1 : 0;
    plausible_swapped_ += is_plausible(static_cast<double>(value_at<T, !swapped>(from))) ? 1 : 0;
    samples.push_back(value);
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
      add_floats<float, false>(part, samples);
    } else if (wav_.coding().is_float) {
      add_floats<double, false>(part, samples);
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
  const auto add_whole = [&]<class T>(T) {
    add_binary<sizeof(T)>(bytes, [&](const void* from) {
      samples.push_back(static_cast<double>(value_at<T>(from)));
    });
  };
  switch (format_) {
    case SampleFormat::f32:
      return add_floats<float, false>(bytes, samples);
    case SampleFormat::f64:
      return add_floats<double, false>(bytes, samples);
    case SampleFormat::f32be:
      return add_floats<float, true>(bytes, samples);
    case SampleFormat::f64be:
      return add_floats<double, true>(bytes, samples);
    case SampleFormat::i16:
      return add_whole(std::int16_t{});
    case SampleFormat::i32:
      return add_whole(std::int32_t{});
    case SampleFormat::wav:
      return add_wav(bytes, samples);
    case SampleFormat::text:
      return text_.add(bytes, samples);
  }
}

void SampleDecoder::require_binary() const {
  if (format_ == SampleFormat::text || format_ == SampleFormat::wav) return;
  // Samples in binary form would hardly all have such bytes.
  const bool is_text =
      beginning_.find_first_not_of("0123456789+-.,;eE \t\r\n") == std::string::npos;
  if (beginning_.size() < shown_bytes || !is_text) return;
  throw Error(Exit::bad_input, name_ +
                                   ": begins like text, not like samples in binary form; is it "
                                   "--format text?");
}

void SampleDecoder::finish(std::vector<double>& samples) { text_.finish(samples); }

void SampleDecoder::restart() {
  waiting_.clear();
  beginning_.clear();
  text_.restart();
  wav_.restart();
}

std::string SampleDecoder::likelier_format() const {
  constexpr double nearly_all = 0.99;
  constexpr double too_few = 0.9;
  const auto all = static_cast<double>(floats_);
  if (floats_ == 0 || static_cast<double>(plausible_) > too_few * all) return "";
  if (beginning_.starts_with("RIFF") && format_ != SampleFormat::wav) return "wav";
  if (static_cast<double>(plausible_swapped_) < nearly_all * all) return "";
  switch (format_) {
    case SampleFormat::f32:
      return "f32be";
    case SampleFormat::f64:
      return "f64be";
    case SampleFormat::f32be:
      return "f32";
    case SampleFormat::f64be:
      return "f64";
    default:
      return "";
  }
}

}  // namespace piae::monitor
