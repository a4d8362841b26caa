#include "base/sha256.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/errors.hpp"

namespace piae {
namespace {

// FIPS 180-4 examples.
const std::string of_nothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
const std::string of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Sha256, EqualsTheStandardsExamples) {
  EXPECT_EQ(Sha256().finish_hex(), of_nothing);
  EXPECT_EQ(Sha256().update("abc").finish_hex(), of_abc);
}

TEST(Sha256, DoesNotDependOnThePieces) {
  EXPECT_EQ(Sha256().update("a").update("").update("bc").finish_hex(), of_abc);
}

TEST(Sha256, HashesTheBytesOfAFile) {
  const auto path = std::filesystem::path(testing::TempDir()) / "abc.txt";
  std::ofstream(path) << "abc";
  EXPECT_EQ(sha256_of_file(path), of_abc);
}

TEST(Sha256, RefusesAMissingFile) {
  try {
    sha256_of_file("/no/such/file");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::input_missing);
    EXPECT_NE(std::string(error.what()).find("/no/such/file"), std::string::npos);
  }
}

TEST(Sha256, RefusesAnEndlessDevice) {
  EXPECT_ERROR(sha256_of_file("/dev/zero"), Exit::input_missing, "/dev/zero: is not a file");
}

}  // namespace
}  // namespace piae
