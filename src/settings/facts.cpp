#include "settings/facts.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "cli/toml_file.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/input_choice.hpp"
#include "run/grid.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"
#include "settings/groups.hpp"
#include "settings/protocol.hpp"
#include "settings/sweeps.hpp"
#include "signal/description_file.hpp"
#include "signal/split.hpp"

namespace piae::settings {

namespace fs = std::filesystem;

namespace {

bool is_the_papers(augment::Kind kind) {
  using augment::Kind;
  return kind == Kind::baseline || kind == Kind::published || kind == Kind::ablation;
}

void add_methods(std::vector<std::string>& words) {
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    const std::string name = entry.name;
    words.push_back("method:" + name);
    const bool is_papers = is_the_papers(entry.kind);
    if (is_papers) words.push_back("paper:" + name);
    if (is_papers || entry.recommended) words.push_back("default:" + name);
    if (entry.kind == augment::Kind::baseline) words.push_back("baseline:" + name);
    if (entry.kind == augment::Kind::ceiling) words.push_back("ceiling:" + name);
    if (entry.hears) words.push_back("hears:" + name);
    if (entry.needs >= augment::Needs::bearing) words.push_back("needs-bearing:" + name);
    if (entry.needs >= augment::Needs::rhythm) words.push_back("needs-rhythm:" + name);
    if (entry.needs >= augment::Needs::size) words.push_back("needs-size:" + name);
    if (entry.infers) words.push_back("infers:" + name);
  }
  words.push_back("paper-method:" + augment::paper_method());
}

void add_classifiers(std::vector<std::string>& words) {
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    words.push_back(std::string("classifier:") + each.name);
  }
  words.push_back(std::string("paper-classifier:") + scoring::paper_classifier);
  words.push_back(std::string("bar:") + diagnosis::bar_classifier);
}

void add_ratios(std::vector<std::string>& words) {
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    words.push_back(std::string("ratio:") + ratio.name);
    if (ratio.generated_per_class == 0) {
      words.push_back(std::string("nothing-generated:") + ratio.name);
    }
  }
}

/// Which methods have cells by which classifiers.
void add_pairs(std::vector<std::string>& words) {
  for (const augment::CatalogueEntry& method : augment::catalogue()) {
    for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
      const std::string pair = std::string(method.name) + '/' + classifier.name;
      if (run::go_together(method, classifier, false)) words.push_back("pair:" + pair);
      if (run::go_together(method, classifier, true)) words.push_back("pair-of-nothing:" + pair);
    }
  }
}

/// Whether the stage split, of which the protocol and the description have settings, makes known
/// fault windows.
bool knows_nothing(const toml::table& protocol, const toml::table& description) {
  const auto own = description["split"][signal::known_per_class];
  const auto count = (own ? own : protocol["split"][signal::known_per_class]).value<std::int64_t>();
  return count == std::int64_t{0};
}

/// The tables of a list of tables; none where it is none.
std::vector<const toml::table*> tables_of(const toml::table& description, const char* key) {
  std::vector<const toml::table*> tables;
  if (const toml::array* list = description[key].as_array()) {
    for (const toml::node& node : *list) {
      if (node.is_table()) tables.push_back(node.as_table());
    }
  }
  return tables;
}

bool says_size(const toml::table& description, const toml::table& of_class) {
  if (of_class.contains("defect_size_mm")) return true;
  const auto name = of_class["name"].value<std::string>();
  return std::ranges::any_of(tables_of(description, "record"), [&](const toml::table* record) {
    return (*record)["class"].value<std::string>() == name && record->contains("defect_size_mm");
  });
}

/// What a description does not say of its faults, which some methods need.
void add_unsaid(const std::string& name, const toml::table& description,
                std::vector<std::string>& words) {
  bool rhythm = true;
  bool sizes = true;
  for (const toml::table* of_class : tables_of(description, "class")) {
    const auto defect = (*of_class)["defect"].value_or<std::string>("none");
    rhythm = rhythm && defect != "other";
    const bool has_size = defect != "none" && defect != "other";
    sizes = sizes && (!has_size || says_size(description, *of_class));
  }
  if (!rhythm) words.push_back("without-rhythm:" + name);
  if (!rhythm && !description.contains("bearing")) words.push_back("without-bearing:" + name);
  if (!sizes) words.push_back("without-size:" + name);
}

/// What there is to know of a description. One that cannot be read is refused when its data set is
/// asked for, not before.
void add_dataset(const toml::table& protocol, const fs::path& description,
                 std::vector<std::string>& words) {
  const std::string name = description.stem().string();
  words.push_back("dataset:" + name);
  try {
    const toml::table content = signal::read_description_file(description);
    if (content.contains("simulation")) words.push_back("simulated:" + name);
    if (content.contains("split")) words.push_back("own-split:" + name);
    add_unsaid(name, content, words);
    if (knows_nothing(protocol, content)) words.push_back("nothing-known:" + name);
  } catch (const Error&) {
    return;
  }
}

void add_datasets(const toml::table& protocol, const fs::path& folder,
                  std::vector<std::string>& words) {
  std::vector<fs::path> descriptions;
  std::error_code no_folder;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, no_folder)) {
    if (entry.path().extension() == ".toml") descriptions.push_back(entry.path());
  }
  std::ranges::sort(descriptions);
  for (const fs::path& description : descriptions) add_dataset(protocol, description, words);
}

void add_sweeps(const toml::table& protocol, std::vector<std::string>& words) {
  for (const Sweep& sweep : sweeps(protocol)) {
    words.push_back("swept:" + sweep.method);
    words.push_back("sweep-classifier:" + sweep.method + ':' + sweep.classifier);
    const auto add = [&](const std::string& kind, const std::vector<std::string>& points) {
      const std::string of_method = kind + sweep.method + ':';
      for (const std::string& point : points) words.push_back(of_method + point);
    };
    add("sweep-point:", sweep.points);
    add("sweep-centre:", sweep.centre);
  }
}

void add_readings(const toml::table& protocol, std::vector<std::string>& words) {
  for (const std::string& reading : readings(protocol)) words.push_back("reading:" + reading);
  for (const std::string& setting : base_of_readings(protocol)) {
    words.push_back("reading-base:" + setting);
  }
}

void add_groups(const toml::table& protocol, std::vector<std::string>& words) {
  for (const Group& group : groups(protocol)) {
    words.push_back("group:" + group.name);
    for (const std::string& dataset : group.datasets) {
      words.push_back("group-dataset:" + group.name + '/' + dataset);
    }
    for (const std::string& input : group.inputs) {
      words.push_back("group-method:" + group.name + '/' +
                      report::parse_input_choice(input).method);
    }
    const std::string input_of = "group-input:" + group.name + '/';
    for (const std::string& input : group.inputs) words.push_back(input_of + input);
    for (const std::string& input : group.kind_inputs) words.push_back(input_of + input);
  }
}

}  // namespace

std::vector<std::string> facts(const fs::path& pipeline) {
  std::vector<std::string> words;
  add_methods(words);
  add_classifiers(words);
  add_ratios(words);
  add_pairs(words);
  const toml::table protocol = read_protocol(pipeline / "protocol.toml");
  add_datasets(protocol, pipeline / "datasets", words);
  add_sweeps(protocol, words);
  add_readings(protocol, words);
  add_groups(protocol, words);
  return words;
}

}  // namespace piae::settings
