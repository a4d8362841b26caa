#include "raw/sound.hpp"

#include <sndfile.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "artefact/file.hpp"
#include "base/numbers.hpp"
#include "raw/bytes.hpp"
#include "raw/file.hpp"
#include "raw/flac_sum.hpp"
#include "raw/limits.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

struct CloseSound {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

/// A format made of chunks, each with its name and size before its content.
struct ChunkFormat {
  std::string_view mark;  ///< first bytes of the file
  std::size_t first;      ///< start of the first chunk
  std::size_t head;       ///< bytes of name and size
  std::size_t alignment;
  bool is_big_endian = false;
};
constexpr std::array chunk_formats{ChunkFormat{"RIFF", 12, 8, 2}, ChunkFormat{"RF64", 12, 8, 2},
                                   ChunkFormat{"riff", 40, 24, 8},  // W64
                                   ChunkFormat{"FORM", 12, 8, 2, true}};

constexpr std::uint64_t no_size = 0xFFFFFFFF;

/// Returns the bytes of a chunk's content. In W64 the size includes the chunk's head.
std::uint64_t content_bytes(std::span<const std::byte> file, std::size_t at,
                            const ChunkFormat& format) {
  constexpr std::size_t short_head = 8;
  if (format.head == short_head) return number_at(file, at + 4, format.is_big_endian);
  const auto size = number_at<std::uint64_t>(file, at + 16, false);
  return size - std::min<std::uint64_t>(size, format.head);
}

/// Sizes in the chunk ds64 of RF64, where the sizes of 4 bytes are no_size; 0 in other formats.
struct LongSizes {
  std::uint64_t file = 0;     ///< bytes after the file's own mark and size
  std::uint64_t samples = 0;  ///< bytes
  std::uint64_t count = 0;    ///< frames, or samples of all channels; 0 if not declared
};

LongSizes long_sizes(std::span<const std::byte> content) {
  constexpr std::size_t bytes = 24;
  if (content.size() < bytes) return {};
  const auto size = [&](std::size_t at) { return number_at<std::uint64_t>(content, at, false); };
  constexpr std::uint64_t undeclared = 0xFFFFFFFFFFFFFFFF;
  const std::uint64_t count = size(16);
  return {.file = size(0), .samples = size(8), .count = count == undeclared ? 0 : count};
}

/// True if the file has its declared size. Some recorders never write the size.
bool has_stated_size(std::span<const std::byte> file, const ChunkFormat& format,
                     const LongSizes& sizes) {
  constexpr std::size_t before = 8;  // not part of the declared size
  if (format.head != before) return number_at<std::uint64_t>(file, 16, false) == file.size();
  const std::uint64_t size = number_at(file, 4, format.is_big_endian);
  return (size == no_size ? sizes.file : size) + before == file.size();
}

/// Declared layout of a sound's samples. WAV and W64 declare the frame size twice, AIFF and RF64
/// the number of frames, so damage shows as a contradiction.
struct Frames {
  std::uint64_t bytes = 0;     ///< bytes of one frame; 0 for compressed samples
  std::uint64_t count = 0;     ///< 0 if not declared
  std::uint64_t channels = 1;  ///< RF64's count may be that of all channels' samples
  bool is_consistent = true;
};

/// Reads the chunk `fmt` of WAV and W64 (WAVEFORMATEX) for plain integers and floats.
Frames wav_frames(std::span<const std::byte> content) {
  constexpr std::array<std::uint16_t, 3> plain{1, 3, 0xFFFE};
  if (content.size() < 16) return {.is_consistent = false};
  const auto field = [&](std::size_t at) { return number_at<std::uint16_t>(content, at, false); };
  if (std::ranges::find(plain, field(0)) == plain.end()) return {};
  const std::uint64_t channels = field(2);
  const std::uint64_t frame = field(12);
  const std::uint64_t bits = field(14);
  const bool is_padded = bits == 24 && frame == 4 * channels;
  return {.bytes = frame,
          .channels = channels,
          .is_consistent = frame > 0 && (is_padded || frame == channels * ((bits + 7) / 8))};
}

/// Reads the chunk `COMM` of AIFF, and of AIFC for plain integers and floats.
Frames aiff_frames(std::span<const std::byte> content, bool has_kind) {
  constexpr std::size_t kind_at = 18;
  if (content.size() < kind_at + (has_kind ? 4 : 0)) return {.is_consistent = false};
  const std::uint64_t channels = number_at<std::uint16_t>(content, 0, true);
  const std::uint64_t count = number_at(content, 2, true);
  std::uint64_t bits = number_at<std::uint16_t>(content, 6, true);
  if (has_kind) {
    std::string kind(reinterpret_cast<const char*>(content.data()) + kind_at, 4);
    for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (kind == "fl32") bits = 32;
    if (kind == "fl64") bits = 64;
    constexpr std::array plain{"none", "twos", "sowt", "raw ", "in24", "in32", "fl32", "fl64"};
    if (std::ranges::find(plain, kind) == plain.end()) return {};
  }
  const std::uint64_t frame = channels * ((bits + 7) / 8);
  return {.bytes = frame, .count = count, .is_consistent = frame > 0};
}

/// Returns the bytes of a chunk before its samples. AIFF declares them.
std::uint64_t bytes_before_samples(std::string_view name, std::span<const std::byte> content) {
  constexpr std::uint64_t head = 8;  // offset and block size
  if (name != "SSND") return 0;
  return content.size() < head ? head : head + number_at(content, 0, true);
}

/// True if the chunk has whole frames, and all of them.
bool holds(const Frames& stated, std::string_view name, std::span<const std::byte> content) {
  const std::uint64_t before = bytes_before_samples(name, content);
  if (!stated.is_consistent || before > content.size()) return false;
  if (stated.bytes == 0) return true;
  const std::uint64_t bytes = content.size() - before;
  const std::uint64_t frames = bytes / stated.bytes;
  const bool has_count =
      stated.count == 0 || stated.count == frames || stated.count == frames * stated.channels;
  return bytes % stated.bytes == 0 && has_count;
}

/// Refuses a file of chunks with fewer or more samples than declared. libsndfile would read the
/// available ones, or as many as the chunk declares.
void require_whole(const fs::path& file) {
  const Bytes content = artefact::read_file(file, largest_bytes);
  const std::string_view bytes(reinterpret_cast<const char*>(content.data()), content.size());
  const auto* const format = std::ranges::find_if(
      chunk_formats, [&](const ChunkFormat& one) { return bytes.starts_with(one.mark); });
  if (format == chunk_formats.end()) return;
  LongSizes sizes;
  bool has_passed_samples = false;
  Frames stated;
  std::size_t at = format->first;
  while (at + format->head <= bytes.size()) {
    const std::string_view name = bytes.substr(at, 4);
    std::uint64_t size = content_bytes(content, at, *format);
    const bool has_samples = name == "data" || name == "SSND";
    if (has_samples && size == no_size && sizes.samples > 0) size = sizes.samples;
    if (has_samples && (size == 0 || size == no_size)) {
      refuse_file(file,
                  "does not declare its length, as after a recorder was switched off; repair it: "
                  "sox --ignore-length IN OUT");
    }
    if (size > bytes.size() - at - format->head) break;
    has_passed_samples = has_passed_samples || has_samples;
    const std::span content_of_chunk = std::span(content).subspan(at + format->head, size);
    if (name == "fmt ") stated = wav_frames(content_of_chunk);
    if (name == "COMM") stated = aiff_frames(content_of_chunk, bytes.substr(8, 4) == "AIFC");
    if (name == "ds64") sizes = long_sizes(content_of_chunk);
    if (sizes.count > 0) stated.count = sizes.count;
    if (has_samples && !holds(stated, name, content_of_chunk)) {
      refuse_file(file, "damaged: its channels, bits or length contradict its samples");
    }
    at += format->head + (size + format->alignment - 1) / format->alignment * format->alignment;
  }
  if (!has_passed_samples) {
    refuse_file(file, "truncated or damaged: it is shorter than it declares");
  }
  if (at < bytes.size() && has_stated_size(content, *format, sizes)) {
    refuse_file(file, "damaged: its samples do not end where it declares");
  }
}

/// Refuses samples that are not plain integers or floats.
void require_lossless(const fs::path& file, const SF_INFO& info) {
  constexpr std::array plain{SF_FORMAT_PCM_S8, SF_FORMAT_PCM_U8, SF_FORMAT_PCM_16, SF_FORMAT_PCM_24,
                             SF_FORMAT_PCM_32, SF_FORMAT_FLOAT,  SF_FORMAT_DOUBLE};
  if (std::ranges::find(plain, info.format & SF_FORMAT_SUBMASK) == plain.end()) {
    refuse_file(file, lossy_sound);
  }
}

std::size_t channel_in(const fs::path& file, const std::string& channel, int channels) {
  const auto number = number_in<int>(channel);
  if (!number || *number < 1 || *number > channels) {
    refuse_file(file, fmt::format("has no channel {}; name a channel by its number, 1 to {}",
                                  channel, channels));
  }
  return static_cast<std::size_t>(*number - 1);
}

/// Returns the samples of a channel, as many as can be read. Reads in blocks, because all channels
/// may need many times the memory of one. Stops at an error, which the next read would clear.
std::vector<double> samples_of(SNDFILE* sound, std::size_t channels, std::size_t channel,
                               std::size_t count) {
  constexpr std::size_t frames = 1 << 12;
  std::vector<double> block(frames * channels);
  std::vector<double> samples;
  samples.reserve(count);
  for (std::size_t got = frames;
       got == frames && samples.size() < count && sf_error(sound) == SF_ERR_NO_ERROR;) {
    const std::size_t most = std::min(frames, count - samples.size());
    got = static_cast<std::size_t>(std::max<sf_count_t>(
        0, sf_readf_double(sound, block.data(), static_cast<sf_count_t>(most))));
    for (std::size_t i = 0; i < got; ++i) samples.push_back(block[i * channels + channel]);
  }
  return samples;
}

[[noreturn]] void refuse_unopened(const fs::path& file) {
  const std::string why = sf_strerror(nullptr);
  const bool lacks_rate = why.find("SF_INFO struct incomplete") != std::string::npos;
  refuse_file(file, lacks_rate
                        ? "declares a sample rate of 0 Hz; correct its header: sox -r RATE FILE OUT"
                        : "cannot be read: " + why + "; convert it to WAV: sox IN OUT.wav");
}

}  // namespace

Signal read_sound(const fs::path& file, const std::string& channel) {
  require_whole(file);
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, CloseSound> sound(sf_open(file.c_str(), SFM_READ, &info));
  if (!sound) refuse_unopened(file);
  require_lossless(file, info);
  const std::size_t index = channel_in(file, channel, info.channels);
  const auto channels = static_cast<std::size_t>(info.channels);
  const auto count = static_cast<std::size_t>(info.frames);
  if (info.frames == SF_COUNT_MAX) {
    refuse_file(file,
                "does not declare its length, as after streaming; convert it to WAV: flac -d FILE");
  }
  if (count > limits_of(file).most_samples / channels) {
    refuse_file(
        file, fmt::format(
                  "declares {} samples, more than a file of its size can hold; the file is damaged",
                  count));
  }
  std::vector<double> samples = samples_of(sound.get(), channels, index, count);
  if (samples.size() != count || sf_error(sound.get()) != SF_ERR_NO_ERROR) {
    refuse_file(file, fmt::format("truncated or damaged: {} of {} samples can be read",
                                  samples.size(), count));
  }
  if ((info.format & SF_FORMAT_TYPEMASK) == SF_FORMAT_FLAC) {
    require_flac_sum(file, sound.get(), info);
  }
  return {.samples = std::move(samples), .sample_rate_hz = info.samplerate};
}

}  // namespace piae::raw
