#pragma once

#include <functional>
#include <string>

namespace piae {

/// Returns what `text_of` gives of each element, with commas between: comma_list(rows, &Row::name)
/// is "vae, smote". Lists of plain strings are joined by fmt::join. (clang-tidy 14 cannot read
/// std::views.)
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
