// Stands in for the stages of a run in tests of make and scripts. Takes any options, and writes
// small versions of the stage's files with its provenance. Their contents depend on options and
// inputs. Adds a line to the file `calls` for each call.

#include <spdlog/fmt/fmt.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "artefact/journal.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "plan/stage_settings.hpp"
#include "run/layout.hpp"

namespace {

using namespace piae;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Options = std::map<std::string, Words>;

const std::map<std::string, std::string> kinds{
    {"ingest", "records"},     {"simulate", "records"},       {"split", "windows"},
    {"train", "model"},        {"generate", "windows"},       {"score", "score"},
    {"diagnose", "diagnosis"}, {"classify", "classification"}};
const Words of_files{"config",   "output", "output-dir", "keep-classifier",
                     "data-dir", "run",    "pipeline"};

bool has(const Words& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

Options options_in(const Words& words) {
  Options options;
  std::string option;
  for (const std::string& word : words) {
    if (word.starts_with("--")) {
      option = word.substr(2);
      options[option];
    } else {
      options[option].push_back(word);
    }
  }
  return options;
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string value(const Options& options, const std::string& option) {
  const auto found = options.find(option);
  return found == options.end() ? "" : joined(found->second);
}

/// Returns the files that the stage makes, artefacts or tables.
Words outputs_of(const std::string& stage, const Options& options) {
  const std::string folder = value(options, "run") + '/' + value(options, "dataset") + '/';
  const auto in_folder = [&](const Words& names) {
    Words files;
    for (const std::string& name : names) files.push_back(folder + name);
    return files;
  };
  if (stage == "split") {
    const std::string to = value(options, "output-dir") + '/';
    return {to + "A.h5", to + "B.h5", to + "C.h5", to + "D.h5"};
  }
  if (stage == "tabulate") return in_folder(piae::run::table_names);
  if (stage == "sweep") {
    const std::string method = value(options, "method");
    const std::string name = method.empty() ? "sweep" : "sweep@" + method;
    return in_folder({name + ".csv", name + ".md"});
  }
  if (stage == "readings") return in_folder({"readings.csv", "readings.md"});
  if (stage == "trust") return in_folder({"trust.csv", "trust.md"});
  if (stage == "verdicts") return in_folder({"verdicts.csv", "verdicts.md"});
  if (stage == "identify") {
    return in_folder({"identifiability.csv", "scatter.csv", "identifiability.md"});
  }
  if (stage == "transfer") {
    const std::string to = value(options, "run") + "/transfer";
    const std::string group = '@' + value(options, "group");
    return {to + group + ".csv", to + "-comparisons" + group + ".csv", to + group + ".md"};
  }
  if (stage == "contrast") {
    fs::path table = value(options, "output");
    Words files;
    for (const char* ending : {".md", ".csv", ".tex"})
      files.push_back(table.replace_extension(ending));
    return files;
  }
  const std::string kept = value(options, "keep-classifier");
  return {kept.empty() ? value(options, "output") : kept};
}

artefact::Provenance provenance_of(const std::string& stage, const Options& options) {
  artefact::Provenance provenance{.program = stage, .options = {}, .inputs = {}};
  std::map<std::string, std::string> values =
      plan::defaults_of_stage(stage, value(options, "method"));
  if (options.contains("config")) {
    for (const auto& [key, node] : cli::parse_toml_file(value(options, "config"))) {
      values[std::string(key.str())] = joined(cli::values_of(node));
    }
  }
  for (const auto& [option, words] : options) {
    if (has(of_files, option)) continue;
    const std::string file = joined(words);
    if (file.ends_with(".h5")) {
      provenance.inputs.push_back(
          {option, fs::path(file).filename(), artefact::Reader(file, "").digest()});
    } else if (option == "description") {
      provenance.inputs.push_back({option, fs::path(file).filename(), sha256_of_file(file)});
    } else {
      values[option] = joined(words);
    }
  }
  for (const auto& [option, text] : values) {
    provenance.options += fmt::format("{} = \"{}\"\n", option, text);
  }
  return provenance;
}

/// Returns the text of a table; a table that plan reads has the columns of its stage.
std::string table_text(const std::string& file, const std::string& command) {
  if (fs::path(file).filename() != "readings.csv") return command + '\n';
  return "dataset,reading,quantity,ratio,seeds,mean,std\n"
         "real,base,accuracy,1to1,1,50,0\nreal,batches=class,accuracy,1to1,1,60,0\n";
}

void write_artefact(const std::string& file, const std::string& stage, const std::string& command,
                    const artefact::Provenance& provenance) {
  const std::string stem = fs::path(file).stem();
  const std::string kind = stem == "classifier" ? stem : kinds.at(stage);
  artefact::Writer writer(kind);
  std::string content = command + provenance.options;
  for (const auto& input : provenance.inputs) content += input.role + input.digest;
  writer.attribute("/", "command", command);
  writer.attribute("/", "content", Sha256().update(content).finish_hex());
  if (kind == "windows") writer.attribute("/", "role", stem);
  if (kind == "records") writer.group("/records");
  if (stem == "features") writer.group("/features");
  const artefact::Written written = writer.save(file, provenance);
  const char* const run = std::getenv("PIAE_RUN");
  if (run != nullptr) artefact::add_to_journal(run, file, written, provenance);
}

std::string cell_of(const std::string& file) {
  const std::size_t run = file.find('/', std::string("results/").size());
  return file.substr(run + 1);
}

int run(const std::string& stage, const Words& words) {
  const Options options = options_in(words);
  const Words outputs = outputs_of(stage, options);
  const std::string cell = cell_of(outputs.front());
  std::ifstream broken("broken");
  for (std::string line; std::getline(broken, line);) {
    if (line != fmt::format("{} {}", stage, cell)) continue;
    std::cerr << stage << ": the reason\n";
    return 65;
  }
  std::string command = stage;
  for (const std::string& word : words) command += ' ' + word;
  const std::string called = options.contains("keep-features")     ? "features"
                             : options.contains("keep-classifier") ? "keep"
                                                                   : stage;
  std::ofstream("calls", std::ios::app)
      << called + ' ' + fs::path(cell).parent_path().string() + '\n';
  const bool is_artefact = kinds.contains(stage);
  const artefact::Provenance provenance =
      is_artefact ? provenance_of(stage, options) : artefact::Provenance();
  for (const std::string& output : outputs) {
    if (is_artefact) {
      write_artefact(output, stage, command, provenance);
    } else {
      std::ofstream(output) << table_text(output, command);
    }
  }
  std::cout << stage << ": 1 thing done\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return ::run(fs::path(argv[0]).filename(), Words(argv + 1, argv + argc));
  } catch (const Error& error) {
    std::cerr << fs::path(argv[0]).filename().string() << ": " << error.what() << '\n';
    return static_cast<int>(error.exit());
  }
}
