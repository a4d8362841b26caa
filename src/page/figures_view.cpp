#include "page/figures_view.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "diagnosis/catalogue.hpp"
#include "figures/catalogue.hpp"
#include "page/contents.hpp"
#include "page/html.hpp"
#include "report/labels.hpp"
#include "text/file.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// Returns the files of a figure with this ending: NAME.svg, or NAME@PART.svg for each part.
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

/// Returns the reasons that the stage `figures` logged for figures that are not drawn, by name.
std::map<std::string, Reason> reasons_in_log(const fs::path& run, const fs::path& log) {
  std::map<std::string, Reason> reasons;
  if (!fs::exists(log)) return reasons;
  std::istringstream lines(text::read_file(log));
  for (std::string line; std::getline(lines, line);) {
    const auto take = [&](const std::string& before, const std::string& after, bool is_left_out) {
      const std::size_t end_of_name = line.find(after);
      if (!line.starts_with(before) || end_of_name == std::string::npos) return;
      const std::string name = line.substr(before.size(), end_of_name - before.size());
      reasons[name] = {below_run(line.substr(end_of_name + after.size()), run), is_left_out};
    };
    take("figures: ", " is not drawn: ", false);
    take("left out ", ": ", true);
  }
  return reasons;
}

std::string why_not_drawn(bool has_numbers) {
  return has_numbers ? "its numbers exist, but gnuplot has not drawn them"
                     : "make figures has not run since its cells exist";
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

std::string heading_of(const FigureContents& figure) {
  return (figure.paper.empty() ? "" : figure.paper + ": ") + figure.title;
}

std::string id_of(const std::string& dataset, const std::string& name) {
  return anchor(dataset + "-" + name);
}

/// Describes the picture for people who cannot see it. The linked CSV file has the numbers.
std::string described(const std::string& dataset, const FigureContents& figure,
                      const Picture& picture) {
  const std::string part = picture.part.empty() ? "" : ", " + diagnosis::marked_name(picture.part);
  return heading_of(figure) + ", on " + dataset + part + ". " + figure.caption +
         " The numbers are in the CSV file that is linked below.";
}

Html picture_itself(const std::string& dataset, const FigureContents& figure,
                    const Picture& picture) {
  if (picture.svg.held) {
    Attributes attributes{{"src", picture.svg.address},
                          {"alt", described(dataset, figure, picture)},
                          {"loading", "lazy"},
                          {"decoding", "async"}};
    // Reserves the space, so that the page does not move when the picture loads.
    if (picture.height > 0) {
      attributes.push_back({"width", std::to_string(picture.width)});
      attributes.push_back({"height", std::to_string(picture.height)});
    }
    return void_element("img", attributes);
  }
  return element("p", Html("This picture would make the page too large to send; it is in ") +
                          file_link(picture.svg.file) + ".");
}

Html numbers_link(const std::string& dataset, const FigureContents& figure,
                  const Picture& picture) {
  if (picture.csv.file.empty()) return {};
  if (!picture.csv.held) return file_link(picture.csv.file, "CSV");
  const std::string part = picture.part.empty() ? "" : "@" + picture.part;
  return element(
      "a",
      {{"href", picture.csv.address}, {"download", dataset + "-" + figure.name + part + ".csv"}},
      "CSV");
}

Html files_line(const std::string& dataset, const FigureContents& figure, const Picture& picture) {
  Html line = Html("Save as ") + numbers_link(dataset, figure, picture) + " " +
              file_link(picture.svg.file, "SVG");
  if (!picture.pdf.empty()) line += " " + file_link(picture.pdf, "PDF");
  return element("p", {{"class", "files"}}, line);
}

Html html_of_picture(const std::string& dataset, const FigureContents& figure,
                     const Picture& picture) {
  Html content = picture_itself(dataset, figure, picture);
  Html caption = files_line(dataset, figure, picture);
  if (!picture.part.empty())
    caption = element("h4", diagnosis::marked_name(picture.part)) + caption;
  const std::string part = picture.part.empty() ? "" : "-" + picture.part;
  return element("figure", {{"id", id_of(dataset, figure.name + part)}},
                 content + element("figcaption", caption));
}

Html html_of_figure(const std::string& dataset, const FigureContents& figure) {
  const std::string id = id_of(dataset, "figure-" + figure.name);
  Html pictures;
  for (const Picture& picture : figure.pictures)
    pictures += html_of_picture(dataset, figure, picture);
  const Html here = element(
      "a", {{"class", "anchor"}, {"href", "#" + id}, {"aria-label", "Link to this figure"}}, "#");
  return element("section",
                 {{"id", id}, {"class", figure.pictures.size() > 1 ? "card wide" : "card"}},
                 element("h3", Html(heading_of(figure)) + here) + element("p", figure.caption) +
                     element("div", {{"class", "pictures"}}, pictures) +
                     element("p", {{"class", "from"}}, "From " + dataset + "/" + figure.from));
}

/// Returns a line for each reason, with all figures that are missing for it.
Html list_of_reasons(const std::vector<FigureContents>& figures, bool left_out) {
  std::vector<std::pair<std::string, std::vector<std::string>>> names_by_reason;
  for (const FigureContents& figure : figures) {
    if (!figure.pictures.empty() || figure.is_left_out != left_out) continue;
    auto reason = std::ranges::find(names_by_reason, figure.missing,
                                    [](const auto& each) { return each.first; });
    if (reason == names_by_reason.end())
      reason = names_by_reason.insert(reason, {figure.missing, {}});
    reason->second.push_back(heading_of(figure) + " (" + figure.name + ")");
  }
  Html items;
  for (const auto& [reason, names] : names_by_reason) {
    items += element("li", element("b", reason) + ": " + report::listed(names));
  }
  return items.empty() ? Html() : element("ul", items);
}

Html list_of_missing(const std::vector<FigureContents>& figures) {
  const Html reasons = list_of_reasons(figures, false);
  if (reasons.empty()) return {};
  return element("div", {{"class", "problems"}},
                 element("p", "⚠ Figures that are not drawn") + reasons);
}

Html list_of_left_out(const std::vector<FigureContents>& figures) {
  const Html reasons = list_of_reasons(figures, true);
  if (reasons.empty()) return {};
  return element("div", {{"class", "quiet"}},
                 element("p", "Left out, because this run lacks what they show") + reasons);
}

Html list_of_contents(const std::string& dataset, const std::vector<FigureContents>& figures) {
  Html items;
  for (const FigureContents& figure : figures) {
    if (figure.pictures.empty()) continue;
    const std::string address = "#" + id_of(dataset, "figure-" + figure.name);
    items += element("li", element("a", {{"href", address}}, heading_of(figure)));
  }
  return items.empty() ? Html() : element("ul", {{"class", "contents"}}, items);
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

Html figures_view(const std::string& dataset, const std::vector<FigureContents>& figures) {
  Html cards;
  for (const FigureContents& figure : figures) {
    if (!figure.pictures.empty()) cards += html_of_figure(dataset, figure);
  }
  return list_of_missing(figures) + list_of_contents(dataset, figures) +
         element("div", {{"class", "figures"}}, cards) + list_of_left_out(figures);
}

}  // namespace piae::page
