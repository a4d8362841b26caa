#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "storm/dice.hpp"

namespace piae::storm {

/// Changes the content of an artefact once or twice: an attribute, a dataset, a link, a type, a
/// shape or a name. Then renews its digests, as no stage would. May copy parts from one of
/// `others`. Returns a description of the changes.
std::string change_meaning(const std::filesystem::path& file,
                           const std::vector<std::filesystem::path>& others, Dice& dice);

}  // namespace piae::storm
