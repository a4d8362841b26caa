#include "plan/disk.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "artefact/digest.hpp"
#include "artefact/reader.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"

namespace piae::plan {

namespace {

using artefact::Made;

/// Adds the recordings that records.h5 lists: older programs did not record them as inputs.
void add_recordings(const artefact::Reader& records, Made& made) {
  const auto is_recording = [](const artefact::MadeFrom& from) {
    return from.role.starts_with("recording ");
  };
  if (std::ranges::any_of(made.inputs, is_recording)) return;
  for (const std::string& name : records.list("/records")) {
    const std::string path = "/records/" + name;
    const std::string sha256 = records.text(path, "source_sha256");
    if (sha256.empty()) continue;
    const std::string role = "recording " + records.text(path, "source");
    if (std::ranges::count(made.inputs, role, &artefact::MadeFrom::role) == 0) {
      made.inputs.push_back({role, artefact::short_digest(sha256)});
    }
  }
}

/// Parses a line such as "known C.h5 efb1...".
artefact::Provenance::Input parse_input(const std::string& line) {
  const std::size_t role = line.find(' ');
  const std::size_t digest = line.rfind(' ');
  if (role == std::string::npos || digest <= role) return {.role = line, .file = {}, .digest = {}};
  return {.role = line.substr(0, role),
          .file = line.substr(role + 1, digest - role - 1),
          .digest = line.substr(digest + 1)};
}

File described(const artefact::Reader& reader) {
  artefact::Provenance provenance;
  provenance.options = reader.strings(artefact::provenance_group + "/options").front();
  for (const std::string& line : reader.strings(artefact::provenance_group + "/inputs")) {
    provenance.inputs.push_back(parse_input(line));
  }
  File file{.digest = artefact::short_digest(reader.digest()),
            .made = artefact::made_by(provenance),
            .belongs_in = reader.belongs_in()};
  if (reader.kind() == "records") add_recordings(reader, *file.made);
  return file;
}

bool is_artefact(const std::string& file) { return file.ends_with(".h5"); }

File read_next(artefact::Readers& readers) {
  try {
    return described(readers.next());
  } catch (const Error& error) {
    return {.digest = {}, .problem = error.what()};
  }
}

}  // namespace

RealDisk::RealDisk(const std::vector<std::string>& runs, bool may_write)
    : runs_(runs), journals_(runs.size()), may_write_(may_write) {}

RealDisk::~RealDisk() = default;

artefact::Journal& RealDisk::journal_of(const std::string& file) {
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    if (file.starts_with(runs_[run] + '/')) return journal(run);
  }
  return journal(0);  // for files outside: recordings, the paper's tables
}

artefact::Journal& RealDisk::journal(std::size_t run) {
  if (!journals_[run]) journals_[run] = std::make_unique<artefact::Journal>(runs_[run]);
  return *journals_[run];
}

const File* RealDisk::keep(const std::string& file, std::optional<File> found) {
  const auto& kept = seen_.insert_or_assign(file, std::move(found)).first->second;
  return kept ? &*kept : nullptr;
}

std::optional<File> RealDisk::known(const std::string& file, const artefact::Stat& stat) {
  const artefact::SeenFile* const seen = journal_of(file).file(file);
  if (seen == nullptr || seen->stat != stat) return std::nullopt;
  return File{.digest = seen->digest, .made = seen->made, .belongs_in = seen->belongs_in};
}

void RealDisk::note_read(const std::string& file, const artefact::Stat& stat, const File& found) {
  if (!found.problem.empty()) return;
  journal_of(file).note(file, artefact::SeenFile{stat, found.digest, found.made, found.belongs_in});
}

void RealDisk::read_ahead(const std::vector<std::string>& files) {
  std::vector<std::pair<std::string, artefact::Stat>> unknown;
  std::vector<std::filesystem::path> paths;
  for (const std::string& file : files) {
    if (!is_artefact(file) || seen_.contains(file)) continue;
    const auto stat = artefact::stat_of(file);
    std::optional<File> found = stat ? known(file, *stat) : std::nullopt;
    if (stat && !found) {
      unknown.emplace_back(file, *stat);
      paths.emplace_back(file);
    } else {
      keep(file, std::move(found));
    }
  }
  artefact::Readers readers(std::move(paths), "");
  for (const auto& [file, stat] : unknown) {
    File found = read_next(readers);
    note_read(file, stat, found);
    keep(file, std::move(found));
  }
}

const File* RealDisk::find(const std::string& file) {
  if (const auto found = seen_.find(file); found != seen_.end()) {
    return found->second ? &*found->second : nullptr;
  }
  if (is_artefact(file)) {
    read_ahead({file});
    return find(file);
  }
  const auto stat = artefact::stat_of(file);
  if (!stat) return keep(file, std::nullopt);
  std::optional<File> found = known(file, *stat);
  if (!found) {
    found = File{.digest = artefact::short_digest(sha256_of_file(file))};
    note_read(file, *stat, *found);
  }
  return keep(file, std::move(found));
}

std::vector<std::string> RealDisk::files_below(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code none;
  auto entry = std::filesystem::recursive_directory_iterator(folder, none);
  if (none) return files;
  const std::string prefix = folder + '/';
  for (; entry != std::filesystem::recursive_directory_iterator(); entry.increment(none)) {
    const std::string path = entry->path().string();
    if (entry->path().filename().string().starts_with('.')) {
      if (entry->is_directory(none)) entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_regular_file(none)) files.push_back(path.substr(prefix.size()));
  }
  std::ranges::sort(files);
  return files;
}

std::string RealDisk::text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const artefact::DoneStep* RealDisk::done(const std::string& step) {
  return journal_of(step).step(step);
}

void RealDisk::note(const std::string& step, artefact::DoneStep done) {
  journal_of(step).note(step, std::move(done));
}

void RealDisk::save() {
  if (!may_write_) return;
  for (const auto& journal : journals_) {
    if (journal) journal->save();
  }
}

}  // namespace piae::plan
