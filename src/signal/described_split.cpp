#include "signal/described_split.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "signal/split.hpp"

namespace piae::signal {

void check_described_split(TomlTable& root) {
  auto table = root.optional_table("split");
  if (!table) return;
  const std::vector<SplitSetting> known = split_settings();
  std::string list;
  for (const SplitSetting& each : known) list += (list.empty() ? "" : ", ") + each.name;
  for (const auto& [key, node] : table->plain()) {
    const std::string name(key.str());
    const auto setting = std::ranges::find(known, name, &SplitSetting::name);
    if (setting == known.end()) table->refuse(name, "is unknown; known keys are " + list);
    const std::int64_t value = table->integer(name, setting->range);
    if (name == known_per_class && value == 0 && root.has("transfer")) {
      table->refuse(name,
                    "is 0, so no fault is known in any condition, but [transfer] says in which "
                    "they are; leave one of the two out");
    }
  }
}

}  // namespace piae::signal
