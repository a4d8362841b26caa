#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace piae::settings {

/// The sha256 of raw recordings, by their names below the data folder.
using Digests = std::map<std::string, std::string>;

/// The files that the records of a description name, each once, in alphabetical order. What is
/// wrong with a description, ingest says.
std::vector<std::string> raw_files_of(const toml::table& description);

/// The digests of those of these files that are there. `stamps` is a file that remembers of each
/// file what it looked like to the file system when it was read: one that looks the same, from
/// whatever folder, is not read again. It need not be there.
Digests digests_of(const std::vector<std::string>& files, const std::filesystem::path& data_dir,
                   const std::filesystem::path& stamps);

/// The same, and then notes in `stamps` how these files look now. Where that cannot be written,
/// they are read again next time.
Digests noted_digests_of(const std::vector<std::string>& files,
                         const std::filesystem::path& data_dir,
                         const std::filesystem::path& stamps);

/// The digests that records.h5 holds of what it was made of. Empty where it cannot be read, which
/// the next stage says.
Digests digests_in_records(const std::filesystem::path& records);

}  // namespace piae::settings
