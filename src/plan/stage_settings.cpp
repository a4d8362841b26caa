#include "plan/stage_settings.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <set>
#include <sstream>

#include "augment/catalogue.hpp"
#include "cli/run_options.hpp"
#include "cli/setting.hpp"
#include "cli/toml_options.hpp"
#include "diagnosis/wdcnn_options.hpp"
#include "scoring/diagnosis_record.hpp"
#include "signal/description_file.hpp"
#include "signal/split.hpp"

namespace piae::plan {

namespace fs = std::filesystem;

namespace {

std::string settings_text(const std::string& source, const toml::table& values) {
  std::ostringstream text;
  text << "# Made from " << source << "; edit that file, not this one.\n"
       << toml::toml_formatter(values) << '\n';
  return text.str();
}

std::map<std::string, std::string> plain_values(const toml::table& table) {
  std::map<std::string, std::string> values;
  for (const auto& [key, node] : table) {
    values[std::string(key.str())] = fmt::format("{}", fmt::join(cli::values_of(node), ", "));
  }
  return values;
}

/// Adds the file, or the list of files, of a record.
void add_files(const toml::table& record, std::set<std::string>& files) {
  const toml::node* const node = record.get("file");
  if (node == nullptr) return;
  for (const std::string& file : cli::values_of(*node)) {
    if (file.find('\n') == std::string::npos) files.insert(file);
  }
}

/// Returns the files and patterns that the records of a description name, each once. Skips invalid
/// entries, which `ingest` reports.
std::vector<std::string> recordings_of(const toml::table& description) {
  std::set<std::string> files;
  if (const toml::array* records = description["record"].as_array()) {
    for (const toml::node& record : *records) {
      if (record.is_table()) add_files(*record.as_table(), files);
    }
  }
  return {files.begin(), files.end()};
}

}  // namespace

std::map<std::string, std::string> defaults_of_stage(const std::string& stage,
                                                     const std::string& variant) {
  cli::RunOptions run;
  signal::SplitOptions split;
  diagnosis::WdcnnOptions wdcnn;
  if (stage == "split") return cli::defaults_of([&](const auto& to) { bind(to, split); });
  if (stage == "generate") return cli::defaults_of([&](const auto& to) { bind(to, run); });
  if (stage == "train" && augment::find_entry(variant) != nullptr) {
    const auto method = augment::make_method(variant);
    return cli::defaults_of([&](const auto& to) {
      bind(to, run);
      method->bind(to);
    });
  }
  if (stage == "diagnose") {
    auto defaults = cli::defaults_of([&](const auto& to) {
      bind(to, run);
      bind(to, wdcnn);
    });
    defaults["classifier"] = scoring::paper_classifier;
    return defaults;
  }
  return {};
}

StageSettings::StageSettings(const Experiment& experiment, std::string folder)
    : experiment_(experiment), folder_(std::move(folder)) {}

std::shared_ptr<const Settings> StageSettings::keep(const std::string& name,
                                                    const std::string& source,
                                                    const toml::table& values,
                                                    const std::string& stage,
                                                    const std::string& variant) {
  Settings settings{.file = folder_ + "/.settings/" + name + ".toml",
                    .text = settings_text(source, values),
                    .values = plain_values(values),
                    .defaults = defaults_of_stage(stage, variant)};
  return kept_[name] = std::make_shared<const Settings>(std::move(settings));
}

std::shared_ptr<const Settings> StageSettings::of(const std::string& stage,
                                                  const std::string& variant) {
  const std::string name = variant.empty() ? stage : stage + '.' + variant;
  if (const auto found = kept_.find(name); found != kept_.end()) return found->second;
  return keep(name, (experiment_.pipeline / "protocol.toml").string(),
              cli::options_of(experiment_.protocol, stage, variant), stage, variant);
}

std::shared_ptr<const Settings> StageSettings::of_split(const Dataset& dataset) {
  if (!dataset.has_own_split) return of("split");
  const std::string name = "split." + dataset.name;
  if (const auto found = kept_.find(name); found != kept_.end()) return found->second;
  const fs::path source = experiment_.pipeline / "datasets" / (dataset.name + ".toml");
  toml::table values = cli::options_of(experiment_.protocol, "split", "");
  const toml::table description = signal::read_description_file(source);
  for (const auto& [key, node] : *description["split"].as_table()) {
    values.insert_or_assign(key, node);
  }
  return keep(name, source.string(), values, "split", "");
}

std::shared_ptr<const Settings> StageSettings::description(const Dataset& dataset) {
  const std::string name = "datasets/" + dataset.name;
  if (const auto found = kept_.find(name); found != kept_.end()) return found->second;
  const fs::path source = experiment_.pipeline / "datasets" / (dataset.name + ".toml");
  const toml::table values = signal::read_description_file(source);
  Settings settings{.file = folder_ + "/.settings/" + name + ".toml",
                    .text = settings_text(source.string(), values),
                    .values = {},
                    .defaults = {},
                    .recordings = recordings_of(values)};
  return kept_[name] = std::make_shared<const Settings>(std::move(settings));
}

}  // namespace piae::plan
