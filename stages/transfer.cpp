// Reports the mean effect of each method over data sets that test faults in other conditions.

#include "report/transfer.hpp"

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "cli/stage.hpp"
#include "report/transfer_tables.hpp"
#include "text/file.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "transfer",
      "Compares methods over a group of data sets that know faults in one condition and test them "
      "in another. Each method has the input of WDCNN that other seeds chose for it. Writes mean "
      "accuracies, differences from one method paired by seed (Wilcoxon's test with Holm's "
      "correction), and all inputs: transfer@GROUP.csv, transfer-comparisons@GROUP.csv and "
      "transfer@GROUP.md in the folder of the run. pipeline/protocol.toml describes the groups.",
      "transfer --config pipeline/protocol.toml --run results/try --group speeds "
      "--methods none strike-twin --ratio 1to1 --classifiers wdcnn wdcnn-spectra --seeds 0 1");
  report::TransferOptions options;
  fs::path run_folder;
  options.group = stage.choose_variant(argc, argv, "--group");
  stage.options().add("--group", options.group, "Group of datasets, such as speeds").required();
  bind(stage.options(), options);
  stage.input_file("--run", run_folder, "Folder of the run, such as results/try");

  return stage.run(argc, argv, [&] {
    const report::TransferGroup group = report::read_transfer(run_folder, options);
    const auto file = [&](const std::string& table, const std::string& extension) {
      return run_folder / (table + "@" + options.group + extension);
    };
    const fs::path document = file("transfer", ".md");
    text::save_all({{file("transfer", ".csv"), report::transfer_csv(group)},
                    {file("transfer-comparisons", ".csv"), report::transfer_comparisons_csv(group)},
                    {document, report::markdown(report::transfer_document(group))}});
    std::cout << fmt::format("averaged {} pairs of method and input over {} data sets: {}\n",
                             group.rows.size(), group.datasets.size(), document.string());
  });
}
