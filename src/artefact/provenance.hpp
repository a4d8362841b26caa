#pragma once

#include <string>
#include <vector>

namespace piae::artefact {

/// How an artefact was made. It holds no path, time or host name, so that the same inputs and
/// settings give the same bytes in any folder.
struct Provenance {
  struct Input {
    std::string role;    ///< the name of the option that gave the file, such as "records"
    std::string file;    ///< the file's name without folders
    std::string digest;  ///< content digest of an artefact, sha256 of any other file
  };

  std::string program;        ///< "split"
  std::string options;        ///< all of them with their values, a TOML line each
  std::vector<Input> inputs;  ///< in the order in which they were read
};

/// "0.1.0 (3f2c1a9)": the version and, where git knew it, the commit that was built.
std::string build_version();
/// Compiler, its flags, and the versions of the libraries that the numbers depend on.
std::string build_libraries();
/// What the numbers may depend on at run time: the processor model and the number of threads.
std::string cpu_settings();

}  // namespace piae::artefact
