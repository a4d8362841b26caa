#include "settings/settings_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <span>
#include <sstream>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "cli/toml_file.hpp"
#include "cli/toml_options.hpp"
#include "settings/groups.hpp"
#include "settings/protocol.hpp"
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

  [[nodiscard]] bool is_description() const { return stage.empty(); }
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
      (in_folder && request.file.parent_path() != "datasets")) {
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

bool SettingsFolder::is_outdated(const std::string& text) const {
  const Request request = parse_request(text);
  return !already_holds(folder_ / request.file, request,
                        wanted(request, pipeline_, protocol_).values);
}

void SettingsFolder::update(const std::string& text) const {
  const Request request = parse_request(text);
  const Wanted content = wanted(request, pipeline_, protocol_);
  const fs::path file = folder_ / request.file;
  require_no_link(folder_);
  require_no_link(file.parent_path());
  make_folder(file.parent_path());
  const FolderLock lock(file.parent_path());
  if (already_holds(file, request, content.values)) return;
  const std::string wanted_text = text_of(request, content);
  artefact::write_file_atomically(file, std::as_bytes(std::span(wanted_text)));
}

}  // namespace piae::settings
