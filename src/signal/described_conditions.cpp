#include "signal/described_conditions.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <string>

namespace piae::signal {

namespace {

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string comma_separated(const Names& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

Names condition_names(const std::vector<RecordSource>& records) {
  Names names;
  for (const RecordSource& record : records) {
    if (!record.condition.empty() && !has(names, record.condition)) {
      names.push_back(record.condition);
    }
  }
  return names;
}

/// Refuses a list of [transfer] with a name that no record has, or that appears twice.
void require_named(const TomlTable& transfer, const std::string& key, const Names& list,
                   const Names& named) {
  for (const std::string& name : list) {
    if (!has(named, name)) {
      transfer.refuse(key, "names '" + name +
                               "', which is not the condition of any record; records have " +
                               comma_separated(named));
    }
    if (std::ranges::count(list, name) > 1) transfer.refuse(key, "names '" + name + "' twice");
  }
}

/// Sets the uses of each condition.
void read_transfer(TomlTable& transfer, bool any_known, std::vector<Condition>& conditions) {
  Names named;
  for (const Condition& condition : conditions) named.push_back(condition.name);
  if (named.empty()) {
    transfer.refuse("known",
                    "names conditions, but no record has one; add condition to each [[record]]");
  }
  if (!any_known && transfer.has("known")) {
    transfer.refuse("known",
                    "names conditions with known faults, but split.known-per-class is 0, so no "
                    "fault is known in any; remove one of the two");
  }
  const Names known = any_known ? transfer.texts("known") : Names{};
  const Names test = transfer.texts("test");
  const Names healthy = transfer.optional_texts("healthy");
  transfer.finish();
  require_named(transfer, "known", known, named);
  require_named(transfer, "test", test, named);
  require_named(transfer, "healthy", healthy, named);
  for (const std::string& name : test) {
    if (!has(known, name)) continue;
    transfer.refuse("test", "names '" + name + "', which is in known, too; name another condition");
  }
  for (Condition& condition : conditions) {
    condition.test = has(test, condition.name);
    condition.known = any_known ? has(known, condition.name) : condition.test;
    condition.healthy =
        healthy.empty() ? condition.known || condition.test : has(healthy, condition.name);
  }
}

/// True if the record's condition has this use.
bool record_is_for(const RecordSource& record, const std::vector<Condition>& conditions,
                   bool Condition::*use) {
  if (record.condition.empty()) return true;
  return (*std::ranges::find(conditions, record.condition, &Condition::name)).*use;
}

Names names_of(const std::vector<Condition>& conditions, bool Condition::*use) {
  Names names;
  for (const Condition& condition : conditions) {
    if (condition.*use) names.push_back(condition.name);
  }
  return names;
}

/// Requires a condition for each fault record. Otherwise test windows and known windows would come
/// from the same recording.
void require_a_condition_of_faults(const TomlTable& transfer, const DatasetInfo& info,
                                   const std::vector<RecordSource>& records) {
  for (const RecordSource& record : records) {
    if (record.label == info.healthy_label() || !record.condition.empty()) continue;
    transfer.refuse("known", "needs a condition for each fault record, but class " +
                                 info.class_of(record.label).name +
                                 " has a record without one; add condition to that [[record]]");
  }
}

/// Requires for each fault class a known record and a record to test with.
void require_faults(const TomlTable& transfer, const DatasetInfo& info,
                    const std::vector<Condition>& conditions,
                    const std::vector<RecordSource>& records) {
  const auto require = [&](Label label, const std::string& key, bool Condition::*use) {
    const bool there = std::ranges::any_of(records, [&](const RecordSource& record) {
      return record.label == label && record_is_for(record, conditions, use);
    });
    if (there) return;
    transfer.refuse(key, "is " + comma_separated(names_of(conditions, use)) + ", but class " +
                             info.class_of(label).name + " has no record there");
  };
  for (const Label label : info.fault_labels()) {
    require(label, "test", &Condition::test);
    require(label, "known", &Condition::known);
  }
}

/// Requires healthy records in each tested condition and in each condition for healthy windows.
void require_healthy(const TomlTable& transfer, const DatasetInfo& info,
                     const std::vector<Condition>& conditions,
                     const std::vector<RecordSource>& records) {
  const Label healthy = info.healthy_label();
  for (const Condition& condition : conditions) {
    if (!condition.test && !condition.healthy) continue;
    const bool there = std::ranges::any_of(records, [&](const RecordSource& record) {
      return record.label == healthy &&
             (record.condition.empty() || record.condition == condition.name);
    });
    if (there) continue;
    const std::string no_record = "there is no record of class " + info.class_of(healthy).name;
    if (condition.test) {
      transfer.refuse("test", "names '" + condition.name + "', but " + no_record +
                                  " in it; record the healthy machine in it");
    }
    transfer.refuse("healthy", "is known and test together by default, but for '" + condition.name +
                                   "' " + no_record + "; name conditions that have one");
  }
}

/// Sets each condition's speed to the mean of its records, which must agree within 10 %.
void set_speeds(const TomlTable& root, const std::vector<RecordSource>& records,
                std::vector<Condition>& conditions) {
  for (Condition& condition : conditions) {
    std::vector<double> speeds_rpm;
    for (const RecordSource& record : records) {
      if (record.condition == condition.name) speeds_rpm.push_back(record.shaft_speed_rpm);
    }
    const auto [least, largest] = std::ranges::minmax(speeds_rpm);
    if (largest > largest_speed_ratio * least) {
      root.refuse("record", fmt::format("has condition '{}' at {:g} and at {:g} rpm; the speeds of "
                                        "a condition may differ by 10 %",
                                        condition.name, least, largest));
    }
    condition.shaft_speed_rpm = mean_speed_of_records_rpm(records, condition.name);
  }
}

}  // namespace

double mean_speed_of_records_rpm(const std::vector<RecordSource>& records,
                                 const std::string& condition) {
  double sum = 0;
  double count = 0;
  for (const RecordSource& record : records) {
    if (record.condition != condition) continue;
    sum += record.shaft_speed_rpm;
    ++count;
  }
  return sum / count;
}

std::string read_condition_name(TomlTable& table, const std::string& key) {
  std::string name = table.text(key);
  if (!is_condition_name(name)) table.refuse(key, "'" + name + "' " + condition_name_rule);
  return name;
}

std::string record_stem(const std::string& class_name, const std::string& condition) {
  std::string stem = condition.empty() ? class_name : class_name + '-' + condition;
  std::ranges::replace(stem, ' ', '-');
  return stem;
}

std::vector<Condition> read_described_conditions(TomlTable& root, const DatasetInfo& info,
                                                 std::vector<RecordSource>& records,
                                                 bool any_known) {
  std::vector<Condition> conditions;
  for (const std::string& name : condition_names(records)) conditions.push_back({.name = name});
  if (auto transfer = root.optional_table("transfer")) {
    read_transfer(*transfer, any_known, conditions);
    require_a_condition_of_faults(*transfer, info, records);
    require_faults(*transfer, info, conditions, records);
    require_healthy(*transfer, info, conditions, records);
  }
  const auto is_used = [](const Condition& c) { return c.known || c.test || c.healthy; };
  std::erase_if(records, [&](const RecordSource& record) {
    return !record.condition.empty() &&
           !is_used(*std::ranges::find(conditions, record.condition, &Condition::name));
  });
  std::erase_if(conditions, [&](const Condition& c) { return !is_used(c); });
  set_speeds(root, records, conditions);
  return conditions;
}

}  // namespace piae::signal
