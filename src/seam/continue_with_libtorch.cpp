#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "seam/libtorch.hpp"

namespace piae::seam {

namespace fs = std::filesystem;

void continue_with_libtorch(char** argv) {
  if (back_ends() != nullptr) return;
  const fs::path other = fs::read_symlink("/proc/self/exe").string() + "-libtorch";
  if (!fs::exists(other)) {
    throw Error(Exit::failed,
                "this needs LibTorch, and there is no " + other.string() +
                    ": the programs were built without LibTorch; `make build LIBTORCH=on` has it");
  }
  execv(other.c_str(), argv);
  throw Error(Exit::failed, other.string() + ": cannot be started (" + std::strerror(errno) + ")");
}

}  // namespace piae::seam
