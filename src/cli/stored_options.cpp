#include "cli/stored_options.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace piae::cli {

StoredOptions::Row& StoredOptions::add_row(const std::string& name, const std::string& help,
                                           const std::string& stored, const Range& range) {
  rows_.push_back({.name = name,
                   .group = group_,
                   .attribute = stored.empty() ? name : stored,
                   .help = help,
                   .range = range});
  std::ranges::replace(rows_.back().attribute, '-', '_');
  return rows_.back();
}

const StoredOptions::Row* StoredOptions::first_reversed() const {
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const bool begins =
        rows_[i].number != nullptr && rows_[i].name.find("-from") != std::string::npos;
    if (begins && *rows_[i].number > *rows_[i + 1].number) return &rows_[i];
  }
  return nullptr;
}

void StoredOptions::bind(const Options& command) const {
  for (const Row& row : rows_) {
    const std::string option = "--" + row.name;
    if (row.number != nullptr) {
      command.add(option, *row.number, row.help).check(within(row.range));
    } else if (row.whole != nullptr) {
      command.add(option, *row.whole, row.help)
          .check(whole_number(std::lround(row.range.low), std::lround(row.range.high)));
    } else {
      command.choose_word(option, row.words, row.words[row.place()], row.take, row.help);
    }
  }
}

void StoredOptions::require_order() const {
  const Row* const from = first_reversed();
  if (from == nullptr) return;
  throw Error(Exit::usage,
              fmt::format("--{} must not be above --{}", from->name, (from + 1)->name));
}

void StoredOptions::write(artefact::Writer& writer) const {
  std::string group;
  for (const Row& row : rows_) {
    if (row.group != group) writer.group(group = row.group);
    if (row.number != nullptr) {
      writer.attribute(group, row.attribute, *row.number);
    } else if (row.whole != nullptr) {
      writer.attribute(group, row.attribute, std::int64_t{*row.whole});
    } else {
      writer.attribute(group, row.attribute, row.words[row.place()]);
    }
  }
}

void StoredOptions::read(const artefact::Reader& reader) const {
  for (const Row& row : rows_) {
    if (row.number != nullptr) {
      *row.number = reader.real(row.group, row.attribute, row.range);
    } else if (row.whole != nullptr) {
      *row.whole = static_cast<int>(reader.integer(row.group, row.attribute, row.range));
    } else {
      const std::string text = reader.text(row.group, row.attribute);
      const auto found = std::ranges::find(row.words, text);
      if (found == row.words.end()) {
        reader.refuse(row.group + ", attribute " + row.attribute,
                      fmt::format("is {}; it must be {}", text, fmt::join(row.words, " or ")));
      }
      row.take(static_cast<std::size_t>(found - row.words.begin()));
    }
  }
  const Row* const from = first_reversed();
  if (from == nullptr) return;
  reader.refuse(from->group + ", attribute " + from->attribute,
                "is above " + (from + 1)->attribute);
}

}  // namespace piae::cli
