// Compares two runs that differ in one condition.

#include "report/contrast.hpp"

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "run/held.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "contrast",
      "Compares the accuracies of two runs that differ in one condition, such as the split "
      "protocol or the data set. Writes the difference in points, paired by seed: mean, interval, "
      "effect, Wilcoxon's test with Holm's correction. The requested cells must exist; the table "
      "includes all cells that both runs have. Also writes the table as .csv and .tex.",
      "contrast --with results/try/cwru --without results/try-blocked/cwru --methods none piae-dt "
      "--ratios 100to1 10to1 --seeds 0 1 --output protocols.md");
  run::GridOptions options;
  fs::path with;
  fs::path without;
  fs::path output;
  std::vector<std::string> leave_out;
  run::bind_cells(stage.options(), options);
  run::bind_leave_out(stage.options(), leave_out);
  stage.input_file("--with", with, "Folder RUN/DATASET, such as results/try/cwru");
  stage.input_file("--without", without, "Folder RUN/DATASET without the condition");
  stage.output_file("--output", output, "Table as Markdown, FILE.md");

  return stage.run(argc, argv, [&] {
    const report::Contrast contrast = report::read_contrast({with, without}, options, leave_out);
    const report::Document document = report::contrast_document(contrast);
    const auto file = [&](const char* extension) {
      return fs::path(output).replace_extension(extension);
    };
    text::save_all({{file(".md"), report::markdown(document)},
                    {file(".csv"), report::contrast_csv(contrast)},
                    {file(".tex"), report::latex(document)}});
    std::cout << fmt::format("compared {} cells of two runs: {}\n", contrast.rows.size(),
                             file(".md").string());
  });
}
