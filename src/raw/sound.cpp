#include "raw/sound.hpp"

#include <sndfile.h>
#include <spdlog/fmt/fmt.h>

#include <cstdint>
#include <memory>
#include <optional>
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

/// Refuses a file of chunks (RIFF, FORM) whose samples are fewer than it says: libsndfile would
/// take those that are there.
void require_whole(const fs::path& file) {
  const Bytes content = artefact::read_file(file, largest_bytes);
  const std::string_view bytes(reinterpret_cast<const char*>(content.data()), content.size());
  const bool is_form = bytes.starts_with("FORM");
  if (!is_form && !bytes.starts_with("RIFF")) return;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::string_view name = bytes.substr(at, 4);
    const std::size_t size = number_at(content, at + 4, is_form);
    const bool has_samples = name == "data" || name == "SSND";
    if (has_samples && (size == 0 || size == 0xFFFFFFFF)) {
      refuse_file(file,
                  "does not say how long it is, as where a recorder was switched off: "
                  "sox --ignore-length IN OUT writes one that does");
    }
    if (at + 8 + size > bytes.size()) break;
    if (has_samples) return;
    at += 8 + size + size % 2;
  }
  refuse_file(file, "truncated or damaged: it is shorter than it says");
}

std::size_t channel_in(const fs::path& file, const std::string& channel, int channels) {
  const auto number = number_in<int>(channel);
  if (!number || *number < 1 || *number > channels) {
    refuse_file(file, fmt::format("has no channel {}; the variable is the number of one, 1 to {}",
                                  channel, channels));
  }
  return static_cast<std::size_t>(*number - 1);
}

}  // namespace

Signal read_sound(const fs::path& file, const std::string& channel) {
  require_whole(file);
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, CloseSound> sound(sf_open(file.c_str(), SFM_READ, &info));
  if (!sound) refuse_file(file, std::string("cannot be read: ") + sf_strerror(nullptr));
  const std::size_t index = channel_in(file, channel, info.channels);
  const auto channels = static_cast<std::size_t>(info.channels);
  const auto count = static_cast<std::size_t>(info.frames);
  if (count > limits_of(file).most_samples / channels) {
    refuse_file(file, fmt::format("is said to have {} samples, more than a file of its size can "
                                  "hold: it is damaged",
                                  count));
  }
  std::vector<double> all(count * channels);
  const sf_count_t got = sf_readf_double(sound.get(), all.data(), info.frames);
  if (got != info.frames || sf_error(sound.get()) != SF_ERR_NO_ERROR) {
    refuse_file(file,
                fmt::format("truncated or damaged: {} of {} samples can be read", got, count));
  }
  if ((info.format & SF_FORMAT_TYPEMASK) == SF_FORMAT_FLAC) {
    require_flac_sum(file, sound.get(), info);
  }
  Signal signal{.samples = std::vector<double>(count), .sample_rate_hz = info.samplerate};
  for (std::size_t i = 0; i < count; ++i) signal.samples[i] = all[i * channels + index];
  return signal;
}

}  // namespace piae::raw
