#include "raw/tdms_segments.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "raw/bytes.hpp"
#include "raw/file.hpp"
#include "raw/tdms_types.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

// Bits of the table of contents.
constexpr std::uint32_t toc_metadata = 1U << 1U;
constexpr std::uint32_t toc_new_list = 1U << 2U;
constexpr std::uint32_t toc_raw_data = 1U << 3U;
constexpr std::uint32_t toc_interleaved = 1U << 5U;
constexpr std::uint32_t toc_big_endian = 1U << 6U;
constexpr std::uint32_t toc_daqmx_data = 1U << 7U;

// Special values of the length of an object's index.
constexpr std::uint32_t no_values = 0xFFFFFFFF;
constexpr std::uint32_t same_as_before = 0;

constexpr std::uint64_t never_finished = 0xFFFFFFFFFFFFFFFF;
constexpr std::size_t lead_in_bytes = 28;

/// First bytes of a segment.
struct LeadIn {
  std::uint32_t contents = 0;
  std::size_t data = 0;  ///< start of the raw data in the file
  std::size_t end = 0;
  bool is_finished = true;
  bool has_whole_metadata = true;  ///< false if the writer crashed within the metadata

  [[nodiscard]] bool has(std::uint32_t bit) const { return (contents & bit) != 0; }
};

std::uint64_t product(std::uint64_t count, std::uint64_t size) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  return size != 0 && count > most / size ? most : count * size;
}

std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
  return a > std::numeric_limits<std::uint64_t>::max() - b
             ? std::numeric_limits<std::uint64_t>::max()
             : a + b;
}

/// True if a property keeps its value. Writers that compute it for each segment change last bits.
bool is_same(const TdmsProperty& a, const TdmsProperty& b) {
  constexpr double tolerance = 1e-9;
  const auto* const x = std::get_if<double>(&a);
  const auto* const y = std::get_if<double>(&b);
  if (x == nullptr || y == nullptr) return a == b;
  if (std::isnan(*x) && std::isnan(*y)) return true;
  return *x == *y || std::abs(*x - *y) < tolerance * std::max(std::abs(*x), std::abs(*y));
}

/// True for a rate that the writer has not set yet.
bool is_missing_rate(const std::string& name, const TdmsProperty& value) {
  const auto* const seconds = std::get_if<double>(&value);
  return name == "wf_increment" && seconds != nullptr && !(*seconds > 0);
}

/// Takes "'group'" off a path. Quotes within a name are doubled.
std::optional<std::string> take_name(std::string_view& path) {
  if (!path.starts_with("/'")) return std::nullopt;
  std::string name;
  for (std::size_t i = 2; i < path.size(); ++i) {
    if (path[i] != '\'') {
      name += path[i];
    } else if (path.substr(i + 1).starts_with('\'')) {
      name += path[i++];
    } else {
      path.remove_prefix(i + 1);
      return name;
    }
  }
  return std::nullopt;
}

/// Refuses a type whose values cannot be skipped. `owner` has them.
void require_stated_size(const fs::path& file, const std::string& owner, const TdmsType& type,
                         const char* remedy) {
  if (type.size != unstated_size) return;
  refuse_file(file, fmt::format("{} has the type '{}', which is not supported, and whose size is "
                                "unknown, so the rest of the file cannot be read; {}",
                                owner, type.name, remedy));
}

/// Reads numbers and texts from the metadata of a segment.
class Metadata {
 public:
  Metadata(const fs::path& file, std::span<const std::byte> bytes, std::size_t begin,
           const LeadIn& lead_in)
      : file_(file),
        bytes_(bytes.first(lead_in.data)),
        at_(begin + lead_in_bytes),
        big_endian_(lead_in.has(toc_big_endian)) {}

  template <class T = std::uint32_t>
  T number() {
    require(sizeof(T));
    at_ += sizeof(T);
    return number_at<T>(bytes_, at_ - sizeof(T), big_endian_);
  }

  std::string text() {
    const std::size_t size = number();
    require(size);
    at_ += size;
    return {reinterpret_cast<const char*>(bytes_.data()) + at_ - size, size};
  }

  TdmsProperty property() {
    const std::uint32_t id = number();
    if (id == tdms_text) return text();
    const TdmsType* const type = tdms_type(id);
    if (type == nullptr) refuse(fmt::format("a property has the unknown type {:#x}", id));
    require_stated_size(file_, "a property", *type, "save the file without it");
    require(type->size);
    at_ += type->size;
    if (type->read == nullptr) return {};
    return type->read(bytes_, at_ - type->size, big_endian_);
  }

  /// Requires the values to follow. Writers may align them with zeros; other bytes are metadata
  /// that a damaged count or offset skips.
  void require_end() const {
    const auto rest = bytes_.subspan(at_);
    if (std::ranges::any_of(rest, [](std::byte b) { return b != std::byte{0}; })) {
      refuse("its metadata do not end where its values begin");
    }
  }

  [[noreturn]] void refuse(const std::string& what) const {
    refuse_file(file_, fmt::format("damaged: {} (metadata at byte {})", what, at_));
  }

 private:
  void require(std::size_t bytes) const {
    if (bytes > bytes_.size() - at_) refuse("its metadata end too early");
  }

  const fs::path& file_;
  std::span<const std::byte> bytes_;
  std::size_t at_;
  bool big_endian_;
};

class Walk {
 public:
  Walk(const fs::path& file, std::span<const std::byte> bytes) : file_(file), bytes_(bytes) {}

  std::vector<TdmsObject> run(const std::function<void(const TdmsSegment&)>& visit) {
    for (std::size_t begin = 0; begin < bytes_.size();) {
      const LeadIn lead_in = lead_in_at(begin);
      if (lead_in.has_whole_metadata) {
        read_metadata(begin, lead_in);
        visit(segment(begin, lead_in));
      }
      begin = lead_in.end;
    }
    return std::move(objects_);
  }

 private:
  /// An object in the list of a segment's objects.
  struct Listed {
    TdmsValues values;
    bool has_values = false;
  };

  [[noreturn]] void refuse_segment(std::size_t begin, const std::string& what) const {
    refuse_file(file_, fmt::format("truncated or damaged: its segment at byte {} {}", begin, what));
  }

  [[nodiscard]] LeadIn lead_in_at(std::size_t begin) const {
    const std::size_t left = bytes_.size() - begin;
    if (left < lead_in_bytes && begin > 0) {
      refuse_segment(begin, fmt::format("ends within its first {} bytes; if the writer crashed, "
                                        "`truncate -s {} FILE` keeps the complete part",
                                        lead_in_bytes, begin));
    }
    if (left < lead_in_bytes || number_at(bytes_, begin, true) != 0x5444536D) {  // "TDSm"
      refuse_segment(begin, "does not begin with the mark of a segment");
    }
    LeadIn lead_in{.contents = number_at(bytes_, begin + 4, false)};
    const bool big_endian = lead_in.has(toc_big_endian);
    const auto size = number_at<std::uint64_t>(bytes_, begin + 12, big_endian);
    const auto metadata = number_at<std::uint64_t>(bytes_, begin + 20, big_endian);
    lead_in.is_finished = size != never_finished;
    if (lead_in.is_finished && size > left - lead_in_bytes) {
      refuse_segment(
          begin, fmt::format("declares {} bytes, but {} are there", size, left - lead_in_bytes));
    }
    lead_in.end = lead_in.is_finished ? begin + lead_in_bytes + size : bytes_.size();
    lead_in.has_whole_metadata = metadata <= lead_in.end - begin - lead_in_bytes;
    if (lead_in.is_finished && !lead_in.has_whole_metadata) {
      refuse_segment(begin, "is shorter than its metadata");
    }
    if (lead_in.has_whole_metadata) lead_in.data = begin + lead_in_bytes + metadata;
    if (lead_in.has(toc_daqmx_data)) refuse_daqmx();
    return lead_in;
  }

  [[noreturn]] void refuse_daqmx() const {
    refuse_file(file_,
                "holds raw data of NI-DAQmx, which are not supported; save the scaled channel as "
                "CSV with DIAdem, LabVIEW or npTDMS");
  }

  void read_metadata(std::size_t begin, const LeadIn& lead_in) {
    Metadata metadata(file_, bytes_, begin, lead_in);
    if (lead_in.has(toc_metadata)) {
      if (lead_in.has(toc_new_list)) {
        list_.clear();
        place_in_list_.clear();
      }
      for (auto left = metadata.number(); left > 0; --left) read_object(metadata);
    }
    metadata.require_end();
  }

  void read_object(Metadata& metadata) {
    const std::size_t object = object_at(metadata.text(), metadata);
    const auto [place, is_new] = place_in_list_.try_emplace(object, list_.size());
    if (is_new) list_.emplace_back();
    Listed& listed = list_[place->second];
    const std::uint32_t index = metadata.number();
    listed.has_values = index != no_values;
    if (index == same_as_before) {
      if (!last_values_[object]) metadata.refuse("an object refers to earlier values, but is new");
    } else if (index != no_values) {
      last_values_[object] = values_of(object, index, metadata);
    }
    if (listed.has_values) listed.values = *last_values_[object];
    for (auto left = metadata.number(); left > 0; --left) {
      const std::string name = metadata.text();
      set_property(object, name, metadata.property());
    }
  }

  void set_property(std::size_t index, const std::string& name, TdmsProperty value) {
    TdmsObject& object = objects_[index];
    const auto [place, is_new] = object.properties.try_emplace(name, value);
    if (is_new || is_same(place->second, value)) return;
    const bool has_had_values =
        object.is_channel() ? with_values_.contains(index) : !with_values_.empty();
    if (has_had_values && !is_missing_rate(name, place->second)) object.changed.insert(name);
    place->second = std::move(value);
  }

  std::size_t object_at(const std::string& path, const Metadata& metadata) {
    const auto [place, is_new] = object_by_path_.try_emplace(path, objects_.size());
    if (!is_new) return place->second;
    TdmsObject object;
    std::string_view rest = path;
    if (rest == "/") rest = {};
    while (!rest.empty() && object.path.size() < 2) {
      auto name = take_name(rest);
      if (!name) break;
      object.path.push_back(std::move(*name));
    }
    if (!rest.empty()) metadata.refuse("an object has a path that cannot be read");
    objects_.push_back(std::move(object));
    last_values_.emplace_back();
    return place->second;
  }

  [[nodiscard]] TdmsValues values_of(std::size_t object, std::uint32_t index_bytes,
                                     Metadata& metadata) const {
    constexpr std::uint32_t without_size = 20;
    constexpr std::uint32_t with_size = 28;  // for text, whose values have any length
    for (const std::uint32_t daqmx : {0x1269U, 0x126AU, 0x1369U}) {
      if (index_bytes == daqmx) refuse_daqmx();
    }
    if (index_bytes != without_size && index_bytes != with_size) {
      metadata.refuse("an index of values has an unknown length");
    }
    TdmsValues values{.object = object, .type = metadata.number()};
    const TdmsType* const type = tdms_type(values.type);
    if (type == nullptr) {
      metadata.refuse(fmt::format("an object has values of the unknown type {:#x}", values.type));
    }
    require_stated_size(file_, fmt::format("channel {}", fmt::join(objects_[object].path, "/")),
                        *type, "save the channel as double, or the file without it");
    if (metadata.number() != 1) metadata.refuse("an object has values of several dimensions");
    values.count = metadata.number<std::uint64_t>();
    values.bytes = index_bytes == with_size ? metadata.number<std::uint64_t>()
                                            : product(values.count, type->size);
    const bool fits = type->size == 0 ? index_bytes == with_size
                                      : values.bytes == product(values.count, type->size);
    if (!fits) metadata.refuse("an object has values of an impossible size");
    return values;
  }

  [[nodiscard]] TdmsSegment segment(std::size_t begin, const LeadIn& lead_in) {
    const std::size_t raw_bytes = lead_in.end - lead_in.data;
    TdmsSegment segment{.begin = lead_in.data, .is_big_endian = lead_in.has(toc_big_endian)};
    if (raw_bytes == 0) return segment;
    if (!lead_in.has(toc_raw_data)) refuse_segment(begin, "has more bytes than its metadata");
    values_.clear();
    for (const Listed& listed : list_) {
      if (listed.has_values && listed.values.count > 0) values_.push_back(listed.values);
    }
    // The numbers of a single object are rows, too, so that a crash loses none of them.
    const bool is_single = values_.size() == 1 && tdms_type(values_.front().type)->size > 0;
    segment.has_rows = is_single || lead_in.has(toc_interleaved);
    const std::uint64_t declared = bytes_of_chunk();
    const std::uint64_t chunk_bytes =
        segment.has_rows && !values_.empty() ? bytes_of_row(begin) : declared;
    // LabVIEW may end a segment within a chunk. Without a whole chunk, whole rows are not enough:
    // they would also fit other types and counts.
    const bool is_whole = declared > 0 && raw_bytes >= declared && raw_bytes % chunk_bytes == 0;
    if (lead_in.is_finished && !is_whole) {
      refuse_segment(begin,
                     fmt::format("has {} bytes of values, not a whole number of chunks of {}",
                                 raw_bytes, declared));
    }
    if (declared == 0) return segment;
    for (const TdmsValues& values : values_) with_values_.insert(values.object);
    segment.values = values_;
    segment.chunk_bytes = chunk_bytes;
    segment.chunks = raw_bytes / chunk_bytes;
    return segment;
  }

  [[nodiscard]] std::uint64_t bytes_of_chunk() const {
    std::uint64_t bytes = 0;
    for (const TdmsValues& values : values_) bytes = sum(bytes, values.bytes);
    return bytes;
  }

  /// Returns the bytes of one value of each object.
  [[nodiscard]] std::uint64_t bytes_of_row(std::size_t begin) const {
    std::uint64_t bytes = 0;
    for (const TdmsValues& values : values_) {
      const std::size_t size = tdms_type(values.type)->size;
      if (size == 0 || values.count != values_.front().count) {
        refuse_segment(begin, "has interleaved objects of different lengths");
      }
      bytes += size;
    }
    return bytes;
  }

  const fs::path& file_;
  std::span<const std::byte> bytes_;
  std::vector<TdmsObject> objects_;
  std::map<std::string, std::size_t> object_by_path_;
  std::vector<std::optional<TdmsValues>> last_values_;
  std::vector<Listed> list_;
  std::map<std::size_t, std::size_t> place_in_list_;  ///< place in list_ of each object
  std::vector<TdmsValues> values_;                    ///< layout of the current segment
  std::set<std::size_t> with_values_;                 ///< objects that have had values
};

}  // namespace

std::vector<TdmsObject> walk_tdms(const fs::path& file, std::span<const std::byte> bytes,
                                  const std::function<void(const TdmsSegment&)>& visit) {
  return Walk(file, bytes).run(visit);
}

}  // namespace piae::raw
