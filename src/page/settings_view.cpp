#include "page/settings_view.hpp"

#include <algorithm>

#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "page/commented_toml.hpp"
#include "page/table.hpp"
#include "text/lines.hpp"

namespace piae::page {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> toml_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none_there;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none_there)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// A value of a file of pipeline/, and what is said of it there.
struct Stated {
  const toml::node* node = nullptr;
  std::string comment;
};

Stated stated_in(const CommentedToml& file, const toml::node* node,
                 const std::string& before = "") {
  if (node == nullptr) return {};
  const std::string comment = file.comment_beside(*node);
  return {.node = node,
          .comment = comment.empty() ? before : before + (before.empty() ? "" : ": ") + comment};
}

/// Where a stage finds an option: the table of its variant, of the one that is like it, or its own.
Stated stated_option(const CommentedToml& protocol, const std::string& stage,
                     const std::string& variant, const std::string& option) {
  const auto of_stage = protocol.values()[stage];
  const auto of_variant = of_stage[variant];
  if (const toml::node* own = of_variant[option].node()) return stated_in(protocol, own);
  const std::string like = of_variant["like"].value_or<std::string>("");
  if (const toml::node* other = of_stage[like][option].node()) {
    return stated_in(protocol, other, "as " + like);
  }
  return stated_in(protocol, of_stage[option].node());
}

std::string source_of(const Stated& stated, const toml::node& value, const std::string& file) {
  if (stated.node == nullptr) return "no longer in " + file;
  const std::string now = plain_value(*stated.node);
  return now == plain_value(value) ? stated.comment : file + " has " + now + " now";
}

/// The options that make has given, which a settings file names in a comment.
void add_given_options(const fs::path& file, std::vector<Setting>& settings) {
  const std::string beginning = "# Options given by make: ";
  for (const std::string& line : text::read_lines(file)) {
    if (!line.starts_with('#')) break;
    if (line.starts_with(beginning)) {
      settings.push_back({.file = file.filename().string(),
                          .option = "on the command line",
                          .value = line.substr(beginning.size()),
                          .source = "given to make"});
    }
  }
}

void add_options(const fs::path& file, const CommentedToml& protocol,
                 std::vector<Setting>& settings) {
  const std::string name = file.stem().string();
  const std::size_t dot = name.find('.');
  const std::string stage = name.substr(0, dot);
  const std::string variant = dot == std::string::npos ? "" : name.substr(dot + 1);
  add_given_options(file, settings);
  for (const auto& [key, node] : cli::options_of(cli::parse_toml_file(file), stage, variant)) {
    const std::string option(key.str());
    const Stated stated = stated_option(protocol, stage, variant, option);
    settings.push_back({.file = file.filename().string(),
                        .option = option,
                        .value = plain_value(node),
                        .source = source_of(stated, node, "protocol.toml")});
  }
}

/// Adds the values of a description: tables by their name, lists of tables one by one.
class DescriptionReader {
 public:
  DescriptionReader(std::string file, std::vector<Setting>& settings)
      : file_(std::move(file)), settings_(settings) {}

  /// `stated` is the node of the description that this one was made from, or null.
  void add(const CommentedToml& source, const std::string& option, const toml::node& node,
           const toml::node* stated, const std::string& said_of_table = "") {
    if (const toml::table* table = node.as_table()) {
      add_table(source, option, *table, stated == nullptr ? nullptr : stated->as_table());
    } else if (node.is_array_of_tables()) {
      for (const toml::node& each : *node.as_array()) put(option, each, "");
    } else {
      put(option, node,
          source_of(stated_in(source, stated, said_of_table), node, "its description"));
    }
  }

 private:
  void add_table(const CommentedToml& source, const std::string& option, const toml::table& table,
                 const toml::table* stated) {
    const bool is_part = !option.empty();
    const std::string said = is_part && stated != nullptr ? source.comment_beside(*stated) : "";
    const std::string part = is_part ? option + "." : "";
    for (const auto& [key, value] : table) {
      const std::string name(key.str());
      add(source, std::string(part).append(name), value,
          stated == nullptr ? nullptr : stated->get(name), said);
    }
  }
  void put(const std::string& option, const toml::node& node, const std::string& source) {
    settings_.push_back(
        {.file = file_, .option = option, .value = plain_value(node), .source = source});
  }

  std::string file_;
  std::vector<Setting>& settings_;
};

void add_description(const fs::path& file, const fs::path& pipeline,
                     std::vector<Setting>& settings) {
  const fs::path stated = pipeline / "datasets" / file.filename();
  DescriptionReader reader("datasets/" + file.filename().string(), settings);
  const toml::table values = cli::parse_toml_file(file);
  const CommentedToml source(fs::exists(stated) ? stated : file);
  reader.add(source, "", values, fs::exists(stated) ? &source.values() : nullptr);
}

}  // namespace

std::vector<Setting> read_settings(const fs::path& run, const fs::path& pipeline) {
  std::vector<Setting> settings;
  const fs::path folder = run / ".settings";
  const CommentedToml protocol(pipeline / "protocol.toml");
  for (const fs::path& file : toml_files_in(folder)) add_options(file, protocol, settings);
  for (const fs::path& file : toml_files_in(folder / "datasets")) {
    add_description(file, pipeline, settings);
  }
  return settings;
}

Html settings_view(const std::vector<Setting>& settings) {
  if (settings.empty())
    return element("p", "This run has no settings files: its steps were run by hand.");
  Table table{.caption = "Settings",
              .columns = {{"file in .settings/"}, {"option"}, {"value"}, {"where it comes from"}}};
  for (const Setting& setting : settings) {
    table.rows.push_back({.cells = {{.content = setting.file},
                                    {.content = setting.option},
                                    {.content = setting.value},
                                    {.content = setting.source}}});
  }
  table.below =
      "Values from the settings files of the run, with which its steps were run; where they come "
      "from, from the comments of pipeline/protocol.toml and pipeline/datasets/.";
  return element(
      "details",
      element("summary", "All " + std::to_string(settings.size()) + " settings") + html(table));
}

}  // namespace piae::page
