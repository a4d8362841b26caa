#include "raw/tdms.hpp"

#include <optional>
#include <span>

#include "artefact/file.hpp"
#include "base/numbers.hpp"
#include "raw/array.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"
#include "raw/tdms_scales.hpp"
#include "raw/tdms_segments.hpp"
#include "raw/tdms_types.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

std::string name_of(const TdmsObject& channel) { return channel.path[0] + '/' + channel.path[1]; }

std::size_t object_called(const fs::path& file, const std::vector<TdmsObject>& objects,
                          const std::string& wanted) {
  const auto number = number_in<std::size_t>(wanted);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].is_channel()) continue;
    names.push_back(name_of(objects[i]));
    if (wanted == names.back() || number == names.size()) return i;
  }
  refuse_file(file, "has no channel " + wanted + "; it has " + listed(names));
}

/// Appends the values of an object in a segment.
void append(const Where& where, std::span<const std::byte> bytes, const TdmsSegment& segment,
            std::size_t object, std::vector<double>& samples) {
  std::size_t begin = segment.begin;
  for (const TdmsValues& values : segment.values) {
    const TdmsType& type = *tdms_type(values.type);
    if (values.object != object) {
      begin += segment.has_rows ? type.size : values.bytes;
      continue;
    }
    if (type.read == nullptr) refuse(where, std::string("does not hold numbers, but ") + type.name);
    const std::size_t count = segment.has_rows ? 1 : values.count;
    for (std::size_t chunk = 0; chunk < segment.chunks; ++chunk) {
      const std::size_t at = begin + chunk * segment.chunk_bytes;
      for (std::size_t i = 0; i < count; ++i) {
        samples.push_back(type.read(bytes, at + i * type.size, segment.is_big_endian));
      }
    }
    return;
  }
}

/// Returns the properties of a channel, its group and its file; the channel's own take precedence.
TdmsProperties inherited(const std::vector<TdmsObject>& objects, const TdmsObject& channel) {
  TdmsProperties properties = channel.properties;
  for (const TdmsObject& object : objects) {
    const bool is_above =
        object.path.empty() || (object.path.size() == 1 && object.path[0] == channel.path[0]);
    if (is_above) properties.insert(object.properties.begin(), object.properties.end());
  }
  return properties;
}

std::optional<double> rate_hz(const TdmsObject& channel) {
  const auto found = channel.properties.find("wf_increment");
  if (found == channel.properties.end()) return std::nullopt;
  const auto* const seconds = std::get_if<double>(&found->second);
  if (seconds == nullptr || !(*seconds > 0)) return std::nullopt;
  return 1 / *seconds;
}

}  // namespace

Signal read_tdms(const fs::path& file, const std::string& wanted) {
  const Bytes content = artefact::read_file(file, largest_bytes);
  const std::span<const std::byte> bytes(content);
  const std::vector<TdmsObject> objects = walk_tdms(file, bytes, [](const TdmsSegment&) {});
  const std::size_t index = object_called(file, objects, wanted);
  const TdmsObject& channel = objects[index];
  const Where where{.file = file, .noun = "channel", .name = name_of(channel)};
  Signal signal{.samples = {}, .sample_rate_hz = rate_hz(channel)};
  walk_tdms(file, bytes, [&](const TdmsSegment& segment) {
    append(where, bytes, segment, index, signal.samples);
  });
  if (const TdmsScales scale = tdms_scales(where, inherited(objects, channel))) {
    for (double& sample : signal.samples) sample = scale(sample);
  }
  return signal;
}

}  // namespace piae::raw
