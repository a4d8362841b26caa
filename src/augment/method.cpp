#include "augment/method.hpp"

#include <stdexcept>

#include "base/error.hpp"

namespace piae::augment {

bool Method::needs_libtorch(const Compute& compute) const {
  (void)piae::needs_libtorch(compute);  // throws if back end and device do not match
  return false;
}

void Method::use_healthy(const signal::WindowSet& /*healthy*/) {
  throw std::logic_error("this method does not use healthy windows");
}

std::vector<signal::DynamicParameters> Method::infer(const artefact::Reader& model,
                                                     const signal::WindowSet& /*windows*/,
                                                     const Compute& /*compute*/) {
  throw Error(Exit::usage, model.path().string() + ": method " + model.text("/", "method") +
                               " infers neither stiffness nor damping; give a model of piae-dt or "
                               "of one of its variants");
}

}  // namespace piae::augment
