#include "signal/protocol.hpp"

#include <stdexcept>

namespace piae::signal {

const std::vector<cli::Word<Protocol>>& protocol_words() {
  static const std::vector<cli::Word<Protocol>> words{{"random", Protocol::random},
                                                      {"blocked", Protocol::blocked}};
  return words;
}

std::string to_string(Protocol protocol) {
  for (const auto& [word, known] : protocol_words()) {
    if (protocol == known) return word;
  }
  throw std::logic_error("a protocol without a word");
}

Protocol read_protocol(const artefact::Reader& reader) {
  const std::string text = reader.text("/", "protocol");
  for (const auto& [word, protocol] : protocol_words()) {
    if (text == word) return protocol;
  }
  reader.refuse("/, attribute protocol", "is '" + text + "'; it must be random or blocked");
}

}  // namespace piae::signal
