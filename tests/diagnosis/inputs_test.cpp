#include "diagnosis/inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "artefact/writer.hpp"
#include "base/error.hpp"
#include "diagnosis/sets.hpp"
#include "signal/roles.hpp"

namespace piae::diagnosis {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Differences between the files of the tests.
struct File {
  std::string role;
  std::int64_t seed = 0;
  std::string protocol = "random";
  std::string records_digest = "abc";
  std::int64_t first_sample = 0;
  /// for E: digest of the C it was learned from; empty for that of `c` below
  std::string known_digest;
};

artefact::Reader written(const File& file);

/// The C of all tests; E carries its digest if it was learned from it.
const File c{"C", 3, "random", "abc", 20, ""};

artefact::Reader written(const File& file) {
  signal::WindowSet set = empty_set(4);
  add(set, file.role == "B" ? 0 : 1, 1, 5);
  if (file.role != "E") {
    set.record_names = {"r"};
    set.record = {0};
    set.first_sample = {file.first_sample};
  }
  artefact::Writer writer("windows");
  write(writer, set);
  writer.attribute("/", "role", file.role);
  writer.attribute("/", "seed", file.seed);
  if (file.role == "E") {
    writer.attribute("/", "method", std::string("piae-dt"));
    signal::Origin origin = signal::origin_of_known(written(c));
    if (!file.known_digest.empty()) origin.known_digest = file.known_digest;
    signal::write(writer, origin);
  } else {
    writer.attribute("/", "protocol", file.protocol);
    writer.attribute("/", "records_digest", file.records_digest);
  }
  const fs::path path = fs::path(testing::TempDir()) / ("inputs_" + file.role + ".h5");
  writer.save(path, {});
  return {path, "windows"};
}

const File a{"A", 3, "random", "abc", 0, ""};
const File b{"B", 3, "random", "abc", 10, ""};
const File e{"E", 3, "random", "abc", 0, ""};

void expect_refused(const std::string& part, const File& test, const File& normal,
                    const File& known, const File& generated) {
  const artefact::Reader readers[] = {written(test), written(normal), written(known),
                                      written(generated)};
  try {
    read_inputs(readers[0], readers[1], readers[2], &readers[3]);
    FAIL() << "no error with " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::bad_input);
    EXPECT_THAT(error.what(), HasSubstr(part));
  }
}

TEST(Inputs, ReadsTheFilesOfOneRepeat) {
  const artefact::Reader generated = written(e);
  const Inputs inputs = read_inputs(written(a), written(b), written(c), &generated);
  EXPECT_EQ(inputs.method, "piae-dt");
  EXPECT_EQ(inputs.protocol, signal::Protocol::random);
  EXPECT_EQ(inputs.test.first_sample.at(0), 0);
  EXPECT_EQ(inputs.normal.first_sample.at(0), 10);
  EXPECT_EQ(inputs.known.first_sample.at(0), 20);
  EXPECT_EQ(inputs.generated.value().size(), 1U);
}

TEST(Inputs, WithoutGeneratedWindowsTheMethodIsNone) {
  const Inputs inputs = read_inputs(written(a), written(b), written(c), nullptr);
  EXPECT_EQ(inputs.method, "none");
  EXPECT_FALSE(inputs.generated.has_value());
}

TEST(Inputs, RefusesSwappedFiles) {
  expect_refused("has role B, but must have role A", b, b, c, e);
  expect_refused("has role A, but must have role C", a, b, a, e);
  expect_refused("has role C, but must have role E", a, b, c, c);
}

TEST(Inputs, RefusesFilesOfDifferentSplits) {
  expect_refused("has seed 4", a, b, {"C", 4, "random", "abc", 20, ""}, e);
  expect_refused("records_digest", a, b, {"C", 3, "random", "other", 20, ""}, e);
  expect_refused("share a window", a, b, {"C", 3, "random", "abc", 0, ""}, e);
  expect_refused("learned from other known windows", a, b, c,
                 {"E", 3, "random", "abc", 0, "another C"});
}

}  // namespace
}  // namespace piae::diagnosis
