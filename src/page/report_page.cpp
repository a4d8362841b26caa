#include "page/report_page.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "page/cells_view.hpp"
#include "page/figures_view.hpp"
#include "page/html.hpp"
#include "page/problems.hpp"
#include "page/results_view.hpp"
#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "report/recommendation_tables.hpp"
#include "report/summary.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

namespace {

using Datasets = std::vector<DatasetContents>;
using Figures = std::vector<std::vector<FigureContents>>;

/// Returns the values of all data sets, each once, in order of appearance.
template <class T, class ValuesOf>
std::vector<T> all_of(const Datasets& datasets, const ValuesOf& values_of) {
  std::vector<T> all;
  for (const DatasetContents& dataset : datasets) {
    for (const T& value : values_of(dataset)) {
      if (std::ranges::count(all, value) == 0) all.push_back(value);
    }
  }
  return all;
}

std::vector<std::string> methods_in_grid(const DatasetContents& dataset) {
  std::vector<std::string> methods;
  for (const run::Combination& cell : dataset.grid.combinations) methods.push_back(cell.method);
  return methods;
}

std::vector<std::string> classifiers_in_grid(const DatasetContents& dataset) {
  std::vector<std::string> names;
  for (const run::Combination& cell : dataset.grid.combinations) names.push_back(cell.classifier);
  return names;
}

std::vector<std::string> protocols_in(const DatasetContents& dataset) {
  if (dataset.results.diagnoses.empty()) return {};
  return {to_string(dataset.results.diagnoses.front().protocol)};
}

/// Returns the labels in the order of Table 5.
std::vector<std::string> ratio_labels(const Datasets& datasets) {
  std::vector<std::string> labels;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const bool is_there = std::ranges::any_of(datasets, [&](const DatasetContents& dataset) {
      return std::ranges::count(dataset.grid.combinations, ratio.name, &run::Combination::ratio) >
             0;
    });
    if (is_there) labels.push_back(report::short_ratio_label(ratio.name));
  }
  return labels;
}

constexpr const char* which_to_take = "Which method to take";

Html section(const std::string& id, const std::string& title, const Html& content) {
  return element("section", {{"id", id}}, element("h2", title) + content);
}

std::string id_of_dataset(const std::string& part, const DatasetContents& dataset) {
  return anchor(part + "-" + dataset.name);
}

Html navigation(const Datasets& datasets) {
  Html items;
  const auto add = [&](const std::string& id, const std::string& title) {
    items += element("li", element("a", {{"href", "#" + id}}, title));
  };
  for (const DatasetContents& dataset : datasets) {
    add(id_of_dataset("results", dataset), "Results on " + dataset.name);
  }
  for (const DatasetContents& dataset : datasets) {
    add(id_of_dataset("figures", dataset), "Figures of " + dataset.name);
  }
  add("recall", "Recall by class");
  add("decisions", "Decisions and confidence");
  add("recommendation", which_to_take);
  add("cells", "Cells");
  add("settings", "Settings");
  add("provenance", "Provenance");
  items += element("li", file_link("run.html", "How it ran"));
  return element("nav", {{"aria-label", "Parts of this page"}}, element("ul", items));
}

Html header_of(const Datasets& datasets) {
  Html facts;
  for (const auto& [word, what] : facts_of(datasets)) {
    facts += element("dt", word) + element("dd", what);
  }
  return element("header", element("h1", "PIAE-DT on " + names_of(datasets)) +
                               problems_html(datasets) + element("dl", facts) +
                               navigation(datasets));
}

Html results_and_figures(const Datasets& datasets, const Figures& figures) {
  Html all;
  for (const DatasetContents& dataset : datasets) {
    all += section(id_of_dataset("results", dataset), "Results on " + dataset.name,
                   accuracy_view(dataset));
  }
  for (std::size_t i = 0; i < datasets.size(); ++i) {
    all += section(id_of_dataset("figures", datasets[i]), "Figures of " + datasets[i].name,
                   figures_view(datasets[i].name, figures[i]));
  }
  return all;
}

std::vector<text::File> read_settings(const std::filesystem::path& run) {
  std::vector<text::File> files;
  const std::filesystem::path folder = run / ".settings";
  std::error_code none_there;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none_there)) {
    if (entry.path().extension() != ".toml") continue;
    files.push_back(
        {.path = entry.path().lexically_relative(folder), .text = text::read_file(entry.path())});
  }
  std::ranges::sort(files, {}, &text::File::path);
  return files;
}

Html settings_view(const std::vector<text::File>& files) {
  if (files.empty()) {
    return element("p", "This run has no settings files: its steps were run by hand.");
  }
  Html all = element("p",
                     "The settings files of the run (.settings/), which its steps used. Comments "
                     "in pipeline/protocol.toml and pipeline/datasets/ give the "
                     "source of each value.");
  for (const text::File& file : files) {
    all += element("details",
                   element("summary", file.path.generic_string()) + element("pre", file.text));
  }
  return all;
}

Html rest_of(const ReportContents& contents) {
  Html recall;
  Html decisions;
  Html recommendation;
  for (const DatasetContents& dataset : contents.datasets) {
    recall += recall_view(dataset);
    decisions += decisions_view(dataset);
    recommendation += recommendation_view(dataset);
  }
  return section("recall", "Recall by class", recall) +
         section("decisions", "Decisions and confidence", decisions) +
         section("recommendation", which_to_take, recommendation) +
         section("cells", "Cells", cells_view(contents.datasets)) +
         section("settings", "Settings", settings_view(contents.settings)) +
         section("provenance", "Provenance", provenance_view(contents.datasets)) +
         element("footer",
                 element("p", {{"class", "quiet"}},
                         Html("All tables: tables.md in the folder of each data set. Times and "
                              "memory of the steps, which differ from run to run: ") +
                             file_link("run.html") + "."));
}

/// Returns the page with `figures` instead of the figures of `contents`.
std::string whole_page(const ReportContents& contents, const Figures& figures, const Style& style) {
  return document("PIAE-DT on " + names_of(contents.datasets), style,
                  header_of(contents.datasets) +
                      element("main", {{"id", "content"}},
                              results_and_figures(contents.datasets, figures) + rest_of(contents)));
}

/// Returns all figures with empty files, to measure the size of the rest of the page.
Figures without_attachments(Figures figures) {
  for (std::vector<FigureContents>& of_dataset : figures) {
    for (FigureContents& figure : of_dataset) {
      for (Picture& picture : figure.pictures) {
        for (Attachment* attachment : {&picture.svg, &picture.csv}) {
          attachment->held = !attachment->file.empty();
          attachment->address.clear();
        }
      }
    }
  }
  return figures;
}

/// Returns a section for each classifier, the first with the verdict, and one with the recommended
/// method.
std::vector<report::Section> sections_of(const DatasetContents& contents) {
  std::vector<report::Section> sections = contents.tables.overview;
  if (!sections.empty()) sections.front().findings = contents.verdict;
  const std::vector<report::Section>& last = contents.tables.recommendation;
  if (!last.empty()) sections.push_back(last.front());
  return sections;
}

/// Returns a line for each of the first groups of missing cells; the page has all groups.
std::vector<std::string> lines_of_missing(const std::vector<DatasetContents>& datasets) {
  constexpr std::size_t most_groups = 12;
  const std::vector<MissingGroup> groups = groups_of(datasets);
  std::vector<std::string> lines;
  for (const MissingGroup& group : groups) {
    if (lines.size() == most_groups) {
      lines.push_back(
          fmt::format("And {} more; report.html lists all.", groups.size() - most_groups));
      break;
    }
    const std::string why = group.reasons.empty() ? "" : ": " + group.reasons.front();
    lines.push_back(fmt::format("{} on {}: {} ({}){}", word_of(group.state), group.dataset,
                                counted_cells(group.diagnoses, group.scores), cells_label(group),
                                why));
  }
  return lines;
}

}  // namespace

std::string names_of(const Datasets& datasets) {
  std::vector<std::string> names;
  for (const DatasetContents& dataset : datasets) names.push_back(dataset.name);
  return report::listed(names);
}

std::vector<std::pair<std::string, std::string>> facts_of(const Datasets& datasets) {
  auto seeds =
      all_of<std::int64_t>(datasets, [](const DatasetContents& each) { return each.grid.seeds; });
  std::ranges::sort(seeds);
  const auto methods = all_of<std::string>(datasets, methods_in_grid);
  const auto protocols = all_of<std::string>(datasets, protocols_in);
  std::size_t diagnoses = 0;
  std::size_t scores = 0;
  for (const DatasetContents& dataset : datasets) {
    diagnoses += dataset.results.diagnoses.size();
    scores += dataset.results.qualities.size();
  }
  std::vector<std::pair<std::string, std::string>> facts{
      {"What",
       "A classifier (WDCNN unless another is named) learns from healthy windows, known windows of "
       "each fault if there are any, and windows that a method generates. Accuracies are those on "
       "test windows."},
      {report::counted(methods.size(), "method"), report::listed(methods)},
      {"Ratios", report::listed(ratio_labels(datasets))},
      {"Seeds", report::seed_list(seeds)},
      {"Split", protocols.empty() ? "not known yet" : report::listed(protocols)},
      {"Cells", counted_cells(diagnoses, scores)}};
  const auto classifiers = all_of<std::string>(datasets, classifiers_in_grid);
  std::vector<std::string> marked;
  std::ranges::transform(classifiers, std::back_inserter(marked), diagnosis::marked_name);
  if (classifiers.size() > 1) {
    facts.insert(facts.begin() + 2,
                 {report::counted(classifiers.size(), "classifier"), report::listed(marked)});
  }
  const std::string adapting = report::about_adapting(classifiers);
  if (!adapting.empty()) facts.insert(facts.begin() + 2, {"Sees D", adapting});
  return facts;
}

ReportContents read_report(const std::filesystem::path& run, const RequestedCells& requested,
                           const report::Published& published) {
  ReportContents contents;
  for (const std::string& name : datasets_of(run, requested)) {
    const run::Grid grid = grid_of(run::Started(run::Layout(run, name)), name, requested);
    contents.datasets.push_back(read_dataset(run, grid, requested.left_out_of(name), published));
    contents.figures.push_back(read_figures(run, name));
  }
  contents.settings = read_settings(run);
  return contents;
}

std::string report_page(const ReportContents& contents, const Style& style) {
  const std::size_t without =
      whole_page(contents, without_attachments(contents.figures), style).size();
  Figures figures = contents.figures;
  std::vector<FigureContents*> all;
  for (std::vector<FigureContents>& of_dataset : figures) {
    for (FigureContents& figure : of_dataset) all.push_back(&figure);
  }
  // Reserves space for addresses: except for its address, a link is shorter than the markup around
  // an included file.
  constexpr std::size_t for_addresses = 100'000;
  const std::size_t taken = without + for_addresses;
  choose_attachments(all, taken < most_bytes_of_report ? most_bytes_of_report - taken : 0);
  return whole_page(contents, figures, style);
}

std::string report_text(const ReportContents& contents) {
  report::Document document{.key = "report", .title = "PIAE-DT on " + names_of(contents.datasets)};
  document.paragraphs.push_back(completeness(contents.datasets));
  for (const DatasetContents& dataset : contents.datasets) {
    const std::string left_out = report::left_out_line(dataset.results);
    if (!left_out.empty()) document.paragraphs.push_back(dataset.name + ": " + left_out + ".");
  }
  for (std::string& line : lines_of_missing(contents.datasets)) {
    document.paragraphs.push_back("- " + std::move(line));
  }
  std::string what;
  for (const auto& [heading, fact] : facts_of(contents.datasets)) {
    if (heading != "What") what += fmt::format("{}{}: {}.", what.empty() ? "" : " ", heading, fact);
  }
  document.paragraphs.push_back(what);
  for (const DatasetContents& dataset : contents.datasets) {
    std::ranges::move(sections_of(dataset), std::back_inserter(document.sections));
  }
  std::string text = report::markdown(document);
  return text +
         "\nFigures, recall by class, every cell with its artefact, settings and provenance: "
         "`report.html`.\nTimes and memory of the steps: `run.html`. All tables: "
         "`tables.md` of each data set.\n";
}

}  // namespace piae::page
