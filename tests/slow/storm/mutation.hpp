#pragma once

#include <string>
#include <vector>

#include "storm/dice.hpp"

namespace piae::storm {

/// Returns a copy with one to four changes: flipped bits, replaced bytes, limits of number types,
/// runs of one byte, pieces removed, doubled, moved or taken from `other`, or a missing end.
std::string mutated(const std::string& good, const std::string& other, Dice& dice);

/// A block of an HDF5 file that ends with its checksum.
struct Block {
  std::size_t at = 0;
  std::size_t size = 0;  ///< without the four bytes of the checksum
};

/// Returns the checksummed blocks of a good HDF5 file in the format of version 1.10.
std::vector<Block> checksummed_blocks(const std::string& good);

/// Renews the checksums of these blocks, as an attacker would.
void renew_checksums(std::string& bytes, const std::vector<Block>& blocks);

/// Returns a copy with changes inside the blocks only, with valid checksums.
std::string mutated_with_checksums(const std::string& good, const std::vector<Block>& blocks,
                                   Dice& dice);

}  // namespace piae::storm
