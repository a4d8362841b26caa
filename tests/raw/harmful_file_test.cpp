#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/harmful_files.hpp"

/// Reads malicious raw files as ingest does. Whatever they declare, reading takes little memory and
/// time, and ends in one line with the file's name.
namespace piae::raw {
namespace {

namespace fs = std::filesystem;

void expect_refused(const fs::path& file, const std::string& why) {
  SCOPED_TRACE(file);
  const auto began = std::chrono::steady_clock::now();
  EXPECT_ERROR(read(file, "x"), Exit::bad_input, file.string() + ": ");
  EXPECT_ERROR(read(file, "x"), Exit::bad_input, why);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(who, &used);
    EXPECT_LT(used.ru_maxrss, 1'000'000) << "kB of memory";
  }
}

TEST(HarmfulRawFile, IsRefusedIfItDeclaresMoreThanItCanHold) {
  const Folder folder;
  expect_refused(folder.write("v4.mat", harmful::claiming_v4()), "not a MATLAB file");
  expect_refused(folder.write("v5.mat", harmful::claiming_v5()), "variable x declares 2147483647");
  harmful::write_claiming_hdf5(folder / "claim.h5");
  expect_refused(folder / "claim.h5", "dataset /x declares 1000000000 values");
}

TEST(HarmfulRawFile, IsNotUnpackedIfCompressedBeyondReason) {
  const Folder folder;
  const fs::path bomb = folder.write("bomb.mat", harmful::bomb_v5(40'000'000));
  EXPECT_LT(fs::file_size(bomb), 400'000);
  expect_refused(bomb, "variable x declares 40000000 values");
}

TEST(HarmfulRawFile, IsNotReadIfLargerThanTheLimit) {
  const Folder folder;
  for (const char* name : {"a.csv", "a.mat", "a.h5"}) {
    const fs::path file = folder.write(name, "x\n");
    fs::resize_file(file, 12'000'000'000);
    expect_refused(file, "is larger than 4000 MB");
  }
}

TEST(HarmfulRawFile, MayBeCompressedWell) {
  const Folder folder;
  const fs::path packed = folder.write("packed.mat", harmful::bomb_v5(100'000));
  EXPECT_EQ(read(packed, "x"), std::vector<double>(100'000, 0.0));
}

TEST(HarmfulRawFile, IsSearchedQuicklyDespiteManyNestedGroups) {
  const Folder folder;
  harmful::write_nested_hdf5(folder / "nested.h5", 3000);
  expect_refused(folder / "nested.h5", "has no dataset /x; it has none");
}

TEST(HarmfulRawFile, CannotMakeItReadOtherFiles) {
  const Folder folder;
  {
    const harmful::NewHdf5 other(folder / "other.h5");
    other.dataset("x", H5T_NATIVE_DOUBLE, 20, H5P_DEFAULT);
  }
  harmful::write_external_link(folder / "link.h5", folder / "other.h5");
  expect_refused(folder / "link.h5", "/x is a link to another file");
  folder.write("secret", std::string(100, 's'));
  harmful::write_external_values(folder / "values.h5", folder / "secret", 100);
  expect_refused(folder / "values.h5", "is virtual or external: its values are in other files");
}

/// Returns an HDF5 file with a compressed x of 50 numbers.
std::string packed_hdf5(const fs::path& path) {
  {
    const harmful::NewHdf5 file(path);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk = 10;
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_deflate(creation, 4);
    file.dataset("x", H5T_IEEE_F64LE, 50, creation);
    H5Pclose(creation);
    const hid_t dataset = H5Dopen2(file.id, "x", H5P_DEFAULT);
    const std::vector<double> values(50, 1.5);
    EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
              0);
    H5Dclose(dataset);
  }
  return bytes_of(path);
}

// libhdf5 1.10 crashes here: each number of x declares 16 million bytes.
TEST(HarmfulRawFile, IsRefusedIfItCrashesTheReader) {
  const Folder folder;
  std::string bytes = packed_hdf5(folder / "a.h5");
  EXPECT_EQ(read(folder / "a.h5", "x"), std::vector<double>(50, 1.5));
  const std::size_t size_of_a_double = bytes.find(std::string("\x11\x20\x3f\0\x08\0\0\0", 8));
  ASSERT_NE(size_of_a_double, std::string::npos);
  bytes.replace(size_of_a_double + 5, 2, "\xff\xff");
  expect_refused(folder.write("a.h5", bytes), "damaged");
}

// The header of HDF5's old format has no checksum, so some changes give other numbers
// (SECURITY.md).
TEST(HarmfulRawFile, IsReadOrRefusedInOneLineIfDamagedAnywhere) {
  const Folder folder;
  const std::string whole = packed_hdf5(folder / "a.h5");
  constexpr std::size_t changes = 60;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < changes; ++i) {
    std::string damaged = whole;
    damaged.replace(i * whole.size() / changes, 4, "\xff\xff\xff\xff");
    const fs::path file = folder.write("a.h5", damaged);
    const auto error = error_of([&] { (void)read(file, "x"); });
    if (!error) continue;
    ++refused;
    EXPECT_EQ(error->exit(), Exit::bad_input) << error->what();
    EXPECT_TRUE(std::string(error->what()).starts_with(file.string())) << error->what();
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what();
  }
  EXPECT_GE(refused, 8U);
}

}  // namespace
}  // namespace piae::raw
