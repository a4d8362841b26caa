#include "signal/meant_key.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace piae::signal {

namespace {

/// A unit other than a key's, and its size in the key's unit.
struct Unit {
  std::string_view given;
  std::string_view of_key;
  double factor;
};
constexpr std::array units{Unit{"hz", "rpm", 60},      Unit{"rps", "rpm", 60},
                           Unit{"khz", "hz", 1000},    Unit{"in", "mm", 25.4},
                           Unit{"inch", "mm", 25.4},   Unit{"inches", "mm", 25.4},
                           Unit{"cm", "mm", 10},       Unit{"m", "mm", 1000},
                           Unit{"um", "mm", 1e-3},     Unit{"mil", "mm", 0.0254},
                           Unit{"mils", "mm", 0.0254}, Unit{"rad", "deg", 180 / std::numbers::pi}};

/// Another word for a key.
struct Synonym {
  std::string_view given;
  std::string_view key;
};
constexpr std::array synonyms{Synonym{"column", "variable"},
                              Synonym{"channel", "variable"},
                              Synonym{"dataset", "variable"},
                              Synonym{"field", "variable"},
                              Synonym{"path", "file"},
                              Synonym{"filename", "file"},
                              Synonym{"files", "file"},
                              Synonym{"pattern", "file"},
                              Synonym{"fs", "sample_rate_hz"},
                              Synonym{"fs_hz", "sample_rate_hz"},
                              Synonym{"rate", "sample_rate_hz"},
                              Synonym{"rate_hz", "sample_rate_hz"},
                              Synonym{"sampling_rate", "sample_rate_hz"},
                              Synonym{"sampling_rate_hz", "sample_rate_hz"},
                              Synonym{"sampling_frequency", "sample_rate_hz"},
                              Synonym{"sampling_frequency_hz", "sample_rate_hz"},
                              Synonym{"rpm", "shaft_speed_rpm"},
                              Synonym{"speed", "shaft_speed_rpm"},
                              Synonym{"speed_rpm", "shaft_speed_rpm"},
                              Synonym{"label", "class"},
                              Synonym{"fault", "defect"},
                              Synonym{"type", "defect"},
                              Synonym{"size_mm", "defect_size_mm"},
                              Synonym{"fault_size_mm", "defect_size_mm"},
                              Synonym{"load", "condition"},
                              Synonym{"state", "condition"},
                              Synonym{"unit", "unit_m_per_s2"},
                              Synonym{"scale", "unit_m_per_s2"},
                              Synonym{"sensitivity", "unit_m_per_s2"},
                              Synonym{"rollers", "balls"},
                              Synonym{"elements", "balls"},
                              Synonym{"rolling_elements", "balls"},
                              Synonym{"number_of_balls", "balls"},
                              Synonym{"n_balls", "balls"},
                              Synonym{"model", "designation"},
                              Synonym{"type", "designation"},
                              Synonym{"name", "designation"},
                              Synonym{"number", "designation"},
                              Synonym{"sha", "sha256"},
                              Synonym{"checksum", "sha256"}};

/// Other words for each defect.
constexpr std::array defects{Synonym{"ball", "roller"},
                             Synonym{"balls", "roller"},
                             Synonym{"rolling element", "roller"},
                             Synonym{"element", "roller"},
                             Synonym{"b", "roller"},
                             Synonym{"inner race", "inner"},
                             Synonym{"inner ring", "inner"},
                             Synonym{"ir", "inner"},
                             Synonym{"outer race", "outer"},
                             Synonym{"outer ring", "outer"},
                             Synonym{"or", "outer"},
                             Synonym{"healthy", "none"},
                             Synonym{"normal", "none"},
                             Synonym{"good", "none"},
                             Synonym{"ok", "none"},
                             Synonym{"cage", "other"},
                             Synonym{"imbalance", "other"},
                             Synonym{"misalignment", "other"},
                             Synonym{"looseness", "other"}};

struct SplitKey {
  std::string_view stem;
  std::string_view unit;
};

/// Splits "shaft_speed_hz" at its last underscore.
SplitKey split_key(std::string_view key) {
  const std::size_t end = key.rfind('_');
  if (end == std::string_view::npos) return {key, {}};
  return {key.substr(0, end), key.substr(end + 1)};
}

/// True for a key with a word that adds nothing, such as bpfo_order or class_name.
bool is_with_filler(std::string_view given, std::string_view key) {
  const auto [stem, filler] = split_key(given);
  return stem == key && (filler == "order" || filler == "name");
}

/// Returns the size of the given unit in the key's unit, if both name the same quantity.
std::optional<double> factor_between(std::string_view given, std::string_view key) {
  constexpr double standard_gravity_m_per_s2 = 9.80665;
  if (given == "unit_g" && key == "unit_m_per_s2") return standard_gravity_m_per_s2;
  const auto [stem, unit] = split_key(given);
  const auto [known_stem, known_unit] = split_key(key);
  if (stem != known_stem) return std::nullopt;
  const auto* const found = std::ranges::find_if(
      units,
      [&, u = unit, k = known_unit](const Unit& x) { return x.given == u && x.of_key == k; });
  return found == units.end() ? std::nullopt : std::optional(found->factor);
}

/// Returns the Levenshtein distance: the fewest letters to insert, delete or replace.
std::size_t letters_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return small;
}

bool is_near(std::string_view given, std::string_view key) {
  constexpr std::size_t shortest = 4;
  return given.size() >= shortest && letters_between(given, key) <= 2;
}

}  // namespace

std::string meant_key(const std::string& given, const std::set<std::string>& known) {
  const std::string name = lower(given);
  for (const std::string& key : known) {
    if (lower(key) == name || split_key(key).stem == name || is_with_filler(name, key)) {
      return "write " + key;
    }
    if (const auto factor = factor_between(name, key)) {
      return fmt::format("write {}, {:g} times the value", key, *factor);
    }
  }
  const auto* const synonym = std::ranges::find_if(synonyms, [&](const Synonym& s) {
    return s.given == name && known.contains(std::string(s.key));
  });
  if (synonym != synonyms.end()) return "write " + std::string(synonym->key);
  const auto near = std::ranges::find_if(
      known, [&](const std::string& key) { return is_near(name, lower(key)); });
  return near == known.end() ? "" : "write " + *near;
}

std::string meant_defect(const std::string& given) {
  std::string word = lower(given);
  std::ranges::replace(word, '_', ' ');
  if (std::ranges::count(defects, word, &Synonym::key) > 0) return word;
  const auto* const found = std::ranges::find(defects, word, &Synonym::given);
  return found == defects.end() ? "" : std::string(found->key);
}

}  // namespace piae::signal
