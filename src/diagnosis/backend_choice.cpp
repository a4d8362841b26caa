#include "diagnosis/backend_choice.hpp"

#include "base/error.hpp"

namespace piae::diagnosis {

bool needs_libtorch(const std::string& backend, const std::string& device) {
  if (backend == "libtorch") return true;
  if (backend == "auto") return device != "cpu";
  if (backend != "native") {
    throw Error(Exit::usage, "--backend: unknown back end '" + backend +
                                 "'; known are auto, native and libtorch");
  }
  if (device != "cpu") {
    throw Error(Exit::usage,
                "--backend: native computes on the cpu, not on " + device + "; use libtorch");
  }
  return false;
}

}  // namespace piae::diagnosis
