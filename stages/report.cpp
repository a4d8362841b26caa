// Makes the pages that show a run.

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "page/report_page.hpp"
#include "page/run_page.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void require_folder(const fs::path& run) {
  if (!fs::is_directory(run)) {
    throw Error(Exit::input_missing, run.string() +
                                         ": is not a folder; give the folder of a "
                                         "run, such as results/try");
  }
}

std::size_t missing_cells(const page::ReportContents& contents) {
  std::size_t count = 0;
  for (const page::DatasetContents& dataset : contents.datasets)
    count += dataset.missing_cells.size();
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "report",
      "Makes RUN/report.html, one file with verdict, tables, figures, settings and provenance of "
      "a run; RUN/report.md, the same on one page for terminals; and RUN/run.html, the time and "
      "resources of each step. The run may be unfinished: missing cells are listed at the top. "
      "The same cells give the same report.html and report.md in any folder.",
      "report --run results/try --datasets cwru --published results/published");
  page::RequestedCells requested;
  fs::path run_folder;
  fs::path published_folder;
  fs::path style_folder = "pipeline/report";
  bind(stage.options(), requested);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");
  stage.input_file("--published", published_folder, "Folder of the paper's tables as CSV");
  stage.input_file("--style", style_folder, "Folder with style.css and script.js").required(false);

  return stage.run(argc, argv, [&] {
    require_folder(run_folder);
    const page::Style style = page::read_style(style_folder);
    const report::Published published(published_folder);
    const page::ReportContents contents = page::read_report(run_folder, requested, published);
    const std::string html = report_page(contents, style);
    text::save_if_changed({run_folder / "report.html", html});
    text::save_if_changed({run_folder / "report.md", report_text(contents)});
    text::save_if_changed(
        {run_folder / "run.html", page::run_page(run::read_step_logs(run_folder), style)});
    std::cout << fmt::format("reported {} data sets, {} cells missing, {:.2f} MB: {}\n",
                             contents.datasets.size(), missing_cells(contents),
                             static_cast<double>(html.size()) / 1e6,
                             (run_folder / "report.html").string());
  });
}
