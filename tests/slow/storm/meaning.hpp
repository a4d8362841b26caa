#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "storm/dice.hpp"

namespace piae::storm {

/// Changes what an artefact says, once or twice: an attribute, a dataset, a link, a type, a shape,
/// a name; and makes its digests right again, as no stage would. Pieces may come from one of
/// `others`. Returns what was changed, in words.
std::string change_meaning(const std::filesystem::path& file,
                           const std::vector<std::filesystem::path>& others, Dice& dice);

}  // namespace piae::storm
