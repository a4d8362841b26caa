#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>

#include "signal/raw_file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/harmful_files.hpp"

/// Raw files that were made to do harm, read as ingest does it. Whatever they say of themselves,
/// reading them takes neither much memory nor time, and ends in one line that names them.
namespace piae::signal {
namespace {

namespace fs = std::filesystem;

void expect_refused(const fs::path& file, const std::string& why) {
  SCOPED_TRACE(file);
  const auto began = std::chrono::steady_clock::now();
  EXPECT_ERROR(read_raw_file(file, "x"), Exit::bad_input, file.string() + ": ");
  EXPECT_ERROR(read_raw_file(file, "x"), Exit::bad_input, why);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(who, &used);
    EXPECT_LT(used.ru_maxrss, 1'000'000) << "kB of memory";
  }
}

TEST(HarmfulRawFile, ThatSaysToHoldMoreThanItCanIsNotBelieved) {
  const Folder folder;
  expect_refused(folder.write("v4.mat", harmful::claiming_v4()), "not a MATLAB file");
  expect_refused(folder.write("v5.mat", harmful::claiming_v5()),
                 "variable x is said to have 2147483647");
  harmful::write_claiming_hdf5(folder / "claim.h5");
  expect_refused(folder / "claim.h5", "dataset /x is said to have 1000000000 values");
}

TEST(HarmfulRawFile, ThatIsPackedBeyondReasonIsNotUnpacked) {
  const Folder folder;
  const fs::path bomb = folder.write("bomb.mat", harmful::bomb_v5(40'000'000));
  EXPECT_LT(fs::file_size(bomb), 400'000);
  expect_refused(bomb, "variable x is said to have 40000000 values");
}

TEST(HarmfulRawFile, MayBePackedWell) {
  const Folder folder;
  const fs::path packed = folder.write("packed.mat", harmful::bomb_v5(100'000));
  EXPECT_EQ(read_raw_file(packed, "x"), std::vector<double>(100'000, 0.0));
}

TEST(HarmfulRawFile, WithManyNestedGroupsIsLookedThroughAtOnce) {
  const Folder folder;
  harmful::write_nested_hdf5(folder / "nested.h5", 3000);
  expect_refused(folder / "nested.h5", "has no dataset /x; it has none");
}

TEST(HarmfulRawFile, DoesNotBringInOtherFiles) {
  const Folder folder;
  {
    const harmful::NewHdf5 other(folder / "other.h5");
    other.dataset("x", H5T_NATIVE_DOUBLE, 20, H5P_DEFAULT);
  }
  harmful::write_external_link(folder / "link.h5", folder / "other.h5");
  expect_refused(folder / "link.h5", "has no dataset /x; it has none");
  folder.write("secret", std::string(100, 's'));
  harmful::write_external_values(folder / "values.h5", folder / "secret", 100);
  expect_refused(folder / "values.h5", "has its values in another file");
}

/// Bytes of a good file that are changed one after another, evenly over the file. libhdf5 1.10
/// crashes on some of them.
void expect_good_or_refused(const fs::path& file, const std::vector<double>& good) {
  const std::string whole = bytes_of(file);
  constexpr std::size_t changes = 60;
  for (std::size_t i = 0; i < changes; ++i) {
    std::string damaged = whole;
    const std::size_t at = i * whole.size() / changes;
    damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(0x40 + i));
    std::ofstream(file, std::ios::binary) << damaged;
    const auto error = error_of([&] { EXPECT_EQ(read_raw_file(file, "x").size(), good.size()); });
    if (!error) continue;
    EXPECT_EQ(error->exit(), Exit::bad_input) << error->what();
    EXPECT_TRUE(std::string(error->what()).starts_with(file.string())) << error->what();
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what();
  }
}

TEST(HarmfulRawFile, ThatIsDamagedAnywhereEndsNoProcessButItsReader) {
  const Folder folder;
  const std::vector<double> values(50, 1.5);
  {
    const harmful::NewHdf5 file(folder / "a.h5");
    file.dataset("x", H5T_NATIVE_DOUBLE, values.size(), H5P_DEFAULT);
  }
  expect_good_or_refused(folder / "a.h5", values);
}

}  // namespace
}  // namespace piae::signal
