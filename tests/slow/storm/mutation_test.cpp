#include "storm/mutation.hpp"

#include <gtest/gtest.h>

#include <set>

#include "artefact/writer.hpp"
#include "storm/files.hpp"
#include "support/folder.hpp"

namespace piae::storm {
namespace {

std::string artefact_in(const Folder& folder) {
  artefact::Writer writer("windows");
  writer.numbers("/windows", std::vector<double>{1, 2, 3});
  writer.attribute("/", "seed", std::int64_t{3});
  writer.save(folder / "a.h5", {"test", "", {}});
  return bytes_of(folder / "a.h5");
}

TEST(Mutation, DependsOnlyOnTheSeedAndTheIndex) {
  const std::string good(1000, 'x');
  std::set<std::string> seen;
  for (std::size_t i = 0; i < 50; ++i) {
    Dice once(7, i);
    Dice again(7, i);
    const std::string bytes = mutated(good, good, once);
    EXPECT_EQ(bytes, mutated(good, good, again));
    seen.insert(bytes);
  }
  EXPECT_GT(seen.size(), 40U);
}

TEST(Mutation, AcceptsEmptyInput) {
  for (std::size_t i = 0; i < 200; ++i) {
    Dice dice(1, i);
    EXPECT_LT(mutated("", "", dice).size(), 100U);
  }
}

TEST(Checksums, AreFoundAndCorrected) {
  const Folder folder;
  const std::string good = artefact_in(folder);
  const std::vector<Block> blocks = checksummed_blocks(good);
  // At least the superblock, the root, its provenance and the dataset.
  EXPECT_GE(blocks.size(), 4U);
  EXPECT_EQ(blocks.front().at, 0U);
  std::string bytes = good;
  renew_checksums(bytes, blocks);
  EXPECT_EQ(bytes, good);
  // A block with another byte is found again only if its checksum is the new one.
  for (const Block& block : blocks) {
    bytes = good;
    bytes[block.at + block.size - 1] ^= 1;
    EXPECT_LT(checksummed_blocks(bytes).size(), blocks.size());
    renew_checksums(bytes, blocks);
    EXPECT_EQ(checksummed_blocks(bytes).size(), blocks.size());
  }
}

TEST(Checksums, LieWithinBytesThatAreChanged) {
  const Folder folder;
  const std::string good = artefact_in(folder);
  const std::vector<Block> blocks = checksummed_blocks(good);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    Dice dice(1, i);
    std::string bytes = mutated_with_checksums(good, blocks, dice);
    EXPECT_EQ(bytes.size(), good.size());
    if (bytes != good) ++changed;
    const std::string as_it_was = bytes;
    renew_checksums(bytes, blocks);
    EXPECT_EQ(bytes, as_it_was);
  }
  EXPECT_GT(changed, 15U);
}

}  // namespace
}  // namespace piae::storm
