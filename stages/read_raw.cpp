// Reads one variable of a raw recording for ingest, which runs it for each file: where the
// library that reads it crashes or takes too much, only this program ends.

#include <unistd.h>

#include <cerrno>
#include <span>
#include <system_error>

#include "base/error.hpp"
#include "base/write_all.hpp"
#include "cli/stage.hpp"
#include "signal/raw_file.hpp"
#include "signal/raw_limits.hpp"

namespace fs = std::filesystem;
using namespace piae;

namespace {

void print(std::span<const std::byte> bytes) {
  if (!write_all(STDOUT_FILENO, bytes)) {
    throw Error(Exit::failed, "standard output: " + std::generic_category().message(errno));
  }
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("read_raw",
                   "Reads one variable of a raw recording (.mat, .csv, .h5) and writes its numbers "
                   "to standard output, in double precision as this machine stores it. Only what "
                   "the file's size allows is taken of memory and time. ingest runs it.",
                   "read_raw --file data/cwru/97.mat --variable X097_DE_time | od -t f8 | head");
  fs::path file;
  std::string variable;
  stage.input_file("--file", file, "Raw recording");
  stage.options().add("--variable", variable, "Variable, column or dataset").required();

  return stage.run(argc, argv, [&] {
    signal::keep_to(signal::raw_limits(file));
    const std::vector<double> numbers = signal::read_here(file, variable);
    print(std::as_bytes(std::span(numbers)));
  });
}
