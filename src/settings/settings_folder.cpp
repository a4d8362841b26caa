#include "settings/settings_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <span>
#include <sstream>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "settings/groups.hpp"
#include "settings/protocol.hpp"
#include "settings/raw_files.hpp"
#include "signal/description_file.hpp"
#include "text/lines.hpp"

namespace piae::settings {

namespace fs = std::filesystem;

namespace {

const std::string options_line = "# Options given by make: ";

struct Request {
  fs::path file;  ///< within the folder
  std::string options;
  std::string stage;    ///< empty for a description of a data set
  std::string variant;  ///< of the stage, or the data set

  [[nodiscard]] bool is_of_recordings() const { return file.parent_path() == "recordings"; }
  [[nodiscard]] bool is_description() const { return stage.empty() && !is_of_recordings(); }
  [[nodiscard]] bool is_split_of_dataset() const { return stage == "split" && !variant.empty(); }
};

Request parse_request(const std::string& text) {
  Request request;
  const std::size_t space = text.find(' ');
  request.file = text.substr(0, space);
  if (space != std::string::npos) request.options = text.substr(space + 1);
  const std::string name = request.file.stem().string();
  const bool in_folder = request.file.has_parent_path();
  if (request.file.extension() != ".toml" ||
      (in_folder && request.file.parent_path() != "datasets" && !request.is_of_recordings())) {
    throw Error(Exit::usage, "'" + text + "' is no settings file; such are train.smote.toml, " +
                                 "datasets/cwru.toml and 'split.toml --protocol random'");
  }
  if (in_folder) {
    request.variant = name;
    return request;
  }
  const std::size_t dot = name.find('.');
  request.stage = name.substr(0, dot);
  if (dot != std::string::npos) request.variant = name.substr(dot + 1);
  const std::size_t at = request.stage.find('@');
  if (at != std::string::npos) {
    request.variant = request.stage.substr(at + 1);
    request.stage.resize(at);
  }
  return request;
}

/// What of a file counts. The files of a run may be older than this program: those that hold whole
/// tables of the protocol count as what the stage reads from them.
toml::table values_in(const Request& request, const toml::table& file) {
  return request.is_description() ? file : cli::options_of(file, request.stage, request.variant);
}

/// The options that a settings file says make has given.
std::string options_in(const fs::path& file) {
  for (const std::string& line : text::read_lines(file)) {
    if (line.starts_with(options_line)) return line.substr(options_line.size());
  }
  return {};
}

/// A folder that is locked as long as this lives. Where the file system has no locks it is not, and
/// all that can happen is that a file is written twice.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0) (void)::flock(descriptor_, LOCK_EX);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  int descriptor_;
};

void require_no_link(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_symlink(folder, none)) return;
  throw Error(Exit::failed,
              folder.string() + ": is a link, and settings are not written through one; remove it");
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw Error(Exit::failed, folder.string() + ": cannot make this folder: " + error.message());
  }
}

/// The source of a settings file, and the values that it is to hold.
struct Wanted {
  fs::path source;
  toml::table values;
};

/// What the description of a data set says of the stage split, in the place of what all have.
void add_own_split(const fs::path& pipeline, const std::string& dataset, Wanted& wanted) {
  wanted.source = pipeline / "datasets" / (dataset + ".toml");
  const toml::table description = signal::read_description_file(wanted.source);
  const toml::table* own = description["split"].as_table();
  if (own == nullptr) return;
  for (const auto& [key, node] : *own) wanted.values.insert_or_assign(key, node);
}

Wanted wanted(const Request& request, const fs::path& pipeline, const toml::table& protocol) {
  if (request.is_description()) {
    const fs::path source = pipeline / request.file;
    return {source, signal::read_description_file(source)};
  }
  if (request.stage == "transfer") require_datasets(protocol, request.variant, pipeline);
  Wanted wanted{pipeline / "protocol.toml",
                cli::options_of(protocol, request.stage, request.variant)};
  if (request.is_split_of_dataset()) add_own_split(pipeline, request.variant, wanted);
  return wanted;
}

bool already_holds(const fs::path& file, const Request& request, const toml::table& values) {
  if (!fs::is_regular_file(file)) return false;
  try {
    if (options_in(file) != request.options) return false;
    return values_in(request, cli::parse_toml_file(file)) == values;
  } catch (const Error&) {
    return false;
  }
}

/// What concerns the recordings of one data set in a run.
struct RecordingsOf {
  fs::path file;
  fs::path stamps;
  fs::path records;
  fs::path data_dir;
  std::vector<std::string> names;
};

RecordingsOf recordings_of(const Request& request, const fs::path& pipeline,
                           const fs::path& folder) {
  const fs::path source = pipeline / "datasets" / (request.variant + ".toml");
  const fs::path file = folder / request.file;
  return {.file = file,
          .stamps = fs::path(file).replace_extension(".stamps"),
          .records = folder.parent_path() / request.variant / "records.h5",
          .data_dir = request.options,
          .names = raw_files_of(signal::read_description_file(source))};
}

/// The digests in a settings file; empty where it is none.
Digests read_digests(const fs::path& file) {
  Digests digests;
  try {
    for (const auto& [name, node] : cli::parse_toml_file(file)) {
      digests[std::string(name.str())] = node.value_or<std::string>("");
    }
  } catch (const Error&) {
    digests.clear();
  }
  return digests;
}

/// What the records of the run were made of, or are about to be. Empty where nothing says it.
Digests digests_before(const RecordingsOf& of) {
  if (fs::exists(of.file)) return read_digests(of.file);
  return fs::exists(of.records) ? digests_in_records(of.records) : Digests{};
}

bool are_others(const RecordingsOf& of, bool may_note) {
  const Digests before = digests_before(of);
  // Records that nobody can read, or made by something else: there is nothing to compare.
  if (before.empty() && !fs::exists(of.file) && fs::exists(of.records)) return false;
  const bool notes = may_note && fs::is_directory(of.stamps.parent_path());
  const Digests now = notes ? noted_digests_of(of.names, of.data_dir, of.stamps)
                            : digests_of(of.names, of.data_dir, of.stamps);
  return std::ranges::any_of(now, [&](const auto& each) {
    const auto found = before.find(each.first);
    return found == before.end() || found->second != each.second;
  });
}

/// Those that are there, and of the others what was known of them.
Digests digests_now(const RecordingsOf& of) {
  const Digests before = digests_before(of);
  Digests digests = noted_digests_of(of.names, of.data_dir, of.stamps);
  for (const std::string& name : of.names) {
    const auto found = before.find(name);
    if (found != before.end()) digests.insert(*found);
  }
  return digests;
}

std::string text_of(const Digests& digests) {
  toml::table values;
  for (const auto& [name, sha256] : digests) values.insert(name, sha256);
  std::ostringstream text;
  text << "# The raw recordings that records.h5 is made of, by their sha256.\n"
       << toml::toml_formatter(values) << '\n';
  return text.str();
}

std::string text_of(const Request& request, const Wanted& wanted) {
  std::ostringstream text;
  text << "# Made from " << wanted.source.string() << "; edit that file, not this one.\n";
  if (!request.options.empty()) text << options_line << request.options << '\n';
  text << toml::toml_formatter(wanted.values) << '\n';
  return text.str();
}

}  // namespace

SettingsFolder::SettingsFolder(const fs::path& pipeline, fs::path folder)
    : pipeline_(pipeline),
      folder_(std::move(folder)),
      protocol_(read_protocol(pipeline / "protocol.toml")) {}

bool SettingsFolder::is_outdated(const std::string& text, bool may_note) const {
  const Request request = parse_request(text);
  if (request.is_of_recordings()) {
    return are_others(recordings_of(request, pipeline_, folder_), may_note);
  }
  return !already_holds(folder_ / request.file, request,
                        wanted(request, pipeline_, protocol_).values);
}

void SettingsFolder::update(const std::string& text) const {
  const Request request = parse_request(text);
  const fs::path file = folder_ / request.file;
  require_no_link(folder_);
  require_no_link(file.parent_path());
  make_folder(file.parent_path());
  const FolderLock lock(file.parent_path());
  std::string wanted_text;
  if (request.is_of_recordings()) {
    const RecordingsOf of = recordings_of(request, pipeline_, folder_);
    const Digests digests = digests_now(of);
    if (fs::exists(file) && read_digests(file) == digests) return;
    wanted_text = text_of(digests);
  } else {
    const Wanted content = wanted(request, pipeline_, protocol_);
    if (already_holds(file, request, content.values)) return;
    wanted_text = text_of(request, content);
  }
  artefact::write_file_atomically(file, std::as_bytes(std::span(wanted_text)));
}

}  // namespace piae::settings
