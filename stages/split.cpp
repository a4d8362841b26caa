#include "signal/split.hpp"

#include <iostream>

#include "cli/stage.hpp"
#include "signal/recordings.hpp"

namespace fs = std::filesystem;
using namespace piae;

namespace {

void print_summary(const signal::Split& split, const signal::SplitOptions& options) {
  const signal::DatasetInfo& info = split.sets.front().info;
  std::cout << "split: " << info.name << " seed " << options.seed << ' ' << options.protocol << ':';
  for (std::size_t role = 0; role < split.sets.size(); ++role) {
    std::cout << ' ' << signal::Split::roles[role] << ' ' << split.sets[role].size();
  }
  std::cout << " windows of " << options.window << "; stride";
  for (std::size_t label = 0; label < split.strides.size(); ++label) {
    std::cout << ' ' << info.classes[label].name << ' ' << split.strides[label];
  }
  std::cout << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("split",
                   "Cuts records into windows and shares them out: A test, B healthy, C the known "
                   "fault windows, D the hidden ones that generated windows are compared with.",
                   "split --records records.h5 --seed 0 --protocol random --output-dir "
                   "results/try/cwru/seed0");
  signal::SplitOptions options;
  fs::path records;
  fs::path folder;
  stage.input_file("--records", records, "records.h5 made by ingest or simulate");
  stage.output_file("--output-dir", folder, "Folder for A.h5, B.h5, C.h5 and D.h5");
  bind(stage.options(), options);

  return stage.run(argc, argv, [&] {
    const artefact::Reader reader = stage.open("records", records, "records");
    const signal::Split split = signal::split(signal::read_recordings(reader), options);
    for (std::size_t role = 0; role < split.sets.size(); ++role) {
      artefact::Writer writer("windows");
      write(writer, split, role, options, reader.digest());
      stage.save(writer, folder / (std::string(signal::Split::roles[role]) + ".h5"));
    }
    print_summary(split, options);
  });
}
