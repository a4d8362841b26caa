#include "page/figures_view.hpp"

#include <algorithm>

#include "page/links.hpp"
#include "report/labels.hpp"

namespace piae::page {

namespace {

std::string heading_of(const FigureContents& figure) {
  return (figure.paper.empty() ? "" : figure.paper + ": ") + figure.title;
}

std::string id_of(const std::string& dataset, const std::string& name) {
  return anchor(dataset + "-" + name);
}

/// What the picture shows, for those who cannot see it. Its numbers are in the CSV file beside it.
std::string described(const std::string& dataset, const FigureContents& figure,
                      const Picture& picture) {
  const std::string part = picture.part.empty() ? "" : ", " + picture.part;
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
    // So that nothing moves when it is there.
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
  if (!picture.part.empty()) caption = element("h4", picture.part) + caption;
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

/// A line for each reason, with all figures that are missing for it.
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
                 element("p", "Left out, as this run is without what they show") + reasons);
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

Html figures_view(const std::string& dataset, const std::vector<FigureContents>& figures) {
  Html cards;
  for (const FigureContents& figure : figures) {
    if (!figure.pictures.empty()) cards += html_of_figure(dataset, figure);
  }
  return list_of_missing(figures) + list_of_contents(dataset, figures) +
         element("div", {{"class", "figures"}}, cards) + list_of_left_out(figures);
}

}  // namespace piae::page
