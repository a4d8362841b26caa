#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/error.hpp"
#include "base/range.hpp"
#include "cli/options.hpp"

namespace piae::zero {

/// A number of a struct of options: one row says what command line, artefact and checks need. Where
/// a name holds "-from", the next row is where that ends.
template <class Options>
struct Setting {
  const char* name;  ///< as on the command line, without its dashes
  double Options::*value;
  Range range;
  const char* help;
};

template <class Options>
using Settings = std::span<const Setting<Options>>;

/// Adds an option for each.
template <class Options>
void bind(const cli::Options& command, Options& options, Settings<Options> settings) {
  for (const Setting<Options>& one : settings) {
    command.add(std::string("--") + one.name, options.*one.value, one.help)
        .check(cli::within(one.range));
  }
}

/// What an attribute is called: as the option, with '_' for '-'.
inline std::string attribute_of(std::string_view name) {
  std::string attribute(name);
  std::ranges::replace(attribute, '-', '_');
  return attribute;
}

/// The first that ends before it begins; null where there is none.
template <class Options>
const Setting<Options>* first_reversed(const Options& options, Settings<Options> settings) {
  for (std::size_t i = 0; i + 1 < settings.size(); ++i) {
    const bool begins = std::string_view(settings[i].name).find("-from") != std::string_view::npos;
    if (begins && options.*settings[i].value > options.*settings[i + 1].value) return &settings[i];
  }
  return nullptr;
}

/// Throws Error(usage) for a range that ends before it begins.
template <class Options>
void require_order(const Options& options, Settings<Options> settings) {
  const Setting<Options>* const from = first_reversed(options, settings);
  if (from == nullptr) return;
  throw Error(Exit::usage, std::string("--") + from->name + " is above --" + (from + 1)->name +
                               "; it must not be");
}

/// In the artefact: attributes of a group.
template <class Options>
void write(artefact::Writer& writer, const std::string& group, const Options& options,
           Settings<Options> settings) {
  writer.group(group);
  for (const Setting<Options>& one : settings) {
    writer.attribute(group, attribute_of(one.name), options.*one.value);
  }
}

/// Throws artefact::Refusal also for a range that ends before it begins.
template <class Options>
void read(const artefact::Reader& reader, const std::string& group, Options& options,
          Settings<Options> settings) {
  for (const Setting<Options>& one : settings) {
    options.*one.value = reader.real(group, attribute_of(one.name), one.range);
  }
  const Setting<Options>* const from = first_reversed(options, settings);
  if (from != nullptr) {
    reader.refuse(group + ", attribute " + attribute_of(from->name),
                  "is above " + attribute_of((from + 1)->name));
  }
}

}  // namespace piae::zero
