#include "page/settings_view.hpp"

#include <algorithm>

#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "page/commented_toml.hpp"
#include "page/table.hpp"
#include "signal/ranges.hpp"
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

const std::string own_protocol = "protocol.toml";
const std::string own_description = "its description";

/// A value of a file of pipeline/, and what is said of it there.
struct Stated {
  const toml::node* node = nullptr;
  std::string comment;
};

/// "as cwru: SKF 6205", of which either may be empty.
std::string joined_comments(const std::string& before, const std::string& comment) {
  return before + (before.empty() || comment.empty() ? "" : ": ") + comment;
}

Stated stated_in(const CommentedToml& file, const toml::node* node,
                 const std::string& before = "") {
  if (node == nullptr) return {};
  return {.node = node, .comment = joined_comments(before, file.comment_beside(*node))};
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

/// The same node in one of the files that a description is made of.
struct Layer {
  const CommentedToml* file = nullptr;
  std::string said;  ///< before the comment of a value: whose it is, and what is said of its table
  const toml::node* node = nullptr;
};

/// Of a file before those that it is like: the first that has a value states it.
using Layers = std::vector<Layer>;

Stated stated_by(const Layers& layers) {
  if (layers.empty()) return {};
  const Layer& first = layers.front();
  return stated_in(*first.file, first.node, first.said);
}

/// What the tables of these layers have of this name.
Layers within(const Layers& layers, const std::string& name) {
  Layers inner;
  for (const Layer& layer : layers) {
    const toml::table* table = layer.node->as_table();
    const toml::node* node = table == nullptr ? nullptr : table->get(name);
    if (node != nullptr) inner.push_back({.file = layer.file, .said = layer.said, .node = node});
  }
  return inner;
}

/// The description of a data set in pipeline/datasets/, and those that it is like.
class DescriptionChain {
 public:
  /// Ends where there is no such file: a run may be older than the descriptions beside it. One that
  /// goes in a circle, which no stage reads, ends where it would begin again.
  DescriptionChain(const fs::path& pipeline, std::string name) {
    while (signal::ranges::is_plain_name(name) && std::ranges::count(names_, name) == 0) {
      const fs::path file = pipeline / "datasets" / (name + ".toml");
      if (!fs::exists(file)) return;
      files_.emplace_back(file);
      names_.push_back(name);
      name = files_.back().values()["like"].value_or<std::string>("");
    }
  }

  [[nodiscard]] Layers layers() const {
    Layers layers;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      layers.push_back({.file = &files_[i],
                        .said = i == 0 ? "" : "as " + names_[i],
                        .node = &files_[i].values()});
    }
    return layers;
  }

 private:
  std::vector<CommentedToml> files_;
  std::vector<std::string> names_;
};

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

/// Which table of the protocol a settings file is of.
struct TableName {
  std::string stage;
  std::string variant;
};

/// As settings/settings_folder.cpp names them: "train.vae", "split.cwru", and "sweep@vae.cwru" of
/// [sweep.vae].
TableName table_name(const std::string& stem) {
  const std::size_t dot = stem.find('.');
  const std::string stage = stem.substr(0, dot);
  const std::size_t at = stage.find('@');
  if (at != std::string::npos) return {stage.substr(0, at), stage.substr(at + 1)};
  return {stage, dot == std::string::npos ? "" : stem.substr(dot + 1)};
}

void add_options(const fs::path& file, const CommentedToml& protocol, const fs::path& pipeline,
                 std::vector<Setting>& settings) {
  const auto [stage, variant] = table_name(file.stem().string());
  // A description may have values of its own for the stage split alone.
  const DescriptionChain description(pipeline, stage == "split" ? variant : "");
  const Layers own_split = within(description.layers(), "split");
  add_given_options(file, settings);
  for (const auto& [key, node] : cli::options_of(cli::parse_toml_file(file), stage, variant)) {
    const std::string option(key.str());
    const Stated own = stated_by(within(own_split, option));
    const bool is_own = own.node != nullptr;
    const Stated stated = is_own ? own : stated_option(protocol, stage, variant, option);
    settings.push_back(
        {.file = file.filename().string(),
         .option = option,
         .value = plain_value(node),
         .source = source_of(stated, node, is_own ? own_description : own_protocol)});
  }
}

/// Adds the values of a description: tables by their name, lists of tables one by one.
class DescriptionReader {
 public:
  DescriptionReader(std::string file, std::vector<Setting>& settings)
      : file_(std::move(file)), settings_(settings) {}

  /// `stated` are the nodes of the descriptions that this one was made from.
  void add(const std::string& option, const toml::node& node, const Layers& stated) {
    if (const toml::table* table = node.as_table()) {
      add_table(option, *table, stated);
    } else if (node.is_array_of_tables()) {
      for (const toml::node& each : *node.as_array()) put(option, each, "");
    } else {
      put(option, node, source_of(stated_by(stated), node, own_description));
    }
  }

 private:
  void add_table(const std::string& option, const toml::table& table, Layers stated) {
    const bool is_part = !option.empty();
    if (is_part) {
      for (Layer& layer : stated) {
        layer.said = joined_comments(layer.said, layer.file->comment_beside(*layer.node));
      }
    }
    const std::string part = is_part ? option + "." : "";
    for (const auto& [key, value] : table) {
      const std::string name(key.str());
      add(std::string(part).append(name), value, within(stated, name));
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
  DescriptionReader reader("datasets/" + file.filename().string(), settings);
  const DescriptionChain stated(pipeline, file.stem().string());
  reader.add("", cli::parse_toml_file(file), stated.layers());
}

}  // namespace

std::vector<Setting> read_settings(const fs::path& run, const fs::path& pipeline) {
  std::vector<Setting> settings;
  const fs::path folder = run / ".settings";
  const CommentedToml protocol(pipeline / "protocol.toml");
  for (const fs::path& file : toml_files_in(folder))
    add_options(file, protocol, pipeline, settings);
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
