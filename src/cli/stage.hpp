#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "artefact/provenance.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/error.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// Returns freed memory of 1 MB or more at once, instead of keeping it for later. For programs that
/// read one large record after another.
void release_freed_memory();

/// Shared parts of all stage programs: help with an example, options from the command line and a
/// TOML file, provenance, one-line errors, and exit codes.
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

  /// Returns the object to which the program's own options are added.
  [[nodiscard]] Options options() { return Options(*app_); }

  /// Adds a required option that names a file or folder. Such options are not recorded as settings:
  /// the settings do not depend on the folder.
  Option input_file(const std::string& option, std::filesystem::path& path,
                    const std::string& help);
  Option output_file(const std::string& option, std::filesystem::path& path,
                     const std::string& help);
  /// Adds a flag that only decides if files are written, and is not recorded as a setting.
  Option file_flag(const std::string& option, bool& value, const std::string& help);

  /// Records an option only if its value is not the default. For options that were added after
  /// files were promised to stay identical to the last byte.
  void record_unless_default(const std::string& option);

  /// Reads the value of one option before the other options are added, because they depend on it:
  /// `--method` decides which options `train` has. The value comes from the command line or the
  /// TOML file. It also names the table of the TOML file with the options of this variant. Returns
  /// an empty text if the option is not given or the command line is invalid, which run() then
  /// reports.
  std::string choose_variant(int argc, char** argv, const std::string& option);

  /// Parses the command line and runs the body. Turns errors into one line on standard error and an
  /// exit code.
  int run(int argc, char** argv, const std::function<void()>& body);

  /// Opens an artefact of this kind. Artefacts saved later record it as an input in this role.
  artefact::Reader open(const std::string& role, const std::filesystem::path& path,
                        const std::string& kind);
  /// Records a file that is not an artefact as an input of artefacts saved later, with the sha256
  /// of its bytes.
  void note_input(const std::string& role, const std::filesystem::path& path);

  /// Records a file with a known digest and the given name, once.
  void note_input(const std::string& role, const std::string& name, const std::string& digest);

  /// Protects a file from being replaced by an output although provenance does not record it, such
  /// as a recording.
  void note_read(const std::filesystem::path& path);

  /// Throws Error(usage) if the path is that of an input, which an output must not replace.
  void require_no_input(const std::filesystem::path& path) const;

  /// Checks several outputs. Empty paths stand for outputs that are not written. Throws
  /// Error(usage) also if two of them are the same file.
  void require_free(std::vector<std::filesystem::path> outputs) const;

  /// Writes an artefact with its provenance. require_no_input() must have accepted the path. A step
  /// of a run (pipeline/step.sh) also adds a line to the journal of the run.
  void save(artefact::Writer& writer, const std::filesystem::path& path) const;

  /// Returns the program, all options except files, with their values, and the inputs opened so
  /// far.
  [[nodiscard]] artefact::Provenance provenance() const;

 private:
  [[nodiscard]] std::string resolved_options() const;
  /// Returns the error line. Rooms that check the content of inputs do not know their files, so the
  /// names are prepended here.
  [[nodiscard]] std::string with_input_names(const Error& error) const;

  std::string name_;
  std::unique_ptr<CLI::App> app_;
  std::vector<std::string> recorded_unless_default_;
  std::vector<artefact::Provenance::Input> inputs_;
  std::set<std::pair<std::string, std::string>> named_inputs_;  ///< role and name
  std::vector<std::filesystem::path> input_paths_;
  std::vector<std::filesystem::path> read_paths_;  ///< inputs and all other files that are read
};

}  // namespace piae::cli
