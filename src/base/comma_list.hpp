#pragma once

#include <functional>
#include <string>

namespace piae {

/// Joins the results of `text_of` for all elements with commas: comma_list(rows, &Row::name)
/// returns "vae, smote". Use fmt::join for plain strings. (clang-tidy 14 cannot parse std::views.)
template <class Range, class TextOf>
std::string comma_list(const Range& range, const TextOf& text_of) {
  std::string list;
  for (const auto& each : range) {
    if (!list.empty()) list += ", ";
    list += std::invoke(text_of, each);
  }
  return list;
}

}  // namespace piae
