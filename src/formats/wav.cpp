#include "formats/wav.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "formats/bytes.hpp"

namespace piae::formats {

namespace {

constexpr std::uint16_t ieee_float = 3;
constexpr std::uint32_t sample_bytes = sizeof(float);

/// Writes a chunk: its name, its size, and its content, padded to an even size.
void put_chunk(Bytes& bytes, std::string_view name, const std::string& content) {
  bytes.text(name);
  bytes.number(static_cast<std::uint32_t>(content.size()));
  bytes.text(content);
  bytes.pad(2);
}

std::string format_chunk(double sample_rate_hz) {
  const auto rate_hz = static_cast<std::uint32_t>(std::max(1L, std::lround(sample_rate_hz)));
  Bytes bytes;
  bytes.number(ieee_float);
  bytes.number(std::uint16_t{1});  // channels
  bytes.number(rate_hz);
  bytes.number(rate_hz * sample_bytes);  // bytes per second
  bytes.number(static_cast<std::uint16_t>(sample_bytes));
  bytes.number(static_cast<std::uint16_t>(8 * sample_bytes));
  bytes.number(std::uint16_t{0});  // no extension
  return bytes.take();
}

std::string count_chunk(std::size_t samples) {
  Bytes bytes;
  bytes.number(static_cast<std::uint32_t>(samples));
  return bytes.take();
}

/// Returns a marker at the first sample of each window.
std::string cue_chunk(const signal::WindowSet& windows) {
  Bytes bytes;
  bytes.number(static_cast<std::uint32_t>(windows.size()));
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(i * windows.length);
    bytes.number(static_cast<std::uint32_t>(i + 1));  // its name in `labl`
    bytes.number(first);
    bytes.text("data");
    bytes.number(std::uint32_t{0});
    bytes.number(std::uint32_t{0});
    bytes.number(first);
  }
  return bytes.take();
}

/// Returns the texts of the markers.
std::string label_chunk(const Exported& exported) {
  const signal::WindowSet& windows = exported.windows;
  Bytes bytes;
  bytes.text("adtl");
  for (std::size_t i = 0; i < windows.size(); ++i) {
    Bytes label;
    label.number(static_cast<std::uint32_t>(i + 1));
    label.text(windows.info.class_of(windows.labels[i]).name + ' ' +
               std::to_string(exported.rows[i]));
    label.number(std::uint8_t{0});
    put_chunk(bytes, "labl", label.all());
  }
  return bytes.take();
}

std::string sample_chunk(const signal::WindowSet& windows) {
  Bytes bytes;
  for (const float x : windows.samples) bytes.number(x);
  return bytes.take();
}

}  // namespace

std::string wav(const Exported& exported) {
  const signal::WindowSet& windows = exported.windows;
  constexpr std::size_t largest_marker = 256;  // with its text
  const std::size_t most_bytes =
      windows.samples.size() * sample_bytes + windows.size() * largest_marker;
  if (most_bytes > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(
        Exit::usage,
        "a .wav file holds no more than 4 GB; export fewer windows with --count or --class, or "
        "write a .npy");
  }
  Bytes chunks;
  chunks.text("WAVE");
  put_chunk(chunks, "fmt ", format_chunk(windows.info.sample_rate_hz));
  put_chunk(chunks, "fact", count_chunk(windows.samples.size()));
  put_chunk(chunks, "data", sample_chunk(windows));
  put_chunk(chunks, "cue ", cue_chunk(windows));
  put_chunk(chunks, "LIST", label_chunk(exported));
  Bytes file;
  put_chunk(file, "RIFF", chunks.all());
  return file.take();
}

}  // namespace piae::formats
