#include "signal/dataset_info.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "base/error.hpp"
#include "bearing/kinematics.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

constexpr std::array<const char*, 5> defect_words{"none", "outer", "inner", "roller", "other"};

bearing::Geometry read_bearing(const artefact::Reader& reader) {
  const auto length_mm = [&](const std::string& name) {
    return reader.real("/bearing", name, ranges::length_mm);
  };
  return {
      .balls = static_cast<int>(reader.integer("/bearing", "balls", ranges::balls)),
      .ball_diameter_mm = length_mm("ball_diameter_mm"),
      .pitch_diameter_mm = length_mm("pitch_diameter_mm"),
      .inner_raceway_mm = length_mm("inner_raceway_mm"),
      .outer_raceway_mm = length_mm("outer_raceway_mm"),
      .contact_angle_deg = reader.real("/bearing", "contact_angle_deg", ranges::contact_angle_deg)};
}

void write_bearing(artefact::Writer& writer, const bearing::Geometry& bearing) {
  writer.group("/bearing");
  writer.attribute("/bearing", "balls", std::int64_t{bearing.balls});
  writer.attribute("/bearing", "ball_diameter_mm", bearing.ball_diameter_mm);
  writer.attribute("/bearing", "pitch_diameter_mm", bearing.pitch_diameter_mm);
  writer.attribute("/bearing", "inner_raceway_mm", bearing.inner_raceway_mm);
  writer.attribute("/bearing", "outer_raceway_mm", bearing.outer_raceway_mm);
  writer.attribute("/bearing", "contact_angle_deg", bearing.contact_angle_deg);
}

void require_class_names(const artefact::Reader& reader, const std::vector<std::string>& names) {
  const std::string path = "/classes/name";
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string which = "of class " + std::to_string(i) + " ";
    if (!ranges::is_plain_name(names[i])) reader.refuse(path, which + ranges::plain_name_rule);
    if (!seen.insert(names[i]).second) reader.refuse(path, "has " + names[i] + " twice");
  }
}

Defect read_defect(const artefact::Reader& reader, const std::string& word) {
  try {
    return parse_defect(word);
  } catch (const Error&) {
    reader.refuse("/classes/defect",
                  "holds a word other than none, outer, inner, roller and other");
  }
}

std::vector<ClassInfo> read_classes(const artefact::Reader& reader) {
  const std::vector<std::string> names = reader.strings("/classes/name");
  if (!ranges::classes.holds(static_cast<double>(names.size()))) {
    reader.refuse("/classes/name", "names " + std::to_string(names.size()) + " classes, which " +
                                       ranges::classes.rule());
  }
  const std::vector<std::string> defects = reader.strings("/classes/defect");
  const std::string sizes_path = "/classes/defect_size_mm";
  const std::vector<double> sizes = reader.numbers<double>(sizes_path, {names.size()}).values;
  if (defects.size() != names.size()) {
    reader.refuse("/classes/defect", "does not match /classes/name");
  }
  require_class_names(reader, names);
  reader.require_all(sizes_path, sizes, ranges::defect_size_mm);
  std::vector<ClassInfo> classes;
  for (std::size_t i = 0; i < names.size(); ++i) {
    classes.push_back({names[i], read_defect(reader, defects[i]), sizes[i]});
  }
  return classes;
}

/// Refuses an impossible bearing, defect or list of classes.
void refuse_impossible(const artefact::Reader& reader, const DatasetInfo& info) {
  try {
    (void)info.healthy_label();
    if (info.has_bearing) bearing::validate(info.bearing);
    for (const ClassInfo& c : info.classes) {
      if (bearing::causes_impacts(c.defect) && !info.has_bearing) {
        throw Error(Exit::bad_input, "class " + c.name + " needs a bearing, but none is described");
      }
      const bool is_of_unknown_size = bearing::causes_impacts(c.defect) && c.defect_size_mm == 0;
      if (!is_of_unknown_size) bearing::validate(info.bearing, {c.defect, c.defect_size_mm});
    }
  } catch (const Error& error) {
    reader.refuse("/bearing or /classes", std::string("are invalid: ") + error.what());
  }
}

std::vector<std::int32_t> conditions_for(const std::vector<Condition>& conditions,
                                         bool Condition::*use) {
  if (conditions.empty()) return {every_condition};
  std::vector<std::int32_t> indices;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].*use) indices.push_back(static_cast<std::int32_t>(i));
  }
  return indices;
}

double mean_speed_rpm(const DatasetInfo& info, const std::vector<std::int32_t>& conditions) {
  double sum = 0;
  for (const std::int32_t condition : conditions) sum += info.speed_rpm(condition);
  return sum / static_cast<double>(conditions.size());
}

}  // namespace

std::string to_string(Defect defect) { return defect_words[static_cast<std::size_t>(defect)]; }

Defect parse_defect(const std::string& word) {
  for (std::size_t i = 0; i < defect_words.size(); ++i) {
    if (word == defect_words[i]) return static_cast<Defect>(i);
  }
  throw Error(Exit::bad_input,
              "unknown defect '" + word + "'; known defects: none, outer, inner, roller, other");
}

std::vector<Label> DatasetInfo::labels() const {
  std::vector<Label> all(classes.size());
  std::iota(all.begin(), all.end(), Label{0});
  return all;
}

std::vector<Label> DatasetInfo::fault_labels() const {
  std::vector<Label> faults = labels();
  std::erase_if(faults, [&](Label label) { return class_of(label).defect == Defect::none; });
  return faults;
}

Label DatasetInfo::healthy_label() const {
  std::vector<Label> healthy = labels();
  std::erase_if(healthy, [&](Label label) { return class_of(label).defect != Defect::none; });
  if (healthy.size() > 1) {
    throw Error(Exit::bad_input, "data set " + name + ": both " + class_of(healthy[0]).name +
                                     " and " + class_of(healthy[1]).name +
                                     " have defect 'none'; only one class may have it");
  }
  if (healthy.empty()) {
    throw Error(Exit::bad_input,
                "data set " + name + ": no class has defect 'none'; one class must have it");
  }
  return healthy.front();
}

std::int32_t DatasetInfo::condition_called(const std::string& called) const {
  const auto found = std::ranges::find(conditions, called, &Condition::name);
  return found == conditions.end() ? every_condition
                                   : static_cast<std::int32_t>(found - conditions.begin());
}

double DatasetInfo::speed_rpm(std::int32_t condition) const {
  if (condition == every_condition) return shaft_speed_rpm;
  return conditions[static_cast<std::size_t>(condition)].shaft_speed_rpm;
}

std::vector<std::int32_t> DatasetInfo::known_conditions() const {
  return conditions_for(conditions, &Condition::known);
}

std::vector<std::int32_t> DatasetInfo::tested_conditions() const {
  return conditions_for(conditions, &Condition::test);
}

double DatasetInfo::known_speed_rpm() const { return mean_speed_rpm(*this, known_conditions()); }

double DatasetInfo::tested_speed_rpm() const { return mean_speed_rpm(*this, tested_conditions()); }

void write(artefact::Writer& writer, const DatasetInfo& info) {
  writer.attribute("/", "dataset", info.name);
  writer.attribute("/", "sample_rate_hz", info.sample_rate_hz);
  writer.attribute("/", "shaft_speed_rpm", info.shaft_speed_rpm);
  writer.attribute("/", "unit_m_per_s2", info.unit_m_per_s2);
  if (info.has_bearing) write_bearing(writer, info.bearing);
  std::vector<std::string> names;
  std::vector<std::string> defects;
  std::vector<double> sizes;
  for (const ClassInfo& c : info.classes) {
    names.push_back(c.name);
    defects.push_back(to_string(c.defect));
    sizes.push_back(c.defect_size_mm);
  }
  writer.strings("/classes/name", names);
  writer.strings("/classes/defect", defects);
  writer.numbers("/classes/defect_size_mm", sizes);
  write(writer, info.conditions);
}

DatasetInfo read_dataset_info(const artefact::Reader& reader) {
  DatasetInfo info;
  info.name = reader.text("/", "dataset");
  if (!ranges::is_plain_name(info.name)) {
    reader.refuse("/, attribute dataset", ranges::plain_name_rule);
  }
  info.sample_rate_hz = reader.real("/", "sample_rate_hz", ranges::sample_rate_hz);
  info.shaft_speed_rpm = reader.real("/", "shaft_speed_rpm", ranges::shaft_speed_rpm);
  info.unit_m_per_s2 = reader.real("/", "unit_m_per_s2", ranges::unit_m_per_s2);
  info.has_bearing = reader.has("/bearing");
  if (info.has_bearing) info.bearing = read_bearing(reader);
  info.classes = read_classes(reader);
  info.conditions = read_conditions(reader);
  refuse_impossible(reader, info);
  return info;
}

}  // namespace piae::signal
