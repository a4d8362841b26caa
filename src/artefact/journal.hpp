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

/// Describes a file as the file system sees it. It changes when the file is written or replaced.
struct Stat {
  std::uint64_t size = 0;  ///< bytes
  std::uint64_t inode = 0;
  std::int64_t written = 0;  ///< time of its content, ns since 1970
  std::int64_t changed = 0;  ///< time of its status, ns since 1970

  bool operator==(const Stat&) const = default;
};

/// Empty where there is no such file, or something that is no file.
std::optional<Stat> stat_of(const std::filesystem::path& file);

/// An input by its role, and the beginning of its digest.
struct MadeFrom {
  std::string role;  ///< "known"; of several inputs in one role with the name, "recording 105.mat"
  std::string digest;

  bool operator==(const MadeFrom&) const = default;
};

/// How something was made: the options of the program as TOML lines, and what it read.
struct Made {
  std::shared_ptr<const std::string> options;
  std::vector<MadeFrom> inputs;
};

/// The beginning of a digest, 128 bits as 32 hexadecimal digits: enough to tell contents apart.
std::string short_digest(const std::string& digest);

/// The same as provenance says it.
Made made_by(const Provenance& provenance);

/// A file as it was when it was read last.
struct SeenFile {
  Stat stat;
  std::string digest;
  std::optional<Made> made = std::nullopt;  ///< of an artefact
  std::string belongs_in = {};              ///< of an artefact, see belongs_in.hpp
};

/// How a step made files that do not say so themselves: tables, figures, pages.
struct DoneStep {
  Made made;
  std::vector<MadeFrom> outputs;  ///< each file, relative to the run, with its digest
};

/// Remembers the files of a run, so that they need not be opened: RUN/.journal. A cache: removed,
/// it comes back from the artefacts, and tables are made once more. Stages add a line for each
/// artefact that they write, so that it need not be opened again; several processes may add lines
/// at once. A line that is damaged is as if it were not there.
class Journal {
 public:
  /// Reads that of a run's folder; it need not be there. Throws Error(bad_input) where something
  /// else has its place, such as a link: nothing could be remembered.
  explicit Journal(std::filesystem::path run);

  /// Null where nothing is known. `file` is a path as programs get it.
  [[nodiscard]] const SeenFile* file(const std::string& file) const;
  [[nodiscard]] const DoneStep* step(const std::string& name) const;

  void note(const std::string& file, SeenFile seen);
  void note(const std::string& step, DoneStep done);

  /// Adds to the file what was noted since it was read; where many of its lines have been replaced
  /// by later ones, writes it anew. Where it cannot be written, it is left as it is.
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

/// Adds a line for an artefact that was just written. Where it cannot be written, nothing is lost.
void add_to_journal(const std::filesystem::path& run, const std::filesystem::path& file,
                    const Written& written, const Provenance& provenance);

}  // namespace piae::artefact
