#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/old_hdf5.hpp"

/// Raw recordings designed to harm a reader that trusts them, by what it would allocate, follow or
/// wait for. Each has a variable or dataset x.
namespace piae::harmful {

namespace fs = std::filesystem;

inline void append(std::string& bytes, std::initializer_list<std::uint32_t> numbers) {
  for (const std::uint32_t number : numbers) {
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * i & 255U);
  }
}

/// Returns a file of version 4: x claims 2^28 numbers; the file has 3000 bytes of them.
inline std::string claiming_v4() {
  std::string bytes;
  append(bytes, {0, 1, 1U << 28U, 0, 2});
  return bytes + std::string("x\0", 2) + std::string(3000, '\0');
}

inline std::string v5_header() {
  std::string header = "MATLAB 5.0 MAT-file";
  header.resize(124, ' ');
  return header + std::string("\0\1IM", 4);
}

/// Returns the beginning of x as a column in double precision, up to its data.
inline std::string v5_beginning(std::uint32_t length, std::uint32_t data_bytes) {
  constexpr std::uint32_t matrix = 14;
  constexpr std::uint32_t doubles = 9;
  std::string inside;
  append(inside, {6, 8, 6, 0, 5, 8, length, 1, 1, 1, 'x', 0, doubles, data_bytes});
  std::string bytes;
  append(bytes, {matrix, static_cast<std::uint32_t>(inside.size()) + data_bytes});
  return bytes + inside;
}

/// Returns a file of version 5: x claims 2^31 - 1 numbers; the file has 3.
inline std::string claiming_v5() {
  return v5_header() + v5_beginning((1U << 31U) - 1, 24) + std::string(24, '\0');
}

/// Returns a file of version 5, compressed: x is `length` zeros, which take a thousandth of the
/// space.
inline std::string bomb_v5(std::uint32_t length) {
  z_stream stream{};
  EXPECT_EQ(deflateInit(&stream, 9), Z_OK);
  std::string packed;
  std::string buffer(1 << 16, '\0');
  const auto put = [&](std::string piece, int flush) {
    stream.next_in = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_in = static_cast<uInt>(piece.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream.avail_out = static_cast<uInt>(buffer.size());
      (void)deflate(&stream, flush);
      packed.append(buffer, 0, buffer.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  };
  constexpr std::uint32_t piece = 1 << 20;
  put(v5_beginning(length, 8 * length), Z_NO_FLUSH);
  for (std::uint32_t done = 0; done < length; done += piece) {
    put(std::string(8 * std::min(piece, length - done), '\0'), Z_NO_FLUSH);
  }
  put({}, Z_FINISH);
  deflateEnd(&stream);
  std::string bytes = v5_header();
  append(bytes, {15, static_cast<std::uint32_t>(packed.size())});
  return bytes + packed;
}

/// A new HDF5 file; the destructor closes it.
class NewHdf5 {
 public:
  explicit NewHdf5(const fs::path& path)
      : id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, oldest_format())) {}
  NewHdf5(const NewHdf5&) = delete;
  NewHdf5& operator=(const NewHdf5&) = delete;
  ~NewHdf5() { H5Fclose(id); }

  /// Creates a dataset with the properties of `creation`.
  void dataset(const char* name, hid_t type, hsize_t length, hid_t creation) const {
    const hid_t space = H5Screate_simple(1, &length, nullptr);
    const hid_t made = H5Dcreate2(id, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    EXPECT_GE(made, 0);
    H5Dclose(made);
    H5Sclose(space);
  }

  const hid_t id;
};

/// Writes a file whose x claims 10^9 floats; none is stored.
inline void write_claiming_hdf5(const fs::path& path) {
  const NewHdf5 file(path);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk = 1'000'000;
  H5Pset_chunk(creation, 1, &chunk);
  file.dataset("x", H5T_NATIVE_FLOAT, 1'000'000'000, creation);
  H5Pclose(creation);
}

/// Writes groups nested `depth` times.
inline void write_nested_hdf5(const fs::path& path, int depth) {
  const NewHdf5 file(path);
  hid_t group = H5Gopen2(file.id, "/", H5P_DEFAULT);
  for (int i = 0; i < depth; ++i) {
    const hid_t inner = H5Gcreate2(group, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Gclose(group);
    group = inner;
  }
  H5Gclose(group);
}

/// Writes x as a link to another file.
inline void write_external_link(const fs::path& path, const fs::path& other) {
  const NewHdf5 file(path);
  EXPECT_GE(H5Lcreate_external(other.c_str(), "/x", file.id, "x", H5P_DEFAULT, H5P_DEFAULT), 0);
}

/// Writes x with its values in another file of any content.
inline void write_external_values(const fs::path& path, const fs::path& other, hsize_t bytes) {
  const NewHdf5 file(path);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(creation, other.c_str(), 0, bytes);
  file.dataset("x", H5T_NATIVE_UINT8, bytes, creation);
  H5Pclose(creation);
}

}  // namespace piae::harmful
