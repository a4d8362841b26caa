#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// Segments of a TDMS file (NI: "TDMS File Format Internal Structure"). Each has metadata and raw
/// data. The metadata list the objects and the layout of their values. The raw data are chunks of
/// the same layout.
namespace piae::raw {

/// A property of an object; empty if it is neither text nor a number.
using TdmsProperty = std::variant<std::monostate, std::string, double>;
using TdmsProperties = std::map<std::string, TdmsProperty>;

struct TdmsObject {
  std::vector<std::string> path;  ///< empty for the file; group; group and channel
  TdmsProperties properties;      ///< last value of each
  std::set<std::string> changed;  ///< properties that changed after the first values
  [[nodiscard]] bool is_channel() const { return path.size() == 2; }
};

/// Values of one object in each chunk.
struct TdmsValues {
  std::size_t object = 0;   ///< index of the object
  std::uint32_t type = 0;   ///< NI's type number
  std::uint64_t count = 0;  ///< number of values
  std::uint64_t bytes = 0;  ///< size of all values
};

struct TdmsSegment {
  std::span<const TdmsValues> values = {};  ///< in the order of a chunk
  std::size_t begin = 0;                    ///< start of the raw data in the file
  std::size_t chunks = 0;
  std::size_t chunk_bytes = 0;
  bool is_big_endian = false;
  /// True if a chunk is a row: one value of each object.
  bool has_rows = false;
};

/// Walks through a file and passes each segment to `visit`. Returns the objects in the order of
/// their first mention. If the writer never finished the last segment (LabVIEW crashed), uses its
/// whole chunks. Throws Error(bad_input) if the file is damaged or shorter than declared, and for
/// raw data of NI-DAQmx, which have another layout.
std::vector<TdmsObject> walk_tdms(const std::filesystem::path& file,
                                  std::span<const std::byte> bytes,
                                  const std::function<void(const TdmsSegment&)>& visit);

}  // namespace piae::raw
