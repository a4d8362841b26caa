#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "cli/options.hpp"

namespace piae::signal {

/// How a split deals the windows of a class out to the roles. signal/split.hpp describes both.
enum class Protocol {
  random,  ///< the paper's
  blocked  ///< contiguous blocks with gaps between them
};

/// The words for them, as an option.
const std::vector<cli::Word<Protocol>>& protocol_words();

/// "random" or "blocked": what artefacts store and tables show.
std::string to_string(Protocol protocol);

/// The attribute `protocol` of an artefact. Throws artefact::Refusal for a word that is neither.
Protocol read_protocol(const artefact::Reader& reader);

}  // namespace piae::signal
