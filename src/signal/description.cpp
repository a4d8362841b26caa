#include "signal/description.hpp"

#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <string_view>

#include "base/error.hpp"
#include "bearing/defect.hpp"
#include "bearing/kinematics.hpp"
#include "bearing/orders.hpp"
#include "signal/bearing_table.hpp"
#include "signal/described_conditions.hpp"
#include "signal/described_file.hpp"
#include "signal/described_split.hpp"
#include "signal/description_file.hpp"
#include "signal/meant_key.hpp"
#include "signal/ranges.hpp"
#include "signal/record_files.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

std::string plain_name(TomlTable& table, const std::string& key) {
  std::string name = table.text(key);
  if (!ranges::is_plain_name(name)) {
    table.refuse(key, "'" + name + "' " + ranges::plain_name_rule);
  }
  return name;
}

/// Refuses frequencies in Hz instead of orders. Values that give a usual bearing when divided by
/// the shaft frequency are taken for Hz. An ftf below 0.5 proves orders, as of a large bearing.
void require_orders(const TomlTable& table, const bearing::Orders& orders, double shaft_hz) {
  constexpr double most_balls = 40;
  constexpr double tolerance = 0.01;
  const double sum = orders.bpfo + orders.bpfi;
  const double balls = std::round(sum / shaft_hz);
  const bool is_usual =
      balls >= 3 && balls <= most_balls && std::abs(sum / shaft_hz - balls) <= tolerance * balls;
  if (sum <= most_balls || !is_usual || (orders.ftf && *orders.ftf < 0.5)) return;
  table.refuse(
      "bpfo",
      fmt::format("= {:g} and bpfi = {:g} seem to be in Hz, not in multiples of the shaft "
                  "frequency, {:.5g} Hz; write {:.4g} and {:.4g}, or add ftf if they are multiples",
                  orders.bpfo, orders.bpfi, shaft_hz, orders.bpfo / shaft_hz,
                  orders.bpfi / shaft_hz));
}

bearing::Geometry bearing_by_orders(TomlTable& table, double shaft_hz) {
  bearing::Orders orders;
  orders.bpfo = table.number("bpfo", ranges::fault_order);
  orders.bpfi = table.number("bpfi", ranges::fault_order);
  orders.bsf = table.optional_number("bsf", ranges::fault_order);
  orders.ftf = table.optional_number("ftf", ranges::fault_order);
  require_orders(table, orders, shaft_hz);
  try {
    return bearing::geometry_of(orders);
  } catch (const Error& error) {
    table.refuse("bpfo", std::string("and the other orders are refused: ") + error.what());
  }
}

bool is_by_orders(const TomlTable& bearing) {
  return std::ranges::any_of(order_keys, [&](const char* key) { return bearing.has(key); });
}

void require_no_dimensions(const TomlTable& bearing) {
  for (const char* const key : dimension_keys) {
    if (!bearing.has(key)) continue;
    bearing.refuse(key, "is given, but so is an order; give dimensions or orders, not both");
  }
}

bearing::Geometry described_bearing(TomlTable table, double shaft_hz) {
  std::vector<std::string> keys{"designation"};
  keys.insert(keys.end(), order_keys.begin(), order_keys.end());
  keys.insert(keys.end(), dimension_keys.begin(), dimension_keys.end());
  table.require_only(keys);
  if (is_by_orders(table)) {
    require_no_dimensions(table);
    return bearing_by_orders(table, shaft_hz);
  }
  bearing::Geometry bearing;
  bearing.balls = static_cast<int>(table.integer("balls", ranges::balls));
  bearing.ball_diameter_mm = table.number("ball_diameter_mm", ranges::length_mm);
  bearing.pitch_diameter_mm = table.number("pitch_diameter_mm", ranges::length_mm);
  bearing.inner_raceway_mm = table.optional_number("inner_raceway_mm", ranges::length_mm)
                                 .value_or(bearing.pitch_diameter_mm - bearing.ball_diameter_mm);
  bearing.outer_raceway_mm = table.optional_number("outer_raceway_mm", ranges::length_mm)
                                 .value_or(bearing.pitch_diameter_mm + bearing.ball_diameter_mm);
  bearing.contact_angle_deg = table.number("contact_angle_deg", ranges::contact_angle_deg);
  return bearing;
}

Defect described_defect(TomlTable& table) {
  const std::string word = table.text("defect");
  try {
    return parse_defect(word);
  } catch (const Error& error) {
    const std::string meant = meant_defect(word);
    table.refuse("defect", std::string("holds an ") + error.what() +
                               (meant.empty() ? "" : "; write '" + meant + "'"));
  }
}

/// Refuses a defect size in a bearing without dimensions. `table` is a class or a record.
void refuse_size_without_dimensions(const TomlTable& root, const TomlTable& table) {
  const bool has_dimensions = !root.plain()["bearing"]["bpfo"];
  if (has_dimensions || !table.has("defect_size_mm")) return;
  table.refuse("defect_size_mm",
               "needs a bearing with dimensions, but [bearing] gives only its orders; remove it");
}

/// Reads the defect size of a class or of one of its records.
std::optional<double> read_size(TomlTable& table, Defect defect) {
  const auto size = table.optional_number("defect_size_mm", ranges::defect_size_mm);
  if (size && !bearing::causes_impacts(defect)) {
    table.refuse("defect_size_mm",
                 "is not possible if the defect is '" + to_string(defect) + "'; remove it");
  }
  return size;
}

ClassInfo read_class(TomlTable& table) {
  ClassInfo info;
  info.name = plain_name(table, "name");
  info.defect = described_defect(table);
  info.defect_size_mm = read_size(table, info.defect).value_or(0);
  return info;
}

void require_possible_defect(const DatasetInfo& info, const ClassInfo& c, double size_mm,
                             const TomlTable& table) {
  try {
    bearing::validate(info.bearing, {c.defect, size_mm});
  } catch (const Error& error) {
    table.refuse("defect_size_mm", std::string("is refused: ") + error.what());
  }
}

Label label_of(const DatasetInfo& info, TomlTable& record) {
  const std::string name = record.text("class");
  const auto found = std::ranges::find(info.classes, name, &ClassInfo::name);
  if (found == info.classes.end()) record.refuse("class", "'" + name + "' is not a [[class]]");
  return static_cast<Label>(found - info.classes.begin());
}

/// Reads an address that `make data` may pass to a program: only http and https.
std::string read_url(TomlTable& record, const std::vector<std::string>& files) {
  std::string url = record.optional_text("url");
  if (!url.empty() && (files.size() > 1 || is_pattern(files.front()))) {
    record.refuse("url", "is the address of one file, but this record has several; remove it");
  }
  const bool of_the_web = url.starts_with("https://") || url.starts_with("http://");
  const bool one_word = url.find(' ') == std::string::npos;
  if (!url.empty() && !(of_the_web && one_word)) {
    record.refuse("url", "must begin with https:// or http://, and have no spaces");
  }
  return url;
}

void require_sha256(const TomlTable& record, const std::string& sum) {
  const bool hexadecimal = sum.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!sum.empty() && (sum.size() != 64 || !hexadecimal)) {
    record.refuse("sha256", "must be 64 hexadecimal digits in lower case");
  }
}

/// Reads the time between the starts of two files, which only a record of several files has.
std::optional<double> read_snapshot_interval(TomlTable& record,
                                             const std::vector<std::string>& files) {
  const auto interval_s =
      record.optional_number("snapshot_interval_s", ranges::snapshot_interval_s);
  if (interval_s && files.size() == 1 && !is_pattern(files.front())) {
    record.refuse("snapshot_interval_s",
                  "is the time between two files, but this record has only one; give a list or a "
                  "pattern of files, or remove it");
  }
  return interval_s;
}

RecordSource described_record(TomlTable& table, const DatasetInfo& info) {
  RecordSource record;
  record.label = label_of(info, table);
  record.files = read_file_names(table);
  record.variable = read_variable(table, "variable");
  record.sample_rate_hz = table.number("sample_rate_hz", ranges::described_rate_hz);
  record.speed = read_speed_source(table);
  record.shaft_speed_rpm = info.shaft_speed_rpm;
  if (!record.speed) {
    record.shaft_speed_rpm = table.optional_number("shaft_speed_rpm", ranges::shaft_speed_rpm)
                                 .value_or(info.shaft_speed_rpm);
  }
  record.condition = table.has("condition") ? read_condition_name(table, "condition") : "";
  const ClassInfo& c = info.class_of(record.label);
  record.defect_size_mm = read_size(table, c.defect);
  if (record.defect_size_mm) require_possible_defect(info, c, *record.defect_size_mm, table);
  record.unit_m_per_s2 = table.optional_number("unit_m_per_s2", ranges::unit_m_per_s2);
  record.offset = table.optional_number("offset", ranges::acceleration).value_or(0);
  record.snapshot_interval_s = read_snapshot_interval(table, record.files);
  record.sha256 = table.optional_text("sha256");
  require_sha256(table, record.sha256);
  record.url = read_url(table, record.files);
  table.finish();
  return record;
}

/// Returns a suffix such as "-07". All numbers have the same number of digits, at least two, so
/// that names sort by number.
std::string numbered(std::size_t number, std::size_t last) {
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(last).size());
  std::string text = std::to_string(number);
  text.insert(0, digits - text.size(), '0');
  return "-" + text;
}

/// Names a single record "IR007", and several "IR007-01", "IR007-02", ... in file order.
void name_records(const DatasetInfo& info, std::vector<RecordSource>& records) {
  std::map<std::string, std::vector<RecordSource*>> called;
  for (RecordSource& record : records)
    called[record_stem(info.class_of(record.label).name, record.condition)].push_back(&record);
  for (const auto& [name, namesakes] : called) {
    for (std::size_t i = 0; i < namesakes.size(); ++i) {
      namesakes[i]->name = name;
      if (namesakes.size() > 1) namesakes[i]->name += numbered(i + 1, namesakes.size());
    }
  }
}

/// Sets a missing class size to the mean of its known records' sizes.
void set_mean_sizes(const std::vector<TomlTable>& classes, const std::vector<RecordSource>& records,
                    DatasetInfo& info) {
  const auto is_known = [&](const RecordSource& record) {
    const std::int32_t condition = info.condition_called(record.condition);
    return condition == every_condition ||
           info.conditions[static_cast<std::size_t>(condition)].known;
  };
  for (const Label label : info.fault_labels()) {
    if (classes[index_of(label)].has("defect_size_mm")) continue;
    std::vector<double> sizes;
    std::size_t known = 0;
    for (const RecordSource& record : records) {
      if (record.label != label || !is_known(record)) continue;
      ++known;
      if (record.defect_size_mm) sizes.push_back(*record.defect_size_mm);
    }
    if (sizes.empty()) continue;  // unknown size
    if (sizes.size() < known) {
      classes[index_of(label)].refuse("defect_size_mm",
                                      "is missing: only some of its records have one; give it for "
                                      "the class or for all its records");
    }
    const double sum = std::accumulate(sizes.begin(), sizes.end(), 0.0);
    info.classes[index_of(label)].defect_size_mm = sum / static_cast<double>(sizes.size());
  }
}

void require_described_records(const fs::path& file, const TomlTable& root,
                               const Description& description) {
  for (const Label label : description.info.labels()) {
    if (std::ranges::count(description.records, label, &RecordSource::label) > 0) continue;
    throw Error(Exit::bad_input, file.string() + ": class " +
                                     description.info.class_of(label).name + " has no [[record]]" +
                                     root.given_for("record"));
  }
}

void require_different_names(const fs::path& file, const std::vector<RecordSource>& records) {
  const auto twice = std::ranges::adjacent_find(records, {}, &RecordSource::name);
  if (twice == records.end()) return;
  throw Error(Exit::bad_input, file.string() + ": two records would have the name " + twice->name +
                                   "; rename the class that ends in a number");
}

/// Returns the records' sample rate for a data set without its own. All records must have the same.
double common_rate(const TomlTable& root, const std::vector<RecordSource>& records) {
  for (const RecordSource& record : records) {
    if (record.sample_rate_hz != records.front().sample_rate_hz) {
      root.refuse("sample_rate_hz",
                  "is missing, and the records " + records.front().file_text() + " and " +
                      record.file_text() +
                      " have different rates; give the rate to which all are resampled");
    }
  }
  return records.front().sample_rate_hz;
}

}  // namespace

std::string RecordSource::file_text() const { return fmt::format("{}", fmt::join(files, ", ")); }

std::optional<std::string> RecordSource::tacho_file() const {
  return speed && !speed->file.empty() ? std::optional(speed->file) : std::nullopt;
}

void require_possible(const DatasetInfo& info, const TomlTable& root,
                      const std::vector<TomlTable>& classes) {
  try {
    if (info.has_bearing) bearing::validate(info.bearing);
  } catch (const Error& error) {
    root.refuse("bearing", std::string("is refused: ") + error.what());
  }
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const ClassInfo& c = info.classes[i];
    const bool causes_impacts = bearing::causes_impacts(c.defect);
    if (causes_impacts && !info.has_bearing) {
      root.refuse("bearing",
                  "is missing: it determines the impact rate of class " + c.name +
                      "; for an unknown bearing, and for a fault outside raceways and balls, write "
                      "defect = \"other\"");
    }
    refuse_size_without_dimensions(root, classes[i]);
    const bool is_of_unknown_size =
        causes_impacts && c.defect_size_mm == 0 && !classes[i].has("defect_size_mm");
    if (!is_of_unknown_size) require_possible_defect(info, c, c.defect_size_mm, classes[i]);
  }
}

void require_simulable(const DatasetInfo& info, const std::vector<TomlTable>& classes) {
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const ClassInfo& c = info.classes[i];
    if (c.defect == Defect::other) {
      classes[i].refuse("defect",
                        "is 'other', which cannot be simulated; write outer, inner or roller");
    }
    if (c.defect != Defect::none && c.defect_size_mm == 0) {
      classes[i].refuse("defect_size_mm", "is missing, but the simulation needs it");
    }
  }
}

DatasetInfo read_info(TomlTable& root, std::vector<TomlTable>& classes) {
  if (!ranges::classes.holds(static_cast<double>(classes.size()))) {
    root.refuse("class", "is given " + std::to_string(classes.size()) +
                             " times; the number of classes " + ranges::classes.rule());
  }
  DatasetInfo info;
  info.name = plain_name(root, "name");
  info.shaft_speed_rpm = root.number("shaft_speed_rpm", ranges::shaft_speed_rpm);
  info.unit_m_per_s2 =
      root.optional_number("unit_m_per_s2", ranges::unit_m_per_s2).value_or(info.unit_m_per_s2);
  auto bearing = root.optional_table("bearing");
  info.has_bearing = bearing.has_value();
  if (bearing) info.bearing = described_bearing(*bearing, info.shaft_speed_rpm / 60);
  for (TomlTable& table : classes) {
    const ClassInfo next = read_class(table);
    if (std::ranges::find(info.classes, next.name, &ClassInfo::name) != info.classes.end()) {
      table.refuse("name", "'" + next.name + "' is given twice");
    }
    info.classes.push_back(next);
  }
  try {
    (void)info.healthy_label();
  } catch (const Error& error) {
    root.refuse("class", std::string("is refused: ") + error.what());
  }
  return info;
}

Description read_description(const fs::path& file) {
  TomlTable root(file);
  Description description;
  std::vector<TomlTable> classes = root.tables("class");
  description.info = read_info(root, classes);
  for (const TomlTable& table : classes) table.finish();
  for (TomlTable& table : root.tables("record")) {
    description.records.push_back(described_record(table, description.info));
    refuse_size_without_dimensions(root, table);
  }
  const auto rate = root.optional_number("sample_rate_hz", ranges::sample_rate_hz);
  require_described_records(file, root, description);
  description.speed_search_percent =
      root.optional_number("speed_search_percent", ranges::speed_search_percent).value_or(0);
  description.split = read_described_split(root);
  description.info.conditions = read_described_conditions(
      root, description.info, description.records, any_known(description.split));
  set_mean_sizes(classes, description.records, description.info);
  require_possible(description.info, root, classes);
  root.finish();
  description.info.sample_rate_hz = rate ? *rate : common_rate(root, description.records);
  if (!ranges::sample_rate_hz.holds(description.info.sample_rate_hz)) {
    root.refuse("sample_rate_hz",
                "is taken from the records, but " + ranges::sample_rate_hz.rule());
  }
  name_records(description.info, description.records);
  std::ranges::sort(description.records, {}, &RecordSource::name);
  require_different_names(file, description.records);
  description.bearing_table = bearing_table_of(file);
  return description;
}

std::vector<std::string> recordings_of(const Description& description, const fs::path& folder) {
  std::vector<std::string> files;
  for (const RecordSource& source : description.records) {
    std::ranges::copy(files_of(source.files, folder), std::back_inserter(files));
    if (source.tacho_file()) files.push_back(*source.tacho_file());
  }
  return files;
}

std::string list_of_sources(const fs::path& description, const fs::path& folder) {
  std::string list;
  if (read_description_file(description).contains("simulation")) return list;
  const auto or_dash = [](const std::string& text) { return text.empty() ? "-" : text; };
  for (const RecordSource& source : read_description(description).records) {
    std::vector<std::string> names = files_of(source.files, folder);
    if (names.empty()) names = source.files;
    const std::string sha256 = names.size() == 1 ? source.sha256 : "";
    for (const std::string& name : names) {
      list += or_dash(sha256) + "  " + name + "  " + or_dash(source.url) + '\n';
    }
    if (source.tacho_file()) list += "-  " + *source.tacho_file() + "  -\n";
  }
  return list;
}

}  // namespace piae::signal
