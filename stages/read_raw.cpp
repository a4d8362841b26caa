// Reads one variable of a raw recording for ingest, which runs it for each file: where the
// library that reads it crashes or takes too much, only this program ends.

#include <unistd.h>

#include <cerrno>
#include <span>
#include <system_error>

#include "base/error.hpp"
#include "base/write_all.hpp"
#include "cli/checks.hpp"
#include "cli/stage.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"

namespace fs = std::filesystem;
using namespace piae;

namespace {

void print(std::span<const std::byte> bytes) {
  if (!write_all(STDOUT_FILENO, bytes)) {
    throw Error(Exit::failed, "standard output: " + std::generic_category().message(errno));
  }
}

std::vector<double> read_without_writing(const fs::path& file, const std::string& variable,
                                         std::optional<double> sample_rate_hz) {
  const raw::WritesNoFile reading;
  return raw::read_here(file, variable, sample_rate_hz);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("read_raw",
                   "Reads one variable of a raw recording and writes its numbers "
                   "to standard output, in double precision as this machine stores it. Only what "
                   "the file's size allows is taken of memory and time. ingest runs it.",
                   "read_raw --file data/cwru/97.mat --variable X097_DE_time | od -t f8 | head");
  fs::path file;
  std::string variable;
  double sample_rate_hz = 0;
  stage.input_file("--file", file, "Raw recording");
  stage.options().add("--variable", variable, "Variable, dataset, column or channel").required();
  stage.options()
      .add("--sample-rate", sample_rate_hz, "Hz; refuse a file that says another one itself")
      .check(cli::non_negative_number());

  return stage.run(argc, argv, [&] {
    raw::keep_to(raw::limits_of(file));
    const std::vector<double> numbers = read_without_writing(
        file, variable, sample_rate_hz > 0 ? std::optional(sample_rate_hz) : std::nullopt);
    print(std::as_bytes(std::span(numbers)));
  });
}
