#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

namespace piae::settings {

/// The settings of a run, in small files of results/RUN/.settings: one for each stage, method and
/// data set. They are what make knows by that a step is to be run again, and also what the stages
/// read by --config, so that what is compared is what is used.
///
/// A file is asked for by its name, and with it the options on the stage's command line that count
/// as settings too: "split.toml --protocol random". The name says what it holds:
///
///     STAGE.toml, STAGE.NAME.toml   what the stage reads from pipeline/protocol.toml, for the
///                                   variant NAME where there is a table [STAGE.NAME]
///     STAGE@NAME.DATASET.toml       the same where each data set has a file of its own
///     split.NAME.toml               what split reads for the data set NAME: [split] of its
///                                   description on top of that of the protocol
///     transfer.NAME.toml            what transfer reads of the group NAME, all of whose data sets
///                                   must have a description
///     recordings/NAME.toml DIR      the sha256 of each raw recording of the data set NAME below
///     the
///                                   folder DIR, as it was when the records were made
///     datasets/NAME.toml            the description pipeline/datasets/NAME.toml, completed by the
///                                   one that it is like
///
/// Files hold values alone, in alphabetical order. They are compared by value: neither comments nor
/// spacing nor the order of tables make a difference. So do recordings: from whatever folder, the
/// same bytes are the same recording. One that is not there has not changed, so that a run which
/// was copied without its recordings stays as it is.
class SettingsFolder {
 public:
  /// `pipeline` is the folder with protocol.toml and datasets/. Throws as read_protocol does.
  SettingsFolder(const std::filesystem::path& pipeline, std::filesystem::path folder);

  /// Whether the file is missing or holds something else. Reads only; where a recording looks other
  /// than before but is the same, `may_note` lets that be noted, so that it is not read once more
  /// next time. Recordings of a run whose records.h5 is there without such a file are compared with
  /// what that was made of. Throws Error(bad_input) and
  /// Error(input_missing) where its source cannot be read.
  [[nodiscard]] bool is_outdated(const std::string& request, bool may_note = false) const;

  /// Writes the file where it is outdated, and else leaves it as it is, with its time. Programs
  /// that do so at once do not disturb each other: one writes, the others find it written. Throws
  /// Error(failed) when it cannot be written.
  void update(const std::string& request) const;

 private:
  std::filesystem::path pipeline_;
  std::filesystem::path folder_;
  toml::table protocol_;
};

}  // namespace piae::settings
