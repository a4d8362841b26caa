#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "cli/options.hpp"

namespace piae::signal {

/// Assignment of the windows of a class to roles. signal/split.hpp describes both protocols.
enum class Protocol {
  random,  ///< the paper's
  blocked  ///< contiguous blocks with gaps between them
};

/// Returns the protocols' words, for an option.
const std::vector<cli::Word<Protocol>>& protocol_words();

/// Returns "random" or "blocked", the word in artefacts and tables.
std::string to_string(Protocol protocol);

/// Reads the attribute `protocol` of an artefact. Throws artefact::Refusal for any other word.
Protocol read_protocol(const artefact::Reader& reader);

}  // namespace piae::signal
