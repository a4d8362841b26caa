#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "artefact/provenance.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/error.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// What all stage programs share: help with an example, options from the command line and from a
/// TOML file, provenance, one line for an error, and exit codes.
///
///     int main(int argc, char** argv) {
///       cli::Stage stage("split", "Cuts records into windows ...", "split --records ...");
///       SplitOptions options;
///       bind(stage.options(), options);
///       fs::path records;
///       stage.input_file("--records", records, "records.h5 made by ingest or simulate");
///       return stage.run(argc, argv, [&] {
///         const auto recordings = read_recordings(stage.open("records", records, "records"));
///         ...
///         stage.save(writer, output);
///       });
///     }
class Stage {
 public:
  Stage(std::string name, const std::string& summary, const std::string& example);

  ~Stage();

  /// Where the program's own options are added.
  [[nodiscard]] Options options() { return Options(*app_); }

  /// A required option that names a file or folder. Such options are not part of the recorded
  /// settings: the same settings in another folder are the same settings.
  Option input_file(const std::string& option, std::filesystem::path& path,
                    const std::string& help);
  Option output_file(const std::string& option, std::filesystem::path& path,
                     const std::string& help);
  /// A flag that says only whether files are written. It is not part of the recorded settings
  /// either.
  Option file_flag(const std::string& option, bool& value, const std::string& help);

  /// Leaves an option out of the recorded settings while it has its default. It came after files
  /// were promised to be the same to the last byte, and they are where it is not given.
  void record_unless_default(const std::string& option);

  /// Reads the value of one option before the other options are added, because which ones there are
  /// depends on it: `--method` decides which options `train` has. It is read from the command line
  /// or the TOML file, and is also the name of the table in the TOML file that holds the options of
  /// this variant. Empty where it is not given, or where the command line cannot be parsed; run()
  /// then reports why.
  std::string choose_variant(int argc, char** argv, const std::string& option);

  /// Parses, runs the body, and turns errors into one line on standard error and an exit code.
  int run(int argc, char** argv, const std::function<void()>& body);

  /// Opens an artefact, which must be of this kind. Whatever is saved later names it as an input,
  /// in this role.
  artefact::Reader open(const std::string& role, const std::filesystem::path& path,
                        const std::string& kind);
  /// Makes whatever is saved later name this file, which is not an artefact, as an input, with the
  /// sha256 of its bytes.
  void note_input(const std::string& role, const std::filesystem::path& path);

  /// The same for a file of which the caller knows the digest, by the name that it has there.
  void note_input(const std::string& role, const std::string& name, const std::string& digest);

  /// A file that is read and that provenance does not name, such as a recording, must not be
  /// replaced either.
  void note_read(const std::filesystem::path& path);

  /// Throws Error(usage) where the path is that of an input, which an output must not replace.
  void require_no_input(const std::filesystem::path& path) const;

  /// The same of several outputs, of which those that are not wanted are empty paths; Error(usage)
  /// also where two of them are one file.
  void require_free(std::vector<std::filesystem::path> outputs) const;

  /// Writes an artefact with its provenance, to a path for which require_no_input() holds. As a
  /// step of a run (pipeline/step.sh) it adds a line to the run's journal.
  void save(artefact::Writer& writer, const std::filesystem::path& path) const;

  /// The program, all options but those of files with their values, and the inputs opened so far.
  [[nodiscard]] artefact::Provenance provenance() const;

 private:
  [[nodiscard]] std::string resolved_options() const;
  /// The line of an error. What is wrong with the content of the inputs is found by rooms that know
  /// no files, so their names are put before it.
  [[nodiscard]] std::string with_input_names(const Error& error) const;

  std::string name_;
  std::unique_ptr<CLI::App> app_;
  std::vector<std::string> recorded_unless_default_;
  std::vector<artefact::Provenance::Input> inputs_;
  std::vector<std::filesystem::path> input_paths_;
  std::vector<std::filesystem::path> read_paths_;  ///< those and the others that are read
};

}  // namespace piae::cli
