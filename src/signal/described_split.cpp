#include "signal/described_split.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/comma_list.hpp"
#include "base/error.hpp"
#include "signal/meant_key.hpp"

namespace piae::signal {

namespace {

std::set<std::string> names_of_settings(const std::vector<SplitSetting>& settings) {
  std::set<std::string> names;
  for (const SplitSetting& setting : settings) names.insert(setting.name);
  return names;
}

}  // namespace

SplitSettings read_described_split(TomlTable& root) {
  SplitSettings settings;
  auto table = root.optional_table("split");
  if (!table) return settings;
  const std::vector<SplitSetting> known = split_settings();
  const std::string list = comma_list(known, &SplitSetting::name);
  for (const auto& [key, node] : table->plain()) {
    const std::string name(key.str());
    const auto setting = std::ranges::find(known, name, &SplitSetting::name);
    if (setting == known.end()) {
      const std::string meant = meant_key(name, names_of_settings(known));
      table->refuse(name,
                    "is unknown; known keys are " + list + (meant.empty() ? "" : "; " + meant));
    }
    settings.emplace(name, static_cast<std::size_t>(table->integer(name, setting->range)));
  }
  return settings;
}

SplitOptions split_options_of(const Description& description) {
  SplitOptions options;
  for (const auto& [name, value] : description.split) set(options, name, value);
  return options;
}

void require_sensible_split(const Description& description, const std::filesystem::path& file) {
  try {
    require_sensible(split_options_of(description));
  } catch (const Error& error) {
    throw Error(Exit::bad_input, file.string() + ": " + error.what() + "; change [split] in it");
  }
}

bool any_known(const SplitSettings& settings) {
  const auto known = settings.find(known_per_class);
  return known == settings.end() || known->second > 0;
}

}  // namespace piae::signal
