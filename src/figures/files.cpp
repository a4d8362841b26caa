#include "figures/files.hpp"

#include <algorithm>

#include "artefact/file.hpp"
#include "text/file.hpp"

namespace piae::figures {

namespace {

namespace fs = std::filesystem;

bool is_picture_of(const Figure& figure, const std::string& name) {
  return name == figure.name || name.starts_with(std::string(figure.name) + "@");
}

/// Makes a picture for each classifier. Only the paper's classifier, if the run has it, must
/// succeed.
std::vector<text::File> files_by_classifier(Source& source, const Figure& figure) {
  std::vector<text::File> files;
  for (const report::ClassifierRows& block : source.accuracies()) {
    const bool is_papers = block.classifier == scoring::paper_classifier;
    const std::string part = is_papers ? "" : "@" + block.classifier;
    try {
      files.push_back(
          {source.layout().figure_csv(figure.name + part), figure.accuracies(source, block).csv()});
    } catch (const LeftOut&) {
      if (is_papers) throw;
    }
  }
  if (files.empty()) {
    throw LeftOut(std::string("the run has no diagnosis by ") + scoring::paper_classifier);
  }
  return files;
}

std::vector<text::File> csv_files_of(Source& source, const Figure& figure) {
  const run::Layout& layout = source.layout();
  const std::string name = figure.name;
  if (figure.accuracies != nullptr) return files_by_classifier(source, figure);
  if (figure.numbers != nullptr) return {{layout.figure_csv(name), figure.numbers(source).csv()}};
  std::vector<text::File> files;
  for (const Picture& picture : figure.pictures(source)) {
    files.push_back({layout.figure_csv(name + "@" + picture.part), picture.numbers.csv()});
  }
  return files;
}

/// Removes all stored pictures of a figure except these files.
void remove_others(const run::Layout& layout, const Figure& figure,
                   const std::vector<text::File>& files) {
  for (const std::string& name : stored_pictures(layout, figure)) {
    const fs::path csv = layout.figure_csv(name);
    if (std::ranges::find(files, csv, &text::File::path) != files.end()) continue;
    for (const char* const ending : {".csv", ".svg", ".pdf"}) {
      artefact::remove_file(fs::path(csv).replace_extension(ending));
    }
  }
}

}  // namespace

std::vector<std::string> stored_pictures(const run::Layout& layout, const Figure& figure) {
  std::vector<std::string> names;
  std::error_code no_folder;
  const fs::path folder = layout.figure_csv(figure.name).parent_path();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, no_folder)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() == ".csv" && is_picture_of(figure, name)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

std::vector<fs::path> save_pictures(Source& source, const Figure& figure) {
  std::vector<text::File> files;
  try {
    files = csv_files_of(source, figure);
  } catch (const Error&) {
    remove_others(source.layout(), figure, {});
    throw;
  }
  std::vector<fs::path> saved;
  for (const text::File& file : files) {
    text::save_if_changed(file);
    saved.push_back(file.path);
  }
  remove_others(source.layout(), figure, files);
  return saved;
}

}  // namespace piae::figures
