#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <span>
#include <sstream>

#include "artefact/file.hpp"
#include "artefact/hdf5.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"

namespace piae::artefact {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Artefact : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) /
        ("artefact-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Writes an artefact with one dataset of every type, a list of strings and attributes.
  fs::path example(const std::string& name, const std::string& options = "a = \"1\"\n") const {
    Writer writer("example");
    writer.numbers("/float", std::vector<float>{1.5F, -2.0F, 0.25F, 4.0F, 5.0F, 6.0F}, {2, 3});
    writer.numbers("/group/double", std::vector<double>{1e300, -1e-300});
    writer.numbers("/group/int32", std::vector<std::int32_t>{-7, 7});
    writer.numbers("/group/int64", std::vector<std::int64_t>{1LL << 60});
    writer.strings("/names", {"Normal", "", "IR007"});
    writer.attribute("/", "seed", std::int64_t{3});
    writer.attribute("/group", "rate_hz", 12000.0);
    writer.attribute("/", "empty", std::string());
    writer.save(folder_ / name, {"tester", options, {{"known", "C.h5", "abc"}}});
    return folder_ / name;
  }

  static Refusal refusal_of(const fs::path& path, const std::string& kind = "example") {
    try {
      const Reader reader(path, kind);
    } catch (const Refusal& refusal) {
      return refusal;
    }
    throw std::runtime_error("was not refused");
  }

  fs::path folder_;
};

std::vector<std::byte> slurp(const fs::path& path) {
  const Bytes bytes = read_file(path);
  return {bytes.begin(), bytes.end()};
}

void spill(const fs::path& path, const std::vector<std::byte>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// Finds the numbers in the bytes of a file.
auto find_numbers(std::vector<std::byte>& bytes, std::span<const float> numbers) {
  const auto wanted = std::as_bytes(numbers);
  return std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end());
}

/// Changes the first number in /float of an example.
void damage(const fs::path& path) {
  std::vector<std::byte> bytes = slurp(path);
  const std::vector<float> values{1.5F, -2.0F, 0.25F};
  const auto found = find_numbers(bytes, values);
  ASSERT_NE(found, bytes.end());
  *found ^= std::byte{1};
  spill(path, bytes);
}

TEST_F(Artefact, ReadsBackWhatWasWritten) {
  const Reader reader(example("a.h5"), "example");
  const auto floats = reader.numbers<float>("/float", {2, 0});
  EXPECT_EQ(floats.shape, (hdf5::Shape{2, 3}));
  EXPECT_EQ(floats.values, (std::vector<float>{1.5F, -2.0F, 0.25F, 4.0F, 5.0F, 6.0F}));
  EXPECT_EQ(reader.numbers<double>("/group/double", {0}).values,
            (std::vector<double>{1e300, -1e-300}));
  EXPECT_EQ(reader.numbers<std::int32_t>("/group/int32", {2}).values,
            (std::vector<std::int32_t>{-7, 7}));
  EXPECT_EQ(reader.numbers<std::int64_t>("/group/int64", {1}).values[0], 1LL << 60);
  EXPECT_EQ(reader.strings("/names"), (std::vector<std::string>{"Normal", "", "IR007"}));
  EXPECT_EQ(reader.integer("/", "seed"), 3);
  EXPECT_EQ(reader.real("/group", "rate_hz"), 12000.0);
  EXPECT_EQ(reader.text("/", "empty"), "");
  EXPECT_EQ(reader.list("/group"), (std::vector<std::string>{"double", "int32", "int64"}));
  EXPECT_TRUE(reader.has("/group/int32"));
  EXPECT_FALSE(reader.has("/no/such"));
}

TEST_F(Artefact, HasTheSameBytesWhenWrittenAgain) {
  EXPECT_EQ(slurp(example("a.h5")), slurp(example("b.h5")));
}

TEST_F(Artefact, DigestExcludesProvenance) {
  const Reader one(example("a.h5", "a = \"1\"\n"), "");
  const Reader two(example("b.h5", "a = \"2\"\n"), "");
  EXPECT_EQ(one.digest(), two.digest());
  EXPECT_NE(slurp(one.path()), slurp(two.path()));
}

TEST_F(Artefact, DigestDependsOnEveryValueNameAndShape) {
  std::set<std::string> digests;
  const auto add = [&](const std::string& path, const std::vector<std::int32_t>& values,
                       const hdf5::Shape& shape, std::int64_t attribute) {
    Writer writer("example");
    writer.numbers(path, values, shape);
    writer.attribute("/", "x", attribute);
    writer.save(folder_ / "d.h5", {});
    digests.insert(Reader(folder_ / "d.h5", "").digest());
  };
  add("/a", {1, 2}, {2}, 0);
  add("/a", {1, 3}, {2}, 0);
  add("/b", {1, 2}, {2}, 0);
  add("/a", {1, 2}, {1, 2}, 0);
  add("/a", {1, 2}, {2}, 1);
  EXPECT_EQ(digests.size(), 5U);
}

// The promise itself: for any changed byte, a changed value is never read.
TEST_F(Artefact, RefusesFlippedBytes) {
  const fs::path good = example("good.h5");
  const std::vector<std::byte> bytes = slurp(good);
  const std::string digest = Reader(good, "").digest();
  const fs::path bad = folder_ / "bad.h5";
  std::size_t refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::vector<std::byte> flipped = bytes;
    flipped[i] ^= std::byte{0x10};
    spill(bad, flipped);
    try {
      const Reader reader(bad, "example");
      EXPECT_EQ(reader.digest(), digest) << "byte " << i;
      EXPECT_EQ(reader.numbers<float>("/float", {2, 3}).values[1], -2.0F) << "byte " << i;
    } catch (const Refusal& refusal) {
      ++refused;
      EXPECT_THAT(refusal.what(), HasSubstr("bad.h5")) << "byte " << i;
    }
  }
  EXPECT_GT(refused, bytes.size() / 60);  // the rest is unused padding
}

TEST_F(Artefact, RefusesAWrongChecksumOfCorrectValues) {
  std::vector<std::byte> bytes = slurp(example("good.h5"));
  const std::vector<float> values{1.5F, -2.0F, 0.25F, 4.0F, 5.0F, 6.0F};
  const auto found = find_numbers(bytes, values);
  ASSERT_NE(found, bytes.end());
  found[std::ssize(std::as_bytes(std::span(values)))] ^= std::byte{1};
  spill(folder_ / "bad.h5", bytes);
  const Refusal refusal = refusal_of(folder_ / "bad.h5");
  EXPECT_EQ(refusal.reason(), RefusalReason::damaged);
  EXPECT_THAT(refusal.what(), HasSubstr("/float: its checksum"));
}

/// Provenance is protected like the contents.
TEST_F(Artefact, RefusesAlteredProvenance) {
  const fs::path altered = example("altered.h5");
  {
    const hdf5::Handle file(H5Fopen(altered.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
    hdf5::check(H5Adelete_by_name(file, "/provenance", "program", H5P_DEFAULT), "program");
    hdf5::write_attribute(file, "/provenance", "program", std::string("forger"));
  }
  const Refusal refusal = refusal_of(altered);
  EXPECT_EQ(refusal.reason(), RefusalReason::damaged);
  EXPECT_THAT(refusal.what(), HasSubstr("the digest of /provenance does not match"));
}

TEST_F(Artefact, RefusesATruncatedFile) {
  const std::vector<std::byte> bytes = slurp(example("good.h5"));
  for (const std::size_t keep :
       {std::size_t{0}, std::size_t{7}, std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
    spill(folder_ / "short.h5", {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(keep)});
    const Refusal refusal = refusal_of(folder_ / "short.h5");
    EXPECT_EQ(refusal.exit(), Exit::bad_input);
    EXPECT_EQ(refusal.reason(), RefusalReason::unreadable);
  }
}

TEST_F(Artefact, RefusalsNameProblemAndPlace) {
  const Refusal missing = refusal_of(folder_ / "none.h5");
  EXPECT_EQ(missing.exit(), Exit::input_missing);
  EXPECT_THAT(missing.what(), HasSubstr("none.h5"));
  EXPECT_EQ(refusal_of(folder_).exit(), Exit::input_missing);

  const Refusal kind = refusal_of(example("a.h5"), "windows");
  EXPECT_EQ(kind.reason(), RefusalReason::wrong_kind);
  EXPECT_THAT(kind.what(), HasSubstr("'example'"));
  EXPECT_THAT(kind.what(), HasSubstr("'windows'"));

  const fs::path foreign = folder_ / "foreign.h5";
  H5Fclose(H5Fcreate(foreign.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(refusal_of(foreign).reason(), RefusalReason::wrong_kind);

  const Reader reader(example("b.h5"), "example");
  EXPECT_THROW((void)reader.numbers<double>("/float", {0, 0}), Refusal);  // wrong type
  EXPECT_THROW((void)reader.numbers<float>("/float", {6}), Refusal);      // wrong rank
  EXPECT_THROW((void)reader.numbers<float>("/float", {3, 2}), Refusal);   // wrong shape
  EXPECT_THROW((void)reader.numbers<float>("/no", {0}), Refusal);
  EXPECT_THROW((void)reader.strings("/float"), Refusal);
  EXPECT_THROW((void)reader.real("/", "seed"), Refusal);  // is an integer
  EXPECT_THROW((void)reader.text("/", "no"), Refusal);
}

TEST_F(Artefact, ReadsManyLikeEachAlone) {
  std::vector<fs::path> files;
  // More files than one child reads. Most are links, because writing a file waits for the disk.
  for (int i = 0; i < 600; ++i) {
    files.push_back(folder_ / (std::to_string(i) + ".h5"));
    if (i < 5 || i == 514) {
      example(files.back().filename(), "a = \"" + std::to_string(i) + "\"\n");
    } else {
      fs::create_hard_link(files[static_cast<std::size_t>(i % 5)], files.back());
    }
  }
  fs::remove(files[7]);
  damage(files[514]);
  Writer("another").save(files[515], {"tester", "", {}});
  Readers readers(files, "example");
  std::vector<RefusalReason> reasons;
  // Reading a file alone takes a process, so the linked files are read alone only once each.
  std::vector<std::pair<std::string, std::vector<std::string>>> alone;
  for (std::size_t i = 0; i < 5; ++i) {
    const Reader reader(files[i], "example");
    alone.emplace_back(reader.digest(), reader.strings("/provenance/options"));
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path& file = files[i];
    try {
      const Reader reader = readers.next();
      EXPECT_EQ(reader.path(), file);
      EXPECT_EQ(reader.digest(), alone[i % 5].first);
      EXPECT_EQ(reader.strings("/provenance/options"), alone[i % 5].second);
    } catch (const Refusal& refusal) {
      EXPECT_EQ(refusal.what(), std::string(refusal_of(file).what()));
      EXPECT_EQ(refusal.reason(), refusal_of(file).reason());
      reasons.push_back(refusal.reason());
    }
  }
  EXPECT_THAT(reasons, ElementsAre(RefusalReason::unreadable, RefusalReason::damaged,
                                   RefusalReason::wrong_kind));
  EXPECT_THROW((void)readers.next(), std::logic_error);
}

/// Permits opening one more file for its lifetime, but not a pipe.
class NoPipe {
 public:
  NoPipe() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    const int free = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::close(free);
    const rlimit one_more{static_cast<rlim_t>(free) + 1, before_.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &one_more);
  }
  ~NoPipe() { ::setrlimit(RLIMIT_NOFILE, &before_); }
  NoPipe(const NoPipe&) = delete;
  NoPipe& operator=(const NoPipe&) = delete;

 private:
  rlimit before_{};
};

TEST_F(Artefact, ReadsNoneOfManyUncheckedIfNoProcessCanStart) {
  const std::vector<fs::path> files{example("0.h5"), example("1.h5"), example("2.h5")};
  damage(files[1]);
  Readers readers(files, "example");
  {
    const NoPipe no_pipe;
    EXPECT_THROW((void)readers.next(), Error);
  }
  EXPECT_THROW((void)readers.next(), Refusal);
  EXPECT_EQ(readers.next().path(), files[2]);
}

TEST_F(Artefact, WritesOnlyFiniteValues) {
  Writer writer("example");
  const std::vector<float> values{1, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_THROW(writer.numbers("/x", values), Error);
  EXPECT_THROW(writer.attribute("/", "x", std::numeric_limits<double>::infinity()), Error);
  EXPECT_THROW(writer.numbers("/x", std::vector<float>{1, 2}, {3}), std::logic_error);
}

TEST_F(Artefact, FailedWritesLeaveNothing) {
  std::ofstream(folder_ / "file") << "not a folder";
  Writer writer("example");
  try {
    writer.save(folder_ / "file" / "a.h5", {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::failed);
    EXPECT_THAT(error.what(), HasSubstr("file"));
  }
  fs::create_directories(folder_ / "a.h5");  // a folder where the artefact should be
  const std::byte byte{1};
  EXPECT_THROW(write_file_atomically(folder_ / "a.h5", {&byte, 1}), Error);
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder_)) left.insert(entry.path().filename());
  EXPECT_THAT(left, testing::ElementsAre("a.h5", "file"));
}

TEST_F(Artefact, StoresItsProvenance) {
  const Reader reader(example("a.h5"), "");
  EXPECT_EQ(reader.text("/provenance", "program"), "tester");
  EXPECT_EQ(reader.strings("/provenance/options"), (std::vector<std::string>{"a = \"1\"\n"}));
  EXPECT_EQ(reader.strings("/provenance/inputs"), (std::vector<std::string>{"known C.h5 abc"}));
  EXPECT_THAT(reader.text("/provenance", "libraries"), HasSubstr("HDF5"));
  EXPECT_THAT(reader.text("/provenance", "cpu"), HasSubstr("threads"));
}

}  // namespace
}  // namespace piae::artefact
