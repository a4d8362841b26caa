#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "artefact/journal.hpp"

namespace piae::plan {

/// A file on the disk.
struct File {
  std::string digest;  ///< content digest of an artefact; sha256 of any other file
  std::optional<artefact::Made> made = std::nullopt;  ///< artefacts only
  std::string belongs_in =
      {};  ///< artefacts only: the expected file name, see artefact/belongs_in.hpp
  std::string problem = {};  ///< why an artefact cannot be read; else empty
};

/// The plan's view of the disk.
class Disk {
 public:
  Disk() = default;
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  virtual ~Disk() = default;

  /// Announces the files that find() will look up: reading many artefacts together is faster.
  virtual void read_ahead(const std::vector<std::string>& files) = 0;
  /// Returns null if the file does not exist.
  virtual const File* find(const std::string& file) = 0;
  /// Returns how a step made its outputs, if they do not record it themselves; null if unknown.
  virtual const artefact::DoneStep* done(const std::string& step) = 0;
  /// Lists the regular files below a folder, relative to it, in alphabetical order, without hidden
  /// ones. Returns an empty list if the folder does not exist.
  virtual std::vector<std::string> files_below(const std::string& folder) = 0;
  /// Returns the text of a small file; an empty text if it does not exist.
  virtual std::string text_of(const std::string& file) = 0;
};

/// The real disk, with the journals of runs: an unchanged file is not read again.
class RealDisk : public Disk {
 public:
  /// `runs` are folders such as results/try. With `may_write` the journals are saved.
  explicit RealDisk(const std::vector<std::string>& runs, bool may_write);
  ~RealDisk() override;

  void read_ahead(const std::vector<std::string>& files) override;
  const File* find(const std::string& file) override;
  const artefact::DoneStep* done(const std::string& step) override;
  std::vector<std::string> files_below(const std::string& folder) override;
  std::string text_of(const std::string& file) override;

  void note(const std::string& step, artefact::DoneStep done);
  void save();

 private:
  artefact::Journal& journal_of(const std::string& file);
  artefact::Journal& journal(std::size_t run);
  const File* keep(const std::string& file, std::optional<File> found);
  std::optional<File> known(const std::string& file, const artefact::Stat& stat);
  void note_read(const std::string& file, const artefact::Stat& stat, const File& found);

  std::vector<std::string> runs_;
  std::vector<std::unique_ptr<artefact::Journal>> journals_;  ///< each read at first use
  std::unordered_map<std::string, std::optional<File>> seen_;
  bool may_write_;
};

}  // namespace piae::plan
