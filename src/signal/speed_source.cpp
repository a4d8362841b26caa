#include "signal/speed_source.hpp"

#include "signal/described_file.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

std::optional<SpeedSource> read_speed_source(TomlTable& record) {
  const std::string key = "shaft_speed_rpm";
  const auto given = record.plain()[key];
  if (given.is_string()) return SpeedSource{.variable = read_variable(record, key)};
  if (!given.is_table()) return std::nullopt;
  TomlTable tacho = record.table(key);
  SpeedSource source;
  source.file = tacho.text("file");
  require_file_name(tacho, source.file);
  source.variable = read_variable(tacho, "variable");
  source.pulses_per_turn = tacho.optional_number("pulses_per_turn", ranges::pulses_per_turn)
                               .value_or(source.pulses_per_turn);
  tacho.finish();
  return source;
}

}  // namespace piae::signal
