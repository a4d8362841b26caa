#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// Segments of a TDMS file, as NI describes them ("TDMS File Format Internal Structure"): each has
/// metadata, which say which objects there are and how their values stand in the segment's raw
/// data, and the raw data: chunks of the same layout, one after another.
namespace piae::raw {

/// A property of an object; nothing where it is neither text nor a number.
using TdmsProperty = std::variant<std::monostate, std::string, double>;
using TdmsProperties = std::map<std::string, TdmsProperty>;

struct TdmsObject {
  std::vector<std::string> path;  ///< nothing for the file; group; group and channel
  TdmsProperties properties;
  [[nodiscard]] bool is_channel() const { return path.size() == 2; }
};

/// Values of one object within each chunk.
struct TdmsValues {
  std::size_t object = 0;   ///< its index among the objects
  std::uint32_t type = 0;   ///< NI's number
  std::uint64_t count = 0;  ///< number of values
  std::uint64_t bytes = 0;  ///< size of all of them
};

struct TdmsSegment {
  std::span<const TdmsValues> values = {};  ///< in the order of a chunk
  std::size_t begin = 0;                    ///< start of the raw data in the file
  std::size_t chunks = 0;
  std::size_t chunk_bytes = 0;
  bool is_big_endian = false;
  /// True where a chunk is a row: one value of each object.
  bool has_rows = false;
};

/// Goes through a file and shows each segment to `visit`. Returns the objects in the order of their
/// first mention. A last segment that says that its writer never finished it (LabVIEW crashed) ends
/// with its last whole chunk. Throws Error(bad_input) for a file that is shorter than it says or
/// damaged, and for raw data of NI-DAQmx, whose layout is another.
std::vector<TdmsObject> walk_tdms(const std::filesystem::path& file,
                                  std::span<const std::byte> bytes,
                                  const std::function<void(const TdmsSegment&)>& visit);

}  // namespace piae::raw
