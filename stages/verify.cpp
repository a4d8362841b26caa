// Checks artefacts: prints a line for each problem. Prints nothing and exits with 0 if all are
// good. src/verification/verify.cpp defines the checks of each kind; add new kinds there.

#include "verification/verify.hpp"

#include <iostream>

#include "base/one_line.hpp"
#include "cli/stage.hpp"

using namespace piae;

int main(int argc, char** argv) {
  cli::Stage stage(
      "verify",
      "Checks artefacts of any kind: complete, undamaged, finite, of a known schema, and "
      "no window with two roles in a split. Prints nothing and exits with 0 if all are good; "
      "otherwise prints one line for each problem and exits with the bit-or of the reasons: 1 "
      "missing, truncated or not HDF5; 4 damaged; 8 wrong kind or schema; 16 impossible content; "
      "32 a window with two roles. A usage error gives 2.",
      "verify results/demo/simulated-small/seed0/*.h5");
  std::vector<std::filesystem::path> files;
  stage.options()
      .add("FILE", files, "artefacts; the roles of a split are checked together")
      .required();

  int status = 0;
  const int error = stage.run(argc, argv, [&] {
    const std::vector<verification::Finding> findings = verification::verify(files);
    for (const verification::Finding& finding : findings)
      std::cout << one_line(finding.line) << '\n';
    status = verification::exit_code_of(findings);
  });
  return error != 0 ? error : status;
}
