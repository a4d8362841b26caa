#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "seam/libtorch.hpp"

namespace piae::seam {

namespace fs = std::filesystem;

namespace {

fs::path program_with_libtorch() {
  return fs::read_symlink("/proc/self/exe").string() + "-libtorch";
}

}  // namespace

bool is_libtorch_there() { return back_ends() != nullptr || fs::exists(program_with_libtorch()); }

void continue_with_libtorch(char** argv) {
  if (back_ends() != nullptr) return;
  const fs::path other = program_with_libtorch();
  if (!fs::exists(other)) {
    throw Error(Exit::failed,
                "this needs LibTorch, and there is no " + other.string() +
                    ": the programs were built without LibTorch; `make build LIBTORCH=on` has it");
  }
  execv(other.c_str(), argv);
  throw Error(Exit::failed, other.string() + ": cannot be started (" + std::strerror(errno) + ")");
}

}  // namespace piae::seam
