#include "inspection/warning_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <stdexcept>

#include "base/comma_list.hpp"

namespace piae::inspection {

namespace {

struct SamplePlace {
  std::size_t sample = 0;  ///< counted in its file
  std::string of_file = {};
};

SamplePlace place_in(const RecordCheck& record, std::size_t sample) {
  if (record.files.size() < 2) return {.sample = sample};
  for (const FileCheck& file : record.files) {
    if (sample < file.samples) return {.sample = sample, .of_file = of_file(record, file)};
    sample -= file.samples;
  }
  throw std::logic_error("the record has fewer samples");
}

}  // namespace

std::string of_file(const RecordCheck& record, const FileCheck& file) {
  return record.files.size() > 1 ? " of " + file.name : "";
}

std::string sample_text(const RecordCheck& record, std::size_t sample) {
  const SamplePlace place = place_in(record, sample);
  return fmt::format("sample {}{}", place.sample, place.of_file);
}

std::string samples_text(const RecordCheck& record, std::size_t first, std::size_t last) {
  const SamplePlace from = place_in(record, first);
  const SamplePlace to = place_in(record, last);
  if (from.of_file != to.of_file) {
    return sample_text(record, first) + " to " + sample_text(record, last);
  }
  return fmt::format("samples {} to {}{}", from.sample, to.sample, from.of_file);
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
