#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "cli/options.hpp"

namespace piae::transfer {

/// Words of an option, in the artefact as on the command line, so that a model says what it does.
template <typename Choice>
using Words = std::vector<cli::Word<Choice>>;

template <typename Choice>
std::string word_of(Choice choice, const Words<Choice>& words) {
  return std::ranges::find(words, choice, &cli::Word<Choice>::value)->text;
}

/// Throws artefact::Refusal for another word; it names those that there are.
template <typename Choice>
Choice read_word(const artefact::Reader& reader, const std::string& group, const std::string& name,
                 const Words<Choice>& words) {
  const std::string text = reader.text(group, name);
  std::string known;
  for (const cli::Word<Choice>& word : words) {
    if (text == word.text) return word.value;
    known += (known.empty() ? "" : " or ") + std::string(word.text);
  }
  reader.refuse(group + ", attribute " + name, "is " + text + ", must be " + known);
}

}  // namespace piae::transfer
