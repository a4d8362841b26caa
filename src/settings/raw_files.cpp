#include "settings/raw_files.hpp"

#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>

#include <algorithm>
#include <set>
#include <span>
#include <sstream>

#include "artefact/file.hpp"
#include "artefact/reader.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"
#include "text/lines.hpp"

namespace piae::settings {

namespace fs = std::filesystem;

namespace {

/// A file as it was read: how it looked, and its digest.
struct Seen {
  std::string stamp;
  std::string sha256;
};

/// What changes when a file is written, or another one takes its place: size, times of content and
/// of status, inode. Empty where there is no file.
std::string stamp_of(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  const auto nanoseconds = [](const timespec& time) {
    return fmt::format("{}.{:09}", time.tv_sec, time.tv_nsec);
  };
  return fmt::format("{} {} {} {}", status.st_size, nanoseconds(status.st_mtim),
                     nanoseconds(status.st_ctim), status.st_ino);
}

/// Lines of sha256, stamp and name.
std::map<std::string, Seen> read_stamps(const fs::path& file) {
  std::map<std::string, Seen> seen;
  if (!fs::is_regular_file(file)) return seen;
  try {
    for (const std::string& line : text::read_lines(file)) {
      std::istringstream words(line);
      std::string sha256;
      std::string size;
      std::string written;
      std::string changed;
      std::string inode;
      std::string name;
      words >> sha256 >> size >> written >> changed >> inode >> std::ws;
      if (!std::getline(words, name)) continue;
      seen[name] = {fmt::format("{} {} {} {}", size, written, changed, inode), sha256};
    }
  } catch (const Error&) {
    seen.clear();
  }
  return seen;
}

std::map<std::string, Seen> look_at(const std::vector<std::string>& files, const fs::path& data_dir,
                                    const fs::path& stamps) {
  const std::map<std::string, Seen> before = read_stamps(stamps);
  std::map<std::string, Seen> now;
  for (const std::string& name : files) {
    const std::string stamp = stamp_of(data_dir / name);
    if (stamp.empty()) continue;
    const auto known = before.find(name);
    const bool looks_the_same = known != before.end() && known->second.stamp == stamp;
    now[name] = {stamp, looks_the_same ? known->second.sha256 : sha256_of_file(data_dir / name)};
  }
  return now;
}

Digests digests_in(const std::map<std::string, Seen>& seen) {
  Digests digests;
  for (const auto& [name, each] : seen) digests[name] = each.sha256;
  return digests;
}

void note(const std::map<std::string, Seen>& seen, const fs::path& stamps) {
  std::string text;
  for (const auto& [name, each] : seen) {
    text += fmt::format("{} {} {}\n", each.sha256, each.stamp, name);
  }
  try {
    artefact::write_file_atomically(stamps, std::as_bytes(std::span(text)));
  } catch (const Error&) {
    return;
  }
}

}  // namespace

std::vector<std::string> raw_files_of(const toml::table& description) {
  std::set<std::string> files;
  if (const toml::array* records = description["record"].as_array()) {
    for (const toml::node& record : *records) {
      const toml::table* table = record.as_table();
      if (table == nullptr) continue;
      const auto file = (*table)["file"].value<std::string>();
      const bool is_name = file && file->find('\n') == std::string::npos;
      if (is_name) files.insert(*file);
    }
  }
  return {files.begin(), files.end()};
}

Digests digests_of(const std::vector<std::string>& files, const fs::path& data_dir,
                   const fs::path& stamps) {
  return digests_in(look_at(files, data_dir, stamps));
}

Digests noted_digests_of(const std::vector<std::string>& files, const fs::path& data_dir,
                         const fs::path& stamps) {
  const auto before = read_stamps(stamps);
  const auto now = look_at(files, data_dir, stamps);
  const auto is_noted = [&](const auto& each) {
    const auto found = before.find(each.first);
    return found != before.end() && found->second.stamp == each.second.stamp;
  };
  if (!std::ranges::all_of(now, is_noted)) note(now, stamps);
  return digests_in(now);
}

Digests digests_in_records(const fs::path& records) {
  Digests digests;
  try {
    const artefact::Reader reader(records, "records");
    for (const std::string& name : reader.list("/records")) {
      const std::string path = "/records/" + name;
      digests[reader.text(path, "source")] = reader.text(path, "source_sha256");
    }
  } catch (const Error&) {
    digests.clear();
  }
  return digests;
}

}  // namespace piae::settings
