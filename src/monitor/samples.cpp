#include "monitor/samples.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace piae::monitor {

namespace {

constexpr std::size_t longest_line = 100;

}  // namespace

std::vector<cli::Word<SampleFormat>> sample_format_words() {
  return {{"f32", SampleFormat::f32},
          {"f64", SampleFormat::f64},
          {"i16", SampleFormat::i16},
          {"i32", SampleFormat::i32},
          {"text", SampleFormat::text}};
}

template <class T>
void SampleDecoder::add_binary(std::span<const std::byte> bytes, std::vector<double>& samples) {
  const auto take = [&](const void* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    samples.push_back(static_cast<double>(value));
  };
  const auto move_to_begun = [&](std::size_t count) {
    begun_.append(reinterpret_cast<const char*>(bytes.data()), count);
    bytes = bytes.subspan(count);
  };
  if (!begun_.empty()) {
    move_to_begun(std::min(sizeof(T) - begun_.size(), bytes.size()));
    if (begun_.size() < sizeof(T)) return;
    take(begun_.data());
    begun_.clear();
  }
  for (; bytes.size() >= sizeof(T); bytes = bytes.subspan(sizeof(T))) take(bytes.data());
  move_to_begun(bytes.size());
}

void SampleDecoder::end_line(std::vector<double>& samples) {
  ++line_;
  const std::size_t first = begun_.find_first_not_of(" \t\r");
  if (first != std::string::npos) {
    const std::size_t last = begun_.find_last_not_of(" \t\r");
    const std::optional<double> value =
        number_in<double>(std::string_view(begun_).substr(first, last + 1 - first));
    if (!value) {
      throw Error(
          Exit::bad_input,
          fmt::format("{}, line {}: '{}' is not a number; a line of --format text holds one "
                      "sample",
                      name_, line_, begun_));
    }
    samples.push_back(*value);
  }
  begun_.clear();
}

void SampleDecoder::add_text(std::span<const std::byte> bytes, std::vector<double>& samples) {
  for (const std::byte byte : bytes) {
    const char c = static_cast<char>(byte);
    if (c == '\n') {
      end_line(samples);
    } else if (begun_.size() < longest_line) {
      begun_ += c;
    } else {
      throw Error(Exit::bad_input,
                  fmt::format("{}, line {}: has more than {} characters: is --format text right?",
                              name_, line_ + 1, longest_line));
    }
  }
}

void SampleDecoder::add(std::span<const std::byte> bytes, std::vector<double>& samples) {
  switch (format_) {
    case SampleFormat::f32:
      return add_binary<float>(bytes, samples);
    case SampleFormat::f64:
      return add_binary<double>(bytes, samples);
    case SampleFormat::i16:
      return add_binary<std::int16_t>(bytes, samples);
    case SampleFormat::i32:
      return add_binary<std::int32_t>(bytes, samples);
    case SampleFormat::text:
      return add_text(bytes, samples);
  }
}

void SampleDecoder::finish(std::vector<double>& samples) {
  if (format_ == SampleFormat::text && !begun_.empty()) end_line(samples);
}

}  // namespace piae::monitor
