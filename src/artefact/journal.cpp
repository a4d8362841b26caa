#include "artefact/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <span>
#include <string_view>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"

namespace piae::artefact {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view end_of_line = "\t.\n";  // missing in a line that was cut off

std::string escaped(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\\')
      line += "\\\\";
    else if (c == '\n')
      line += "\\n";
    else if (c == '\t')
      line += "\\t";
    else
      line += c;
  }
  return line;
}

std::string unescaped(std::string_view line) {
  if (line.find('\\') == std::string_view::npos) return std::string(line);
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\' || i + 1 == line.size()) {
      text += line[i];
      continue;
    }
    ++i;
    text += line[i] == 'n' ? '\n' : line[i] == 't' ? '\t' : line[i];
  }
  return text;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find('\t', begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

template <class T>
bool take_number(std::string_view& text, T& value) {
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  if (text.starts_with(' ')) text.remove_prefix(1);
  return true;
}

std::optional<Stat> parse_stat(std::string_view text) {
  Stat stat;
  const bool whole = take_number(text, stat.size) && take_number(text, stat.inode) &&
                     take_number(text, stat.written) && take_number(text, stat.changed);
  return whole && text.empty() ? std::optional(stat) : std::nullopt;
}

std::string text_of(const Stat& stat) {
  return std::to_string(stat.size) + ' ' + std::to_string(stat.inode) + ' ' +
         std::to_string(stat.written) + ' ' + std::to_string(stat.changed);
}

/// Formats pairs as fields "role=digest".
std::string text_of(const std::vector<MadeFrom>& pairs) {
  std::string text;
  for (const MadeFrom& pair : pairs) text += '\t' + escaped(pair.role) + '=' + pair.digest;
  return text;
}

std::vector<MadeFrom> parse_pairs(std::span<const std::string_view> fields) {
  std::vector<MadeFrom> pairs;
  for (const std::string_view field : fields) {
    const std::size_t equals = field.rfind('=');
    if (equals == std::string_view::npos) continue;
    pairs.push_back({unescaped(field.substr(0, equals)), std::string(field.substr(equals + 1))});
  }
  return pairs;
}

std::string hash_of(const std::string& options) {
  return short_digest(Sha256().update(options).finish_hex());
}

std::string options_line(const std::string& hash, const std::string& options) {
  return "options\t" + hash + '\t' + escaped(options) + std::string(end_of_line);
}

std::string file_line(const std::string& name, const SeenFile& seen) {
  const std::string line = escaped(name) + '\t' + text_of(seen.stat) + '\t' + seen.digest;
  if (!seen.made) return "file\t" + line + std::string(end_of_line);
  return "artefact\t" + line + '\t' + escaped(seen.belongs_in) + '\t' +
         hash_of(*seen.made->options) + text_of(seen.made->inputs) + std::string(end_of_line);
}

std::string step_line(const std::string& name, const DoneStep& done) {
  return "step\t" + escaped(name) + '\t' + hash_of(*done.made.options) + text_of(done.made.inputs) +
         "\t->" + text_of(done.outputs) + std::string(end_of_line);
}

/// Opens a journal and locks it against other writers for its lifetime.
class Locked {
 public:
  explicit Locked(const fs::path& journal) {
    // Another process may have replaced the file during the wait. Lines written to the old file
    // would be lost.
    do {
      close();
      descriptor_ =
          ::open(journal.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    } while (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX) == 0 && is_replaced(journal));
  }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
  ~Locked() { close(); }

  /// Returns a negative number if the journal cannot be written.
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  [[nodiscard]] bool is_replaced(const fs::path& journal) const {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor_, &opened) == 0 &&
           (::lstat(journal.c_str(), &named) != 0 || named.st_ino != opened.st_ino);
  }
  void close() const {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  int descriptor_ = -1;
};

/// Adds lines in one write. The leading line break ends an unfinished line that a killed program
/// left.
void append(const fs::path& journal, const std::string& lines) {
  const Locked locked(journal);
  if (locked.descriptor() < 0) return;
  const std::string text = '\n' + lines;
  (void)!::write(locked.descriptor(), text.data(), text.size());
}

}  // namespace

std::optional<Stat> stat_of(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  const auto nanoseconds = [](const timespec& time) {
    return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
  };
  return Stat{.size = static_cast<std::uint64_t>(status.st_size),
              .inode = status.st_ino,
              .written = nanoseconds(status.st_mtim),
              .changed = nanoseconds(status.st_ctim)};
}

std::string short_digest(const std::string& digest) { return digest.substr(0, 32); }

Made made_by(const Provenance& provenance) {
  Made made{.options = std::make_shared<const std::string>(provenance.options), .inputs = {}};
  for (const Provenance::Input& input : provenance.inputs) {
    const bool has_several = input.role == "recording";
    made.inputs.push_back(
        {has_several ? input.role + ' ' + input.file : input.role, short_digest(input.digest)});
  }
  return made;
}

Journal::Journal(fs::path run) : run_(std::move(run)), prefix_(run_.string() + '/') {
  const fs::path file = run_ / ".journal";
  std::error_code none;
  const fs::file_status status = fs::symlink_status(file, none);
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) {
    throw Error(Exit::bad_input,
                file.string() + ": is not a file; remove it, and make rewrites it");
  }
  try {
    const Bytes bytes = read_file(file);
    read_bytes_ = bytes.size();
    take({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  } catch (const Error&) {
    return;
  }
}

std::string Journal::name_of(const std::string& file) const {
  return file.starts_with(prefix_) ? file.substr(prefix_.size()) : file;
}

void Journal::take(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.ends_with("\t.")) continue;
    ++read_lines_;
    line.remove_suffix(2);
    const auto fields = fields_of(line);
    const std::span<const std::string_view> all(fields);
    if (fields.size() == 3 && fields[0] == "options") {
      options_[std::string(fields[1])] = std::make_shared<const std::string>(unescaped(fields[2]));
    } else if (fields.size() == 4 && fields[0] == "file") {
      const auto stat = parse_stat(fields[2]);
      if (!stat) continue;
      files_[unescaped(fields[1])] = {.stat = *stat, .digest = std::string(fields[3])};
    } else if (fields.size() >= 6 && fields[0] == "artefact") {
      const auto stat = parse_stat(fields[2]);
      const auto options = options_.find(std::string(fields[5]));
      if (!stat || options == options_.end()) continue;
      files_[unescaped(fields[1])] = {.stat = *stat,
                                      .digest = std::string(fields[3]),
                                      .made = Made{options->second, parse_pairs(all.subspan(6))},
                                      .belongs_in = unescaped(fields[4])};
    } else if (fields.size() >= 4 && fields[0] == "step") {
      const auto options = options_.find(std::string(fields[2]));
      const auto arrow = std::ranges::find(all, "->");
      if (options == options_.end() || arrow == all.end()) continue;
      const auto at = static_cast<std::size_t>(arrow - all.begin());
      steps_[unescaped(fields[1])] = {
          .made = {options->second, parse_pairs(all.subspan(3, at - 3))},
          .outputs = parse_pairs(all.subspan(at + 1))};
    }
  }
}

const SeenFile* Journal::file(const std::string& file) const {
  const auto found = files_.find(name_of(file));
  return found == files_.end() ? nullptr : &found->second;
}

const DoneStep* Journal::step(const std::string& name) const {
  const auto found = steps_.find(name_of(name));
  return found == steps_.end() ? nullptr : &found->second;
}

void Journal::note(const std::string& file, SeenFile seen) {
  const std::string name = name_of(file);
  if (seen.made) added_ += options_line(hash_of(*seen.made->options), *seen.made->options);
  added_ += file_line(name, seen);
  files_[name] = std::move(seen);
}

void Journal::note(const std::string& step, DoneStep done) {
  const std::string name = name_of(step);
  added_ += options_line(hash_of(*done.made.options), *done.made.options) + step_line(name, done);
  steps_[name] = std::move(done);
}

std::string Journal::whole_text() const {
  std::map<const std::string*, std::string> hashes;
  std::map<std::string, std::string> options;
  std::string lines;
  const auto keep = [&](const Made& made) {
    std::string& hash = hashes[made.options.get()];
    if (hash.empty()) options[hash = hash_of(*made.options)] = *made.options;
  };
  for (const auto& [name, seen] : files_) {
    if (seen.made) keep(*seen.made);
    lines += file_line(name, seen);
  }
  for (const auto& [name, done] : steps_) {
    keep(done.made);
    lines += step_line(name, done);
  }
  std::string text;
  for (const auto& [hash, each] : options) text += options_line(hash, each);
  return text + lines;
}

void Journal::save() {
  if (!fs::is_directory(run_)) return;
  if (!added_.empty()) append(run_ / ".journal", added_);
  added_.clear();
  constexpr std::size_t small = 1 << 20;
  const std::size_t counting = files_.size() + steps_.size() + options_.size();
  if (read_bytes_ > small && 2 * read_lines_ > 3 * counting) compact();
}

/// Drops lines that later lines have replaced.
void Journal::compact() const {
  const fs::path file = run_ / ".journal";
  const Locked locked(file);
  if (locked.descriptor() < 0) return;
  const std::string text = Journal(run_).whole_text();  // includes what others have added since
  if (text.empty()) return;                             // the file could not be read
  try {
    write_file_atomically(file, std::as_bytes(std::span(text)));
  } catch (const Error&) {
    return;  // the old file remains
  }
}

void add_to_journal(const fs::path& run, const fs::path& file, const Written& written,
                    const Provenance& provenance) {
  const auto stat = stat_of(file);
  if (!stat || !fs::is_directory(run)) return;
  const std::string prefix = run.string() + '/';
  const std::string path = file.string();
  const Made made = made_by(provenance);
  append(run / ".journal",
         options_line(hash_of(*made.options), *made.options) +
             file_line(path.starts_with(prefix) ? path.substr(prefix.size()) : path,
                       {.stat = *stat,
                        .digest = short_digest(written.digest),
                        .made = made,
                        .belongs_in = written.belongs_in}));
}

}  // namespace piae::artefact
