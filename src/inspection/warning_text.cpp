#include "inspection/warning_text.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/comma_list.hpp"

namespace piae::inspection {

std::string place_of(const signal::RecordSource& source) {
  return fmt::format("{} ({}, variable {})", source.name, source.file_text(), source.variable);
}

std::string names_of(const std::vector<const RecordCheck*>& records) {
  return comma_list(records, [](const RecordCheck* record) { return record->source.name; });
}

void add_for_each(std::vector<const RecordCheck*> records,
                  const std::function<std::string(const RecordCheck&)>& text,
                  std::vector<std::string>& lines) {
  constexpr std::size_t few = 3;
  if (records.size() > few) {
    const std::string first = text(*records.front());
    records.erase(records.begin());
    lines.push_back(fmt::format("{} (the same holds for {})", first, names_of(records)));
    return;
  }
  for (const RecordCheck* record : records) lines.push_back(text(*record));
}

}  // namespace piae::inspection
