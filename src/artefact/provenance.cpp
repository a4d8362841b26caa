#include "artefact/provenance.hpp"

#include <H5public.h>
#include <omp.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fstream>
#include <map>

#include "artefact/build_info.hpp"

namespace piae::artefact {

namespace {

/// Returns what /proc/cpuinfo records about the first processor.
std::map<std::string, std::string> processor() {
  std::map<std::string, std::string> values;
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line) && !line.empty();) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    values[line.substr(0, line.find_last_not_of(" \t", colon - 1) + 1)] =
        begin == std::string::npos ? "" : line.substr(begin);
  }
  return values;
}

/// Returns the name of the processor with family, model and instruction set: virtual machines hide
/// the name and some instructions, and libraries choose their code by the instructions.
std::string processor_model() {
  std::map<std::string, std::string> values = processor();
  if (!values.contains("model name")) return "unknown processor";
  const std::string flags = " " + values["flags"] + " ";
  std::string widest = "no AVX";
  for (const char* set : {"avx", "avx2", "avx512f"}) {
    if (flags.find(std::string(" ") + set + " ") != std::string::npos) widest = set;
  }
  return values["model name"] + " (family " + values["cpu family"] + ", model " + values["model"] +
         ", stepping " + values["stepping"] + ", " + widest + ")";
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
