#include "raw/tdms.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
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
    if (type.read == nullptr) {
      refuse(where, fmt::format("has values of the type '{}', which is not supported; name a "
                                "channel of real numbers, or save this one as double",
                                type.name));
    }
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

/// True for the file and the group of a channel.
bool is_above(const TdmsObject& object, const TdmsObject& channel) {
  return object.path.empty() || (object.path.size() == 1 && object.path[0] == channel.path[0]);
}

/// Returns the properties of a channel, its group and its file; the channel's own take precedence.
TdmsProperties inherited(const std::vector<TdmsObject>& objects, const TdmsObject& channel) {
  TdmsProperties properties = channel.properties;
  for (const TdmsObject& object : objects) {
    if (is_above(object, channel)) {
      properties.insert(object.properties.begin(), object.properties.end());
    }
  }
  return properties;
}

[[noreturn]] void refuse_change(const Where& where, const std::string& name) {
  refuse(
      where,
      fmt::format("changes its {} between its values; save each part as a file of its own", name));
}

/// Refuses a channel whose scales change after its first values, because all values are read with
/// the last scales. Without scales, a new scaling status changes nothing.
void require_same_scales(const Where& where, const TdmsProperties& properties,
                         const std::set<std::string>& changed) {
  const bool has_scales = std::ranges::any_of(
      properties, [](const auto& one) { return one.first.starts_with("NI_Scale["); });
  for (const std::string& name : changed) {
    const bool counts = name == "NI_Number_Of_Scales" || name.starts_with("NI_Scale[") ||
                        (has_scales && name == "NI_Scaling_Status");
    if (counts) refuse_change(where, name);
  }
}

/// Refuses a channel whose rate or scales change after its first values.
void require_constant(const Where& where, const std::vector<TdmsObject>& objects,
                      const TdmsObject& channel) {
  if (channel.changed.contains("wf_increment")) refuse_change(where, "wf_increment");
  const TdmsProperties properties = inherited(objects, channel);
  require_same_scales(where, properties, channel.changed);
  for (const TdmsObject& object : objects) {
    if (is_above(object, channel)) require_same_scales(where, properties, object.changed);
  }
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
  require_constant(where, objects, channel);
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
