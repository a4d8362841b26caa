#include "signal/split.hpp"

#include <iostream>
#include <vector>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "cli/stage.hpp"
#include "signal/recordings.hpp"

namespace fs = std::filesystem;
using namespace piae;

namespace {

void print_summary(const signal::Split& split, const signal::SplitOptions& options) {
  const signal::DatasetInfo& info = split.sets.front().info;
  if (options.known_per_class == 0) {
    std::cout << "no fault windows are known (known-per-class = 0), so C.h5 is empty\n";
  }
  // Counts come first, because make cuts the line at the width of the terminal.
  std::cout << "split:";
  for (const signal::Role role : signal::split_roles) {
    std::cout << ' ' << to_string(role) << ' ' << split.of(role).size();
  }
  std::cout << " windows of " << options.window << " of " << info.name << ", seed " << options.seed
            << ", protocol " << to_string(options.protocol) << "; stride";
  for (const Label label : info.labels()) {
    std::cout << ' ' << info.class_of(label).name << ' ' << split.strides[index_of(label)];
  }
  std::cout << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("split",
                   "Cuts recordings into windows and assigns roles to them: A test, B healthy, C "
                   "known faults, D hidden real windows, with which generated windows are "
                   "compared.",
                   "split --records records.h5 --seed 0 --protocol random --output-dir "
                   "results/try/cwru/seed0");
  signal::SplitOptions options;
  fs::path records;
  fs::path folder;
  stage.input_file("--records", records, "recordings, records.h5 of ingest or simulate");
  stage.output_file("--output-dir", folder, "Folder for A.h5, B.h5, C.h5 and D.h5");
  bind(stage.options(), options);

  return stage.run(argc, argv, [&] {
    const artefact::Reader reader = stage.open("records", records, "records");
    const signal::Split split = signal::split(signal::read_recordings(reader), options);
    std::vector<fs::path> done;
    try {
      for (const signal::Role role : signal::split_roles) {
        artefact::Writer writer("windows");
        write(writer, split, role, options, reader.digest());
        const fs::path file = folder / (to_string(role) + ".h5");
        stage.save(writer, file);
        done.push_back(file);
      }
    } catch (const Error&) {
      // An incomplete split would look whole next to roles of another split, or alone.
      for (const fs::path& file : done) artefact::remove_file(file);
      throw;
    }
    print_summary(split, options);
  });
}
