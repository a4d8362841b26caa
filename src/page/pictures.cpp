#include "page/pictures.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "figures/catalogue.hpp"
#include "page/hole.hpp"
#include "page/links.hpp"
#include "text/file.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// The files of a figure with this ending: NAME.svg, or NAME@PART.svg for each part.
std::vector<fs::path> files_of_figure(const fs::path& folder, const std::string& name,
                                      const std::string& ending) {
  std::vector<fs::path> files;
  std::error_code none_there;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none_there)) {
    const std::string stem = entry.path().stem().string();
    const bool own = stem == name || stem.starts_with(name + "@");
    if (own && entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

void read_size(const std::string& svg, Picture& picture) {
  const std::string before = "viewBox=\"0 0 ";
  const std::size_t at = svg.find(before);
  if (at == std::string::npos) return;
  std::istringstream numbers(svg.substr(at + before.size(), 20));
  numbers >> picture.width >> picture.height;
}

Picture read_picture(const fs::path& run, const fs::path& svg) {
  const std::string stem = svg.stem().string();
  const std::size_t at = stem.find('@');
  Picture picture{.part = at == std::string::npos ? "" : stem.substr(at + 1)};
  const std::string text = text::read_file(svg);
  picture.svg = {.file = svg.lexically_relative(run),
                 .address = data_address("image/svg+xml", text)};
  read_size(text, picture);
  const fs::path csv = fs::path(svg).replace_extension(".csv");
  if (fs::exists(csv)) {
    picture.csv = {.file = csv.lexically_relative(run),
                   .address = data_address("text/csv", text::read_file(csv))};
  }
  const fs::path pdf = fs::path(svg).replace_extension(".pdf");
  if (fs::exists(pdf)) picture.pdf = pdf.lexically_relative(run);
  return picture;
}

/// Why a figure is not drawn.
struct Reason {
  std::string text;
  bool is_left_out = false;
};

/// What the stage `figures` has said in its log of figures that are not drawn, by name.
std::map<std::string, Reason> reasons_in_log(const fs::path& run, const fs::path& log) {
  std::map<std::string, Reason> reasons;
  if (!fs::exists(log)) return reasons;
  std::istringstream lines(text::read_file(log));
  for (std::string line; std::getline(lines, line);) {
    const auto take = [&](const std::string& before, const std::string& after, bool is_left_out) {
      const std::size_t said = line.find(after);
      if (!line.starts_with(before) || said == std::string::npos) return;
      const std::string name = line.substr(before.size(), said - before.size());
      reasons[name] = {below_run(line.substr(said + after.size()), run), is_left_out};
    };
    take("figures: ", " is not drawn: ", false);
    take("left out ", ": ", true);
  }
  return reasons;
}

std::string why_not_drawn(bool has_numbers) {
  return has_numbers ? "its numbers are there, but gnuplot has not drawn them"
                     : "make figures has not been run since its cells are there";
}

void take(std::vector<Attachment*>& attachments, std::size_t& left) {
  std::ranges::stable_sort(attachments, {},
                           [](const Attachment* each) { return each->address.size(); });
  for (Attachment* attachment : attachments) {
    if (attachment->file.empty() || attachment->address.size() > left) continue;
    attachment->held = true;
    left -= attachment->address.size();
  }
}

}  // namespace

std::vector<FigureContents> read_figures(const fs::path& run, const std::string& dataset) {
  const fs::path folder = run / dataset / "figures";
  const auto reasons = reasons_in_log(run, run / dataset / "figures.log");
  std::vector<FigureContents> figures;
  for (const figures::Figure& figure : figures::catalogue()) {
    FigureContents contents{.name = figure.name,
                            .paper = figure.paper,
                            .title = figure.title,
                            .caption = figure.caption,
                            .from = figure.from};
    for (const fs::path& svg : files_of_figure(folder, contents.name, ".svg")) {
      contents.pictures.push_back(read_picture(run, svg));
    }
    if (contents.pictures.empty()) {
      const auto reason = reasons.find(contents.name);
      const bool has_numbers = !files_of_figure(folder, contents.name, ".csv").empty();
      contents.missing = reason != reasons.end() ? reason->second.text : why_not_drawn(has_numbers);
      contents.is_left_out = reason != reasons.end() && reason->second.is_left_out;
    }
    figures.push_back(std::move(contents));
  }
  return figures;
}

void choose_attachments(const std::vector<FigureContents*>& figures, std::size_t most_bytes) {
  std::vector<Attachment*> svg;
  std::vector<Attachment*> csv;
  for (FigureContents* figure : figures) {
    for (Picture& picture : figure->pictures) {
      svg.push_back(&picture.svg);
      csv.push_back(&picture.csv);
    }
  }
  take(svg, most_bytes);
  take(csv, most_bytes);
}

}  // namespace piae::page
