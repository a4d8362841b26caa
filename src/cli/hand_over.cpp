#include "cli/hand_over.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"

namespace piae::cli {

void hand_over(const std::string& program, char** argv) {
  const std::filesystem::path path =
      std::filesystem::read_symlink("/proc/self/exe").replace_filename(program);
  execv(path.c_str(), argv);
  throw Error(Exit::failed, path.string() + ": cannot be started (" + std::strerror(errno) +
                                "); build it with `make build`");
}

}  // namespace piae::cli
