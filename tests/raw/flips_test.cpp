#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>
#include <sndfile.h>

#include <cmath>
#include <random>
#include <set>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/old_hdf5.hpp"

/// Flips one bit in bytes that a checksum of the format covers: the reader must refuse the file or
/// return the same numbers.
namespace piae::raw {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t flipped_length = 3000;

/// Returns noise in steps of 1/64, which deflate shortens and 16 bits can hold.
std::vector<double> flipped_signal() {
  std::vector<double> values(flipped_length);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = std::round(63 * std::sin(static_cast<double>(i * i))) / 64;
  }
  return values;
}

/// Bytes of a file, from `begin` to before `end`.
struct Range {
  std::size_t begin;
  std::size_t end;
};

struct Filters {
  bool shuffle = false;
  bool deflate = false;
  bool fletcher32 = false;
};

/// Writes the signal as x of an HDF5 file, in five chunks.
void write_filtered(const fs::path& path, const Filters& filters, hsize_t user_block) {
  const hid_t creation_of_file = H5Pcreate(H5P_FILE_CREATE);
  H5Pset_userblock(creation_of_file, user_block);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation_of_file, oldest_format());
  const hsize_t extents[]{1, flipped_length};
  const hsize_t chunk[]{1, flipped_length / 5};
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 2, chunk);
  if (filters.shuffle) H5Pset_shuffle(creation);
  if (filters.deflate) H5Pset_deflate(creation, 3);
  if (filters.fletcher32) H5Pset_fletcher32(creation);
  const hid_t space = H5Screate_simple(2, extents, nullptr);
  const hid_t set =
      H5Dcreate2(file, "x", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  EXPECT_GE(
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, flipped_signal().data()), 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(creation);
  H5Fclose(file);
  H5Pclose(creation_of_file);
}

/// Returns where the chunks of x are in the file.
std::vector<Range> chunks_of(const fs::path& path) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(file, "x", H5P_DEFAULT);
  const std::string bytes = bytes_of(path);
  std::vector<Range> chunks;
  for (hsize_t begin = 0; begin < flipped_length; begin += flipped_length / 5) {
    const hsize_t place[]{0, begin};
    hsize_t size = 0;
    std::uint32_t mask = 0;
    EXPECT_GE(H5Dget_chunk_storage_size(set, place, &size), 0);
    std::string chunk(size, '\0');
    EXPECT_GE(H5Dread_chunk(set, H5P_DEFAULT, place, &mask, chunk.data()), 0);
    const std::size_t at = bytes.find(chunk);
    EXPECT_NE(at, std::string::npos);
    chunks.push_back({at, at + size});
  }
  H5Dclose(set);
  H5Fclose(file);
  return chunks;
}

/// A file with the signal, and the byte ranges that a checksum covers.
struct Covered {
  std::string bytes;
  std::vector<Range> ranges;
  std::string variable = "x";
};

Covered filtered(const Folder& folder, const Filters& filters, bool is_matlab) {
  const fs::path path = folder / "filtered";
  write_filtered(path, filters, is_matlab ? 512 : 0);
  Covered file{.bytes = bytes_of(path), .ranges = chunks_of(path), .variable = "x"};
  if (is_matlab) {  // MATLAB's block before the bytes of HDF5
    std::string header = "MATLAB 7.3 MAT-file, Platform: GLNXA64";
    header.resize(124, ' ');
    file.bytes.replace(0, 128, header + std::string("\x00\x02IM", 4));
  }
  return file;
}

std::string mat5_bytes(const Folder& folder, matio_compression compression) {
  const fs::path path = folder / "x.mat";
  std::vector<double> signal = flipped_signal();
  std::size_t extents[]{flipped_length, 1};
  mat_t* const file = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
  matvar_t* const x = Mat_VarCreate("x", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, extents, signal.data(), 0);
  EXPECT_EQ(Mat_VarWrite(file, x, compression), 0);
  Mat_VarFree(x);
  Mat_Close(file);
  return bytes_of(path);
}

/// Returns a MATLAB v5 file, whose variables are zlib streams after two headers.
Covered packed_mat(const Folder& folder) {
  const std::string bytes = mat5_bytes(folder, MAT_COMPRESSION_ZLIB);
  return {.bytes = bytes, .ranges = {{128 + 8, bytes.size()}}, .variable = "x"};
}

/// Returns a sound of the signal with 16 bits and one channel.
std::string sound_bytes(const Folder& folder, int format) {
  const fs::path path = folder / "sound";
  SF_INFO info{};
  info.samplerate = 12000;
  info.channels = 1;
  info.format = format | SF_FORMAT_PCM_16;
  SNDFILE* const sound = sf_open(path.c_str(), SFM_WRITE, &info);
  std::vector<short> samples;
  for (const double x : flipped_signal()) samples.push_back(static_cast<short>(32768 * x));
  EXPECT_EQ(sf_writef_short(sound, samples.data(), flipped_length), flipped_length);
  sf_close(sound);
  return bytes_of(path);
}

/// Returns a FLAC file: each frame has a checksum, and STREAMINFO in the header has one of all
/// samples (RFC 9639).
Covered flac(const Folder& folder) {
  const std::string bytes = sound_bytes(folder, SF_FORMAT_FLAC);
  constexpr std::size_t number_of_samples = 21;
  constexpr std::size_t after_sum = 42;
  const std::size_t frames = bytes.find("\xff\xf8", after_sum);
  return {.bytes = bytes,
          .ranges = {{number_of_samples, after_sum}, {frames, bytes.size()}},
          .variable = "1"};
}

/// Flips one bit: the file must be refused, or read to the same numbers. True if it is refused.
bool is_refused_or_same(const Folder& folder, const Covered& whole, std::size_t at, int bit,
                        decltype(&read_here) reader = read_here) {
  std::string bytes = whole.bytes;
  bytes[at] = static_cast<char>(bytes[at] ^ 1 << bit);
  const fs::path file = folder.write("damaged", bytes);
  std::vector<double> read;
  const auto error = error_of([&] { read = reader(file, whole.variable, {}); });
  EXPECT_TRUE(error || read == flipped_signal()) << "byte " << at << ", bit " << bit;
  if (!error) return false;
  EXPECT_EQ(error->exit(), Exit::bad_input) << error->what();
  EXPECT_TRUE(std::string(error->what()).starts_with(file.string())) << error->what();
  return true;
}

/// Flips one bit at 100 random places in turn.
void expect_no_other_numbers(const Folder& folder, const Covered& whole) {
  EXPECT_EQ(read_here(folder.write("whole", whole.bytes), whole.variable), flipped_signal());
  std::mt19937_64 random(20261127);
  constexpr std::size_t flips = 100;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < flips; ++i) {
    const Range range = whole.ranges[random() % whole.ranges.size()];
    const std::size_t at = range.begin + random() % (range.end - range.begin);
    const int bit = static_cast<int>(random() % 8);
    refused += is_refused_or_same(folder, whole, at, bit) ? 1 : 0;
  }
  // Deflate leaves some bits unused at the end of a block.
  EXPECT_GT(refused, flips * 9 / 10);
}

TEST(Flips, NeverChangeNumbersUnderAChecksum) {
  const Folder folder;
  expect_no_other_numbers(folder, packed_mat(folder));
  expect_no_other_numbers(folder, flac(folder));
  for (const bool is_matlab : {false, true}) {
    for (const Filters& filters : {Filters{.deflate = true}, Filters{.fletcher32 = true},
                                   Filters{.shuffle = true, .deflate = true},
                                   Filters{.shuffle = true, .deflate = true, .fletcher32 = true}}) {
      SCOPED_TRACE(testing::Message() << (is_matlab ? "MATLAB, " : "HDF5, ") << "filters "
                                      << filters.shuffle << filters.deflate << filters.fletcher32);
      expect_no_other_numbers(folder, filtered(folder, filters, is_matlab));
    }
  }
}

/// Flips every bit before the samples, which no checksum covers: fields declared twice must agree.
/// A bit without effect on the samples, as in a name, may be flipped.
void expect_contradictions_are_seen(const Folder& folder, const Covered& whole,
                                    std::size_t at_least) {
  EXPECT_EQ(read_here(folder.write("whole", whole.bytes), whole.variable), flipped_signal());
  std::size_t refused = 0;
  for (const Range& range : whole.ranges) {
    for (std::size_t at = range.begin; at < range.end; ++at) {
      for (int bit = 0; bit < 8; ++bit) {
        refused += is_refused_or_same(folder, whole, at, bit) ? 1 : 0;
      }
    }
  }
  EXPECT_GE(refused, at_least);
}

TEST(Flips, AreFoundBeforeTheSamplesOfMatlabV5) {
  const Folder folder;
  const std::string bytes = mat5_bytes(folder, MAT_COMPRESSION_NONE);
  const std::size_t samples = bytes.size() - flipped_length * sizeof(double);
  expect_contradictions_are_seen(folder, {.bytes = bytes, .ranges = {{128, samples}}}, 300);
}

TEST(Flips, AreFoundInTheFrameHeadersOfSound) {
  const Folder folder;
  const std::string wav = sound_bytes(folder, SF_FORMAT_WAV);  // channels; frame and bits; size
  expect_contradictions_are_seen(
      folder, {.bytes = wav, .ranges = {{22, 24}, {32, 36}, {40, 44}}, .variable = "1"}, 80);
  const std::string aiff = sound_bytes(folder, SF_FORMAT_AIFF);
  const std::size_t stated = aiff.find("COMM") + 8;  // channels, frames and bits
  expect_contradictions_are_seen(
      folder, {.bytes = aiff, .ranges = {{stated, stated + 8}}, .variable = "1"}, 56);
}

/// Returns where the keys of the chunk index are, which has no checksum in HDF5's old format. A key
/// has the size and filter mask (8 bytes), then the chunk's place in the dataset (HDF5 file format,
/// III.A.1).
std::set<std::size_t> keys_of_chunks(const Covered& file) {
  std::set<std::size_t> keys;
  for (const Range& range : file.ranges) {
    const auto size = static_cast<std::uint32_t>(range.end - range.begin);
    std::string key(8, '\0');
    for (std::size_t i = 0; i < 4; ++i) key[i] = static_cast<char>(size >> (8 * i));
    const std::string first_place(8, '\0');  // first place in the only row
    for (std::size_t at = file.bytes.find(key + first_place); at != std::string::npos;
         at = file.bytes.find(key + first_place, at + 1)) {
      keys.insert(at);
    }
  }
  return keys;
}

TEST(Flips, NeverChangeNumbersInTheChunkIndexOfHdf5) {
  const Folder folder;
  for (const Filters& filters :
       {Filters{.deflate = true}, Filters{.shuffle = true, .deflate = true},
        Filters{.shuffle = true, .fletcher32 = true}, Filters{.fletcher32 = true}}) {
    const Covered whole = filtered(folder, filters, false);
    const std::set<std::size_t> keys = keys_of_chunks(whole);
    ASSERT_EQ(keys.size(), 5U);
    SCOPED_TRACE(testing::Message()
                 << "filters " << filters.shuffle << filters.deflate << filters.fletcher32);
    std::size_t refused = 0;
    for (const std::size_t key : keys) {
      for (int bit = 0; bit < 8; ++bit) {
        for (const std::size_t byte : {0, 1, 4, 17, 29}) {
          refused += is_refused_or_same(folder, whole, key + byte, bit) ? 1 : 0;
        }
      }
    }
    EXPECT_GE(refused, 160U);
  }
}

/// Flips bits in the messages of a dataset's type and filters, which have no checksum either (HDF5
/// file format, IV.A.2.d and l).
TEST(Flips, NeverChangeNumbersInTypesAndFiltersOfHdf5) {
  const Folder folder;
  const Covered whole = filtered(folder, {.deflate = true}, false);
  const std::size_t type = whole.bytes.find(std::string("\x11\x20\x3f\0\x08\0\0\0", 8));
  const std::size_t name = whole.bytes.find("deflate");
  ASSERT_NE(type, std::string::npos);
  ASSERT_NE(name, std::string::npos);
  std::vector<std::size_t> places{name - 24, name - 8};  // message type, filter type
  for (std::size_t i = 2; i < 20; ++i) places.push_back(type + i);
  std::size_t refused = 0;
  for (const std::size_t at : places) {
    // Reads in another process, because libhdf5 1.10 may crash or leak.
    for (int bit = 0; bit < 8; ++bit) {
      refused += is_refused_or_same(folder, whole, at, bit, read) ? 1 : 0;
    }
  }
  EXPECT_GE(refused, 140U);
}

TEST(Flips, InTheExtentsOfHdf5CannotHideChunks) {
  const Folder folder;
  std::string bytes = filtered(folder, {.deflate = true}, false).bytes;
  const std::string extents("\x01\0\0\0\0\0\0\0\xb8\x0b", 10);  // 1 x 3000
  const std::size_t at = bytes.find(extents);
  ASSERT_NE(at, std::string::npos);
  bytes[at + 9] = 3;  // 1 x 952: two chunks of five
  EXPECT_ERROR(read_here(folder.write("a.h5", bytes), "x"), Exit::bad_input,
               "dataset /x is damaged: its chunks do not match its extents");
}

TEST(FileOfHdf5, IsReadBehindAUserBlock) {
  const Folder folder;
  for (const hsize_t bytes : {512, 1024, 65536}) {
    write_filtered(folder / "a.h5", {.deflate = true}, bytes);
    EXPECT_EQ(read_here(folder / "a.h5", "x"), flipped_signal()) << bytes;
  }
}

/// Flips bits in the old format's header and in a dataset without filters: the base and the end of
/// the file (HDF5 file format, II.A), and the extents (IV.A.2.b).
TEST(Flips, NeverChangeNumbersInEndAndExtentsOfHdf5) {
  const Folder folder;
  const hid_t file =
      H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, oldest_format());
  const hsize_t extent = 3000;
  std::vector<double> values(extent);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1 + static_cast<double>(i);
  const hid_t space = H5Screate_simple(1, &extent, nullptr);
  const hid_t set =
      H5Dcreate2(file, "x", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Fclose(file);
  const std::string whole = bytes_of(folder / "a.h5");
  ASSERT_EQ(whole[8], 0) << "version of the superblock";
  std::vector<std::size_t> places;
  for (std::size_t at = 24; at < 48; ++at) places.push_back(at);
  const std::size_t extents = whole.find(std::string("\xb8\x0b\0\0\0\0\0\0", 8));
  ASSERT_NE(extents, std::string::npos);
  for (std::size_t i = 0; i < 8; ++i) places.push_back(extents + i);
  std::size_t same = 0;
  for (const std::size_t at : places) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ 1 << bit);
      try {
        EXPECT_EQ(read_here(folder.write("b.h5", bytes), "x"), values) << at << " " << bit;
        ++same;
      } catch (const Error& error) {
        EXPECT_EQ(error.exit(), Exit::bad_input);
      }
    }
  }
  EXPECT_LT(same, 8 * places.size() / 2);
}

TEST(Hdf5, ReadsHalfFloatsAndRefusesUnusualTypes) {
  const Folder folder;
  const hid_t half = H5Tcopy(H5T_IEEE_F32LE);
  H5Tset_fields(half, 15, 10, 5, 0, 10);
  H5Tset_size(half, 2);
  H5Tset_ebias(half, 15);
  const hid_t odd = H5Tcopy(H5T_IEEE_F32LE);
  H5Tset_ebias(odd, 126);
  const hid_t twelve_bits = H5Tcopy(H5T_STD_I16LE);
  H5Tset_precision(twelve_bits, 12);
  const std::vector<std::uint16_t> bytes{0x3C00, 0xC000, 0x3C00, 0xC000};  // 1 and -2 in binary16
  const hid_t file =
      H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, oldest_format());
  write_dataset(file, "half", half, {4}, bytes.data());
  write_dataset(file, "odd", odd, {2}, bytes.data());
  write_dataset(file, "twelve", twelve_bits, {4}, bytes.data());
  H5Fclose(file);
  for (const hid_t type : {half, odd, twelve_bits}) H5Tclose(type);
  EXPECT_EQ(read_here(folder / "a.h5", "half"), (std::vector<double>{1, -2, 1, -2}));
  for (const char* name : {"odd", "twelve"}) {
    EXPECT_ERROR(read_here(folder / "a.h5", name), Exit::bad_input,
                 "has numbers of an unusual type, or is damaged; write it as floats of 32");
  }
}

TEST(Hdf5, RefusesDatasetsThatAreNotFullyWritten) {
  const Folder folder;
  const hid_t file =
      H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, oldest_format());
  const hsize_t extent = 100;
  const hsize_t chunk = 25;
  const hsize_t none = 0;
  const hsize_t written = 60;
  const hid_t space = H5Screate_simple(1, &extent, nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 1, &chunk);
  const hid_t set =
      H5Dcreate2(file, "x", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  const hid_t all =
      H5Dcreate2(file, "none", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t part = H5Screate_simple(1, &written, nullptr);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &none, nullptr, &written, nullptr);
  const std::vector<double> values(written, 1.5);
  EXPECT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, part, space, H5P_DEFAULT, values.data()), 0);
  for (const hid_t id : {set, all}) H5Dclose(id);
  for (const hid_t id : {space, part}) H5Sclose(id);
  H5Pclose(creation);
  H5Fclose(file);
  for (const char* name : {"x", "none"}) {
    EXPECT_ERROR(read_here(folder / "a.h5", name), Exit::bad_input,
                 std::string("a.h5: dataset /") + name + " has values that were never written");
  }
}

}  // namespace
}  // namespace piae::raw
