#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "seam/libtorch.hpp"

namespace piae::seam {

namespace fs = std::filesystem;

void continue_with_libtorch(char** argv) {
  if (back_ends() != nullptr) return;
  const fs::path other = fs::read_symlink("/proc/self/exe").string() + "-libtorch";
  if (!fs::exists(other)) {
    throw Error(Exit::failed,
                "this needs LibTorch, but there is no " + other.string() +
                    ": the programs were built without LibTorch; run `make build LIBTORCH=on`");
  }
  execv(other.c_str(), argv);
  throw Error(Exit::failed, other.string() + ": cannot be started (" + std::strerror(errno) + ")");
}

diagnosis::MakeWdcnnBackend wdcnn_backend(const Compute& compute, char** argv) {
  if (!needs_libtorch(compute)) return diagnosis::make_one_core_backend;
  continue_with_libtorch(argv);
  return back_ends()->wdcnn(compute.device);
}

}  // namespace piae::seam
