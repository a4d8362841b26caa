#include "raw/hdf5_chunks.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "artefact/hdf5.hpp"
#include "raw/limits.hpp"

namespace piae::raw {

namespace {

namespace hdf5 = artefact::hdf5;

using Extents = std::vector<hsize_t>;

[[noreturn]] void refuse_unwritten(const Where& where) {
  refuse(where,
         "has values that were never written, or is damaged; copy the part that holds samples to a "
         "dataset of its own");
}

struct Filters {
  /// Filters that a writer may leave out for a chunk, because packing may enlarge it; bit i is
  /// filter i.
  unsigned optional = 0;
  bool have_checksum = false;
};

Filters filters_of(hid_t creation) {
  Filters filters;
  for (int i = 0; i < H5Pget_nfilters(creation); ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values,
                                               nullptr, 0, nullptr, nullptr);
    filters.have_checksum = filters.have_checksum || filter == H5Z_FILTER_FLETCHER32;
    if (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32) {
      filters.optional |= 1U << static_cast<unsigned>(i);
    }
  }
  return filters;
}

/// Returns the bytes of an unpacked chunk.
hsize_t unpacked_bytes(hid_t dataset, const Filters& filters, const Extents& chunk) {
  const hdf5::Handle type(H5Dget_type(dataset), "type");
  hsize_t bytes = H5Tget_size(type);
  for (const hsize_t extent : chunk) bytes *= extent;
  return filters.have_checksum ? bytes + 4 : bytes;
}

/// Moves to the next chunk; returns false after the last one.
bool advance(Extents& place, const Extents& chunk, const Extents& extents) {
  for (std::size_t i = place.size(); i-- > 0;) {
    place[i] += chunk[i];
    if (place[i] < extents[i]) return true;
    place[i] = 0;
  }
  return false;
}

struct Stored {
  std::uint32_t left_out = 0;  ///< mask of the filters left out
  hsize_t bytes = 0;
};

/// Looks up a chunk in the same way as reading values does. HDF5's functions for chunk information
/// differ: they search the whole index and find chunks that reading does not find.
Stored stored_chunk(const Where& where, hid_t dataset, const Extents& place,
                    std::vector<std::byte>& buffer) {
  Stored stored;
  if (H5Dget_chunk_storage_size(dataset, place.data(), &stored.bytes) < 0 || stored.bytes == 0) {
    refuse_unwritten(where);
  }
  if (stored.bytes > limits_of(where.file).file_bytes) {
    refuse(where, "is damaged: one of its chunks is larger than the file");
  }
  buffer.resize(std::max<std::size_t>(buffer.size(), stored.bytes));
  if (H5Dread_chunk(dataset, H5P_DEFAULT, place.data(), &stored.left_out, buffer.data()) < 0) {
    refuse_unwritten(where);
  }
  return stored;
}

void require_chunks(const Where& where, hid_t dataset, hid_t creation) {
  const hdf5::Handle space(H5Dget_space(dataset), "extents");
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1) return;
  Extents extents(static_cast<std::size_t>(rank));
  Extents chunk(extents.size());
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  if (H5Pget_chunk(creation, rank, chunk.data()) != rank || std::ranges::count(chunk, 0) > 0 ||
      std::ranges::count(extents, 0) > 0) {
    return;
  }
  const Filters filters = filters_of(creation);
  const hsize_t unpacked = unpacked_bytes(dataset, filters, chunk);
  std::vector<std::byte> stored;
  hsize_t sum = 0;
  Extents place(extents.size(), 0);
  do {
    const Stored chunk_there = stored_chunk(where, dataset, place, stored);
    const bool is_packed = (filters.optional & ~chunk_there.left_out) != 0;
    if ((chunk_there.left_out & ~filters.optional) != 0 ||
        (!is_packed && chunk_there.bytes != unpacked)) {
      refuse(where, "is damaged: one of its chunks contradicts its extents or filters");
    }
    sum += chunk_there.bytes;
  } while (advance(place, chunk, extents));
  if (sum != H5Dget_storage_size(dataset)) {
    refuse(where, "is damaged: its chunks do not match its extents and filters");
  }
}

/// Refuses contiguous values whose size contradicts the extents, or that go beyond the end of the
/// file that its header states. HDF5 would fill in zeros or read other bytes.
void require_whole_piece(const Where& where, hid_t dataset) {
  const hdf5::Handle space(H5Dget_space(dataset), "extents");
  const hdf5::Handle type(H5Dget_type(dataset), "type");
  const auto values = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space));
  if (values * H5Tget_size(type) != H5Dget_storage_size(dataset)) {
    refuse(where, "is damaged: its stored size does not match its extents and type");
  }
  const hdf5::Handle file(H5Iget_file_id(dataset), "file");
  const hdf5::Handle creation(H5Fget_create_plist(file), "file");
  haddr_t end = 0;
  hsize_t user_block = 0;
  hdf5::check(H5Fget_eoa(file, &end), "end of the file");
  hdf5::check(H5Pget_userblock(creation, &user_block), "beginning of the file");
  const haddr_t at = H5Dget_offset(dataset);
  const hsize_t bytes = H5Dget_storage_size(dataset);
  end += user_block;
  if (at == HADDR_UNDEF || (at <= end && bytes <= end - at)) return;
  refuse(where, "is damaged: its values extend beyond the declared end of the file");
}

}  // namespace

void require_written(const Where& where, hid_t dataset) {
  const hdf5::Handle creation(H5Dget_create_plist(dataset), "dataset");
  const H5D_layout_t layout = H5Pget_layout(creation);
  if (layout == H5D_CHUNKED) return require_chunks(where, dataset, creation);
  H5D_space_status_t status = H5D_SPACE_STATUS_ERROR;
  hdf5::check(H5Dget_space_status(dataset, &status), "values");
  if (status == H5D_SPACE_STATUS_NOT_ALLOCATED) refuse_unwritten(where);
  if (layout == H5D_CONTIGUOUS) require_whole_piece(where, dataset);
}

}  // namespace piae::raw
