// Reads one variable of raw recordings. ingest starts it for each record, so that a crash or a lack
// of memory in a library ends only this program.

#include <unistd.h>

#include <cerrno>
#include <fstream>
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

/// Reads names that each end with a zero byte, as `find -print0` writes them.
std::vector<fs::path> names_in(const fs::path& list) {
  std::ifstream in(list);
  std::vector<fs::path> names;
  for (std::string name; std::getline(in, name, '\0');) names.emplace_back(name);
  if (names.empty()) throw Error(Exit::bad_input, list.string() + ": holds no file names");
  return names;
}

raw::Signal read_without_writing(const fs::path& file, const std::string& variable,
                                 std::optional<double> sample_rate_hz) {
  const raw::WritesNoFile reading;
  return raw::signal_here(file, variable, sample_rate_hz);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("read_raw",
                   "Reads one variable of raw recordings and writes its numbers "
                   "to standard output, in double precision as this machine stores it. The file's "
                   "size limits its memory and time. ingest runs it with a list of files; then a "
                   "header with their count precedes the numbers of each file.",
                   "read_raw --file data/cwru/97.mat --variable X097_DE_time | od -t f8 | head");
  fs::path file;
  fs::path list;
  std::string variable;
  double sample_rate_hz = 0;
  stage.input_file("--file", file, "Raw recording").required(false);
  stage
      .input_file("--list", list, "File with the names of recordings, each followed by a zero byte")
      .required(false);
  stage.options().add("--variable", variable, "Variable, dataset, column or channel").required();
  stage.options()
      .add("--sample-rate", sample_rate_hz,
           "expected sample rate, Hz: refuse a file that declares another one; 0: do not check")
      .check(cli::non_negative_number());

  return stage.run(argc, argv, [&] {
    if (file.empty() == list.empty()) {
      throw Error(Exit::usage, "give --file or --list (see read_raw --help)");
    }
    const auto rate_hz = sample_rate_hz > 0 ? std::optional(sample_rate_hz) : std::nullopt;
    if (list.empty()) {
      // Another process reads the file, as for ingest, so that a crash in a library ends in a line.
      const std::vector<double> samples = raw::read(file, variable, rate_hz);
      print(std::as_bytes(std::span(samples)));
      return;
    }
    const std::vector<fs::path> files = names_in(list);
    raw::keep_to(raw::limits_of(files));
    for (const fs::path& one : files) {
      const raw::Signal signal = read_without_writing(one, variable, rate_hz);
      const raw::Piece piece{.samples = signal.samples.size(),
                             .columns = signal.columns,
                             .times = signal.times,
                             .may_be_cut = signal.may_be_cut ? 1U : 0U};
      print(std::as_bytes(std::span(&piece, 1)));
      print(std::as_bytes(std::span(signal.samples)));
    }
  });
}
