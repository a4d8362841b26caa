#pragma once

#include <string>
#include <vector>

namespace piae::artefact {

/// Record of how an artefact was made. It has no paths, times or host names, so that the same
/// inputs and settings give the same bytes in any folder.
struct Provenance {
  struct Input {
    std::string role;    ///< option that named the file, such as "records"
    std::string file;    ///< without folders
    std::string digest;  ///< content digest of an artefact, sha256 of any other file
  };

  std::string program;        ///< "split"
  std::string options;        ///< all options with their values, a TOML line each
  std::vector<Input> inputs;  ///< in the order of reading
};

/// Returns "0.1.0 (3f2c1a9)": the version and, if git knew it, the commit of the build.
std::string build_version();
/// Returns the compiler, its flags, and the versions of the libraries that affect the numbers.
std::string build_libraries();
/// Returns run-time conditions that may affect the numbers: processor model and number of threads.
std::string cpu_settings();

}  // namespace piae::artefact
