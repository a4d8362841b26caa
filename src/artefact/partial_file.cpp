#include "artefact/partial_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include "base/write_all.hpp"

namespace piae::artefact {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view hexadecimal = "0123456789abcdef";
constexpr std::size_t digits = 16;

std::string beginning_of(const fs::path& target) {
  return target.filename().string() + ".partial-";
}

std::string unknowable_name(const fs::path& target) {
  std::string name = beginning_of(target);
  std::random_device random;
  for (std::size_t i = 0; i < digits; ++i) name += hexadecimal[random() % hexadecimal.size()];
  return name;
}

bool is_partial_of(const std::string& name, const fs::path& target) {
  const std::string beginning = beginning_of(target);
  return name.size() == beginning.size() + digits && name.starts_with(beginning) &&
         name.find_first_not_of(hexadecimal, beginning.size()) == std::string::npos;
}

bool is_linked_file(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink > 0;
}

/// Removes a partial file unless its writer has it locked. The lock is held until the file is
/// removed, so that a writer cannot start meanwhile. On a file system without locks the file stays.
void remove_unless_written(const fs::path& partial) {
  const int descriptor = ::open(partial.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (is_linked_file(descriptor) && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
    ::unlink(partial.c_str());
  }
  ::close(descriptor);
}

}  // namespace

PartialFile::PartialFile(const fs::path& target) : target_(target) {
  remove_left_overs(target);
  // Before it is locked, another process may remove it as a left-over. Then try another name.
  do {
    make();
  } while (is_open() && !is_linked_file(descriptor_));
}

void PartialFile::make() {
  if (descriptor_ >= 0) ::close(descriptor_);
  path_ = target_.parent_path() / unknowable_name(target_);
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) (void)::flock(descriptor_, LOCK_EX);
}

PartialFile::~PartialFile() {
  if (descriptor_ < 0) return;
  if (!path_.empty()) ::unlink(path_.c_str());
  ::close(descriptor_);
}

bool PartialFile::write(std::span<const std::byte> bytes) const {
  return write_all(descriptor_, bytes) && ::fsync(descriptor_) == 0;
}

bool PartialFile::put_in_place() {
  if (::rename(path_.c_str(), target_.c_str()) != 0) return false;
  path_.clear();
  return true;
}

void remove_left_overs(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code unreadable;  // a folder may permit only creating files
  for (fs::directory_iterator entry(folder, unreadable), end; !unreadable && entry != end;
       entry.increment(unreadable)) {
    if (is_partial_of(entry->path().filename().string(), target)) {
      remove_unless_written(entry->path());
    }
  }
}

}  // namespace piae::artefact
