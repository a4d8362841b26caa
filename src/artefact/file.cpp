#include "artefact/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "artefact/partial_file.hpp"
#include "base/error.hpp"
#include "base/regular_file.hpp"

namespace piae::artefact {

namespace fs = std::filesystem;

namespace {

std::string reason() { return std::generic_category().message(errno); }

/// Owns a POSIX file descriptor and closes it.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }

  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

/// Syncs a folder to the disk. Otherwise a power cut may undo a rename in it.
void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.get() >= 0) ::fsync(descriptor.get());
}

}  // namespace

Bytes read_file(const fs::path& path, std::uint64_t most) {
  const RegularFile file(path);
  if (file.size() > most) {
    throw Error(Exit::bad_input, path.string() + ": is larger than " +
                                     std::to_string(most / 1'000'000) +
                                     " MB, the limit for such files");
  }
  Bytes bytes(file.size());
  bytes.shorten(file.read(bytes));
  return bytes;
}

void require_replaceable(const fs::path& path) {
  if (!path.has_filename()) {
    throw Error(Exit::usage,
                "'" + path.string() + "' is not the name of a file to write; give one");
  }
  std::error_code ignored;
  const fs::file_status there = fs::symlink_status(path, ignored);
  if (!fs::exists(there) || fs::is_regular_file(there)) return;
  const std::string what = fs::is_symlink(there) ? "is a link" : "is not a file";
  throw Error(Exit::failed,
              path.string() + ": " + what + ", so it is not replaced; choose another output");
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  require_replaceable(path);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code no_folder;
  fs::create_directories(folder, no_folder);
  if (no_folder) {
    throw Error(Exit::failed, folder.string() + ": cannot make this folder: " +
                                  no_folder.message() + "; choose another output");
  }
  // Makes write() fail beyond `ulimit -f`, instead of the system killing the program.
  std::signal(SIGXFSZ, SIG_IGN);
  const auto fail = [&](const std::string& what) {
    throw Error(Exit::failed,
                path.string() + ": " + what + ": " + reason() +
                    "; nothing was written: choose another output or free some space");
  };
  PartialFile partial(path);
  if (!partial.is_open() || !partial.write(bytes)) fail("cannot be written");
  if (!partial.put_in_place()) fail("cannot be renamed to its final name");
  sync_folder(folder);
}

void remove_file(const fs::path& path) {
  fs::remove(path);
  remove_left_overs(path);
}

}  // namespace piae::artefact
