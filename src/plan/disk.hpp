#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "artefact/journal.hpp"

namespace piae::plan {

/// A file as it lies on the disk.
struct File {
  std::string digest;  ///< of an artefact its content digest, else the sha256
  std::optional<artefact::Made> made = std::nullopt;  ///< of an artefact
  std::string belongs_in =
      {};                    ///< of an artefact: the name of its file, see artefact/belongs_in.hpp
  std::string problem = {};  ///< why an artefact cannot be read; else empty
};

/// Answers the questions that a plan has about the disk.
class Disk {
 public:
  Disk() = default;
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  virtual ~Disk() = default;

  /// Says which files find() will be asked for: many artefacts are read faster together.
  virtual void read_ahead(const std::vector<std::string>& files) = 0;
  /// Null where there is no such file.
  virtual const File* find(const std::string& file) = 0;
  /// How a step made its outputs, where these do not say so themselves; null where nobody knows.
  virtual const artefact::DoneStep* done(const std::string& step) = 0;
  /// The regular files below a folder, relative to it, in alphabetical order; none where there is
  /// no folder. What is hidden is left out.
  virtual std::vector<std::string> files_below(const std::string& folder) = 0;
  /// The text of a small file; empty where there is none.
  virtual std::string text_of(const std::string& file) = 0;
};

/// The disk itself, with the journals of runs: a file that looks as it did is not read again.
class RealDisk : public Disk {
 public:
  /// `runs` are folders such as results/try. With `may_write` the journals keep what was seen.
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
  std::vector<std::unique_ptr<artefact::Journal>> journals_;  ///< each read when it is needed
  std::unordered_map<std::string, std::optional<File>> seen_;
  bool may_write_;
};

}  // namespace piae::plan
