// Writes windows in the formats of other programs. Not named `export`, which is a shell command.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "formats/files.hpp"
#include "signal/roles.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

formats::Exported read(const artefact::Reader& reader, const std::vector<std::string>& classes,
                       std::size_t count) {
  formats::Exported exported = formats::select(signal::read_window_set(reader), classes, count);
  const signal::Role role = signal::read_role(reader);
  exported.role = to_string(role);
  if (role == signal::Role::generated) exported.method = signal::read_method(reader);
  return exported;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("export_windows",
                   "Writes windows as CSV, NumPy (.npy), MATLAB 5 (.mat) or sound (.wav, 32-bit "
                   "float), by the ending of --output. The samples are the stored float32 exactly, "
                   "with class, unit, sampling rate, and known values of each window, such as (k, "
                   "c), start angle, impacts and parents. For .npy and .wav these values are in "
                   "NAME.labels.csv. A .wav holds the windows one after another, with a marker at "
                   "each.",
                   "export_windows --windows E.h5 --output E.mat");
  fs::path file;
  fs::path output;
  std::vector<std::string> classes;
  std::size_t count = 0;
  stage.input_file("--windows", file, "A.h5 to D.h5 made by split, or E.h5 made by generate");
  stage.output_file("--output", output, "NAME.csv, NAME.mat, NAME.npy or NAME.wav");
  stage.options().add("--class", classes, "classes to export; default: all");
  stage.options()
      .add("--count", count, "number of windows of each class, from the first; 0: all")
      .check(cli::natural_number());

  return stage.run(argc, argv, [&] {
    const std::vector<fs::path> paths = formats::paths_of(output);
    const artefact::Reader reader = stage.open("windows", file, "windows");
    for (const fs::path& path : paths) stage.require_no_input(path);
    const formats::Exported exported = read(reader, classes, count);
    text::save_all(formats::files_of(exported, output));
    std::cout << fmt::format("exported {} windows of {} samples: {}\n", exported.windows.size(),
                             exported.windows.length, output.string());
  });
}
