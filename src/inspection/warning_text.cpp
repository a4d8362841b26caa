#include "inspection/warning_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <stdexcept>

#include "base/comma_list.hpp"

namespace piae::inspection {

namespace {

/// A sample of one of a record's files.
struct Place {
  const FileCheck* file = nullptr;  ///< null if the record has one file
  std::size_t sample = 0;           ///< counted in the file
};

Place place_in(const RecordCheck& record, std::size_t sample) {
  if (record.files.size() < 2) return {.file = nullptr, .sample = sample};
  for (const FileCheck& file : record.files) {
    if (sample < file.samples) return {.file = &file, .sample = sample};
    sample -= file.samples;
  }
  throw std::logic_error("the record has fewer samples");
}

}  // namespace

std::string sample_text(const RecordCheck& record, std::size_t sample) {
  const Place place = place_in(record, sample);
  const std::string of_file = place.file == nullptr ? "" : " of " + place.file->name;
  return fmt::format("sample {}{}", place.sample, of_file);
}

std::string samples_text(const RecordCheck& record, std::size_t first, std::size_t last) {
  const Place from = place_in(record, first);
  const Place to = place_in(record, last);
  if (from.file != to.file) {
    return sample_text(record, first) + " to " + sample_text(record, last);
  }
  const std::string of_file = from.file == nullptr ? "" : " of " + from.file->name;
  return fmt::format("samples {} to {}{}", from.sample, to.sample, of_file);
}

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
