#include "artefact/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/error.hpp"

namespace piae::artefact {

namespace fs = std::filesystem;

namespace {

fs::path partial_of(const fs::path& path) { return path.string() + ".partial"; }

std::string reason() { return std::generic_category().message(errno); }

/// A POSIX file descriptor that is closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int get() const { return fd_; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

bool write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

/// Brings a folder to the disk. Only then will a rename in it outlive a power cut.
void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.get() >= 0) ::fsync(descriptor.get());
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& path) {
  const Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) {
    throw Error(Exit::input_missing, path.string() + ": " + reason());
  }
  if (!S_ISREG(status.st_mode)) {
    throw Error(Exit::input_missing, path.string() + ": is not a file");
  }
  std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = ::read(in.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error(Exit::input_missing, path.string() + ": " + reason());
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  bytes.resize(filled);
  return bytes;
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    throw Error(Exit::failed, path.string() +
                                  ": is not a file that could be replaced; choose "
                                  "another output");
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code no_folder;
  fs::create_directories(folder, no_folder);
  if (no_folder) {
    throw Error(Exit::failed, folder.string() + ": cannot make this folder: " +
                                  no_folder.message() + "; choose another output");
  }
  const fs::path partial = partial_of(path);
  const auto fail = [&](const std::string& what) {
    const std::string why = reason();
    ::unlink(partial.c_str());
    throw Error(Exit::failed, path.string() + ": " + what + ": " + why +
                                  "; nothing was written, choose another output or make room");
  };
  Descriptor out(::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (out.get() < 0) fail("cannot be written");
  if (!write_all(out.get(), bytes) || ::fsync(out.get()) != 0 || !out.close())
    fail("cannot be written");
  if (::rename(partial.c_str(), path.c_str()) != 0) fail("cannot be put in place");
  sync_folder(folder);
}

void remove_file(const fs::path& path) {
  fs::remove(path);
  fs::remove(partial_of(path));
}

}  // namespace piae::artefact
