#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "artefact/provenance.hpp"
#include "artefact/writer.hpp"

namespace piae::artefact {

/// Status of a file in the file system. It changes when the file is written or replaced.
struct Stat {
  std::uint64_t size = 0;  ///< bytes
  std::uint64_t inode = 0;
  std::int64_t written = 0;  ///< modification time, ns since 1970
  std::int64_t changed = 0;  ///< status change time, ns since 1970

  bool operator==(const Stat&) const = default;
};

/// Returns an empty value if the file does not exist or is not a regular file.
std::optional<Stat> stat_of(const std::filesystem::path& file);

/// An input by its role and the beginning of its digest.
struct MadeFrom {
  std::string
      role;  ///< "known"; with the file name if a role has several inputs, "recording 105.mat"
  std::string digest;

  bool operator==(const MadeFrom&) const = default;
};

/// Record of how something was made: the options of the program as TOML lines, and its inputs.
struct Made {
  std::shared_ptr<const std::string> options;
  std::vector<MadeFrom> inputs;
};

/// Returns the first 128 bits of a digest, 32 hexadecimal digits: enough to distinguish contents.
std::string short_digest(const std::string& digest);

/// Returns the same record from provenance.
Made made_by(const Provenance& provenance);

/// Status and contents of a file when it was last read.
struct SeenFile {
  Stat stat;
  std::string digest;
  std::optional<Made> made = std::nullopt;  ///< artefacts only
  std::string belongs_in = {};              ///< artefacts only, see belongs_in.hpp
};

/// Record of how a step made files that do not record it themselves: tables, figures, pages.
struct DoneStep {
  Made made;
  std::vector<MadeFrom> outputs;  ///< files, relative to the run, with their digests
};

/// Cache of what is known about the files of a run, so that they are not opened again:
/// RUN/.journal. If it is removed, artefacts fill it again and tables are remade. Stages add a line
/// for each artefact that they write. Several processes may add lines at once. Damaged lines are
/// ignored.
class Journal {
 public:
  /// Reads the journal in the folder of a run, if it exists. Throws Error(bad_input) if its path is
  /// not a regular file, such as a link, since it could then not be written.
  explicit Journal(std::filesystem::path run);

  /// Returns null if nothing is known. `file` is a path as programs get it.
  [[nodiscard]] const SeenFile* file(const std::string& file) const;
  [[nodiscard]] const DoneStep* step(const std::string& name) const;

  void note(const std::string& file, SeenFile seen);
  void note(const std::string& step, DoneStep done);

  /// Appends what was noted since the journal was read. Rewrites the file if later lines have
  /// replaced many of its lines. Leaves the file as it is if it cannot be written.
  void save();

 private:
  [[nodiscard]] std::string name_of(const std::string& file) const;
  void take(std::string_view text);
  [[nodiscard]] std::string whole_text() const;
  void compact() const;

  std::filesystem::path run_;
  std::string prefix_;
  std::unordered_map<std::string, SeenFile> files_;
  std::unordered_map<std::string, DoneStep> steps_;
  std::unordered_map<std::string, std::shared_ptr<const std::string>> options_;
  std::string added_;
  std::size_t read_bytes_ = 0;
  std::size_t read_lines_ = 0;
};

/// Adds a line for an artefact that was just written. A failure is harmless: the file is then read
/// again.
void add_to_journal(const std::filesystem::path& run, const std::filesystem::path& file,
                    const Written& written, const Provenance& provenance);

}  // namespace piae::artefact
