#pragma once

#include <string>
#include <vector>

#include "storm/dice.hpp"

namespace piae::storm {

/// A copy with one to four changes: bits turned, bytes and numbers replaced by those that programs
/// stumble over, runs of one byte, pieces left out, doubled, moved, or taken from `other`, and the
/// end cut off.
std::string mutated(const std::string& good, const std::string& other, Dice& dice);

/// A block of an HDF5 file that ends with its checksum.
struct Block {
  std::size_t at = 0;
  std::size_t size = 0;  ///< without the checksum's four bytes
};

/// The checksummed blocks of a good HDF5 file of version 1.10's format.
std::vector<Block> checksummed_blocks(const std::string& good);

/// Makes the checksums of these blocks right again, as somebody who means harm would.
void renew_checksums(std::string& bytes, const std::vector<Block>& blocks);

/// A copy of which bytes inside the blocks alone are changed, with good checksums.
std::string mutated_with_checksums(const std::string& good, const std::vector<Block>& blocks,
                                   Dice& dice);

}  // namespace piae::storm
