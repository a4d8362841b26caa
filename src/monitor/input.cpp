#include "monitor/input.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/error.hpp"

namespace piae::monitor {

namespace {

constexpr int patience_ms = 200;  ///< longest wait before the caller may look at the clock

/// Waits for input, a signal or patience_ms; returns true if there is input. A file is always
/// ready.
bool is_ready(int descriptor) {
  pollfd waiting{.fd = descriptor, .events = POLLIN, .revents = 0};
  return ::poll(&waiting, 1, patience_ms) > 0;
}

struct stat status_of(int descriptor) {
  struct stat status {};
  (void)::fstat(descriptor, &status);
  return status;
}

}  // namespace

Input::Input(const std::filesystem::path& path, bool follow)
    : path_(path),
      name_(path == "-" ? "standard input" : path.string()),
      follow_(follow),
      descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0) fail();
  const struct stat status = status_of(descriptor_);
  if (S_ISDIR(status.st_mode)) throw Error(Exit::input_missing, name_ + ": is a folder");
  if (follow && (path == "-" || !S_ISREG(status.st_mode))) {
    throw Error(Exit::usage, name_ +
                                 ": --follow is for files that grow; a pipe is read until its "
                                 "writer closes it, so remove --follow");
  }
  if (::isatty(descriptor_) != 0) {
    throw Error(Exit::usage,
                name_ + " is a terminal; pipe the samples in, or name a file with --input");
  }
}

Input::~Input() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
}

Input::Piece Input::read(std::span<std::byte> buffer) {
  if (!is_ready(descriptor_)) return {};
  const ssize_t got = ::read(descriptor_, buffer.data(), buffer.size());
  if (got > 0) return {Event::bytes, buffer.first(static_cast<std::size_t>(got))};
  if (got < 0 && errno == EINTR) return {};
  if (got < 0) fail();
  if (!follow_) return {Event::end, {}};
  if (begins_anew()) return {Event::broken, {}};
  (void)::poll(nullptr, 0, patience_ms);  // poll() reports a file at its end as ready
  return {};
}

/// Restarts from the beginning if the file was cut or replaced. Returns true if it did.
bool Input::begins_anew() {
  const struct stat own = status_of(descriptor_);
  struct stat named {};
  const bool replaced = ::stat(path_.c_str(), &named) == 0 &&
                        (named.st_ino != own.st_ino || named.st_dev != own.st_dev);
  const off_t at = ::lseek(descriptor_, 0, SEEK_CUR);
  if (replaced && own.st_size <= at) {  // only once the old file is read to its end
    const int other = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (other < 0) return false;
    ::close(descriptor_);
    descriptor_ = other;
    return true;
  }
  if (own.st_size >= at) return false;
  ::lseek(descriptor_, 0, SEEK_SET);
  return true;
}

void Input::fail() const {
  throw Error(Exit::input_missing, name_ + ": " + std::generic_category().message(errno));
}

}  // namespace piae::monitor
