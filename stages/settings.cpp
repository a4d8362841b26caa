// Answers make's questions about settings. It is what make reads TOML with.

#include <iostream>

#include "base/error.hpp"
#include "cli/stage.hpp"
#include "settings/facts.hpp"
#include "settings/settings_folder.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void print_facts(const fs::path& pipeline) {
  for (const std::string& fact : settings::facts(pipeline)) std::cout << fact << '\n';
}

/// The names of the files that are outdated, each as it was asked for, without its options.
void print_outdated(const settings::SettingsFolder& folder,
                    const std::vector<std::string>& requests, bool may_note) {
  for (const std::string& request : requests) {
    if (folder.is_outdated(request, may_note))
      std::cout << request.substr(0, request.find(' ')) << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "settings",
      "Tells make what there is (methods, ratios, data sets, ...) and which settings "
      "files of a run are not as pipeline/ has them, and writes those. A settings file "
      "is asked for by its name and the options that make gives to its stage: "
      "'split.toml --protocol random'.",
      "settings --facts\n  settings --folder results/try/.settings --outdated "
      "train.smote.toml 'split.toml --protocol random'");
  fs::path pipeline = "pipeline";
  fs::path folder;
  bool facts = false;
  std::vector<std::string> outdated;
  std::string update;
  bool note = false;
  stage.input_file("--pipeline", pipeline, "Folder with protocol.toml and datasets/")
      .required(false);
  stage.output_file("--folder", folder, "Settings of a run: results/RUN/.settings").required(false);
  stage.options().flag("--facts", facts, "Print what there is, as words KIND:VALUE");
  stage.options().add("--outdated", outdated, "Print which of these files are to be written");
  stage.options().flag("--note", note,
                       "With --outdated: note how recordings look that are the same as before");
  stage.options().add("--update", update, "Write this file, unless it is as it should be");

  return stage.run(argc, argv, [&] {
    if (facts) return print_facts(pipeline);
    if (folder.empty()) {
      throw Error(Exit::usage,
                  "--facts, or --folder with --outdated or --update, is required "
                  "(see settings --help)");
    }
    const settings::SettingsFolder settings_folder(pipeline, folder);
    print_outdated(settings_folder, outdated, note);
    if (!update.empty()) settings_folder.update(update);
  });
}
