#include "artefact/provenance.hpp"

#include <H5public.h>
#include <omp.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fstream>

#include "artefact/build_info.hpp"

namespace piae::artefact {

namespace {

std::string processor_model() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

}  // namespace

std::string build_version() {
  const std::string commit = build_info::commit;
  return build_info::version + (commit.empty() ? "" : " (" + commit + ")");
}

std::string build_libraries() {
  return build_info::compiler + "; LibTorch " + build_info::torch_version + "; HDF5 " +
         H5_VERS_INFO + "; Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." +
         std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION) +
         "; Boost " + BOOST_LIB_VERSION;
}

std::string cpu_settings() {
  return processor_model() + "; OpenMP threads at most " + std::to_string(omp_get_max_threads());
}

}  // namespace piae::artefact
