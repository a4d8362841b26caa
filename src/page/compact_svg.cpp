#include "page/compact_svg.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <map>
#include <optional>

#include "page/svg_path.hpp"
#include "page/xml.hpp"

namespace piae::page {

namespace {

/// "rgb(  0, 114, 178)" as "#0072b2"; any other text as it is.
std::string short_colour(const std::string& value) {
  std::array<unsigned, 3> rgb{};
  int length = 0;
  const int found =
      std::sscanf(value.c_str(), "rgb( %u , %u , %u )%n", &rgb[0], &rgb[1], &rgb[2], &length);
  const bool is_colour = found == 3 && static_cast<std::size_t>(length) == value.size() &&
                         std::ranges::max(rgb) <= 255;
  return is_colour ? fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]) : value;
}

/// These are what SVG has without being told; gnuplot tells it at every group, and nothing else.
bool is_initial(const XmlNode::Attribute& attribute) {
  return (attribute.name == "stroke-linecap" && attribute.value == "butt") ||
         (attribute.name == "stroke-linejoin" && attribute.value == "miter");
}

bool has_other_joins(const XmlNode& node) {
  const bool own = std::ranges::any_of(node.attributes, [](const XmlNode::Attribute& attribute) {
    return attribute.name.starts_with("stroke-line") && !is_initial(attribute);
  });
  return own || std::ranges::any_of(node.children, has_other_joins);
}

/// Whether a mark stands at each of its points, so that none may be left out.
bool has_marks(const XmlNode& node) {
  return std::ranges::any_of(node.attributes, [](const XmlNode::Attribute& attribute) {
    return attribute.value.find("marker") != std::string::npos ||
           attribute.name.starts_with("marker");
  });
}

std::string short_path(const std::string& path, bool simplify) {
  std::optional<std::vector<Polyline>> lines = parse_path(path);
  if (!lines) return path;
  if (simplify) std::ranges::transform(*lines, lines->begin(), simplified);
  return path_text(*lines);
}

/// What is defined to be scaled, such as gnuplot's marks, is not rounded.
void shorten_attributes(XmlNode& node, bool drop_initial) {
  if (node.name == "defs") return;
  if (drop_initial) std::erase_if(node.attributes, is_initial);
  const bool simplify = !has_marks(node);
  for (XmlNode::Attribute& attribute : node.attributes) {
    attribute.value = short_colour(attribute.value);
    if (attribute.name == "d") attribute.value = short_path(attribute.value, simplify);
    if (attribute.name == "points") attribute.value = short_numbers(attribute.value);
  }
  for (XmlNode& child : node.children) shorten_attributes(child, drop_initial);
}

/// gnuplot puts each plot into a group that has a name, for its interactive pictures, and nothing
/// else.
bool only_names_a_plot(const XmlNode& node) {
  const std::string* id = node.find("id");
  return node.name == "g" && node.attributes.size() == 1 && id != nullptr &&
         id->starts_with("gnuplot_plot_");
}

bool is_only_said(const XmlNode& node) { return node.name == "title" || node.name == "desc"; }

void unwrap_plots(XmlNode& node) {
  std::vector<XmlNode> children;
  for (XmlNode& child : node.children) {
    unwrap_plots(child);
    if (only_names_a_plot(child)) {
      std::ranges::move(child.children, std::back_inserter(children));
    } else if (!is_only_said(child)) {
      children.push_back(std::move(child));
    }
  }
  node.children = std::move(children);
}

bool has_no_line(const std::string& path) {
  const std::optional<std::vector<Polyline>> lines = parse_path(path);
  return lines && std::ranges::all_of(*lines, [](const Polyline& line) {
           return line.points.size() == 1 && !line.closed;
         });
}

/// A group or a text without content, and a path that only moves: gnuplot writes them for tics
/// without labels.
bool is_unseen(const XmlNode& node) {
  const bool may_be_empty = node.name == "g" || node.name == "text" || node.name == "tspan";
  if (may_be_empty) return node.children.empty() && node.find("id") == nullptr;
  const std::string* path = node.find("d");
  return node.name == "path" && path != nullptr && !has_marks(node) && has_no_line(*path);
}

void drop_unseen(XmlNode& node) {
  if (node.name == "defs") return;
  for (XmlNode& child : node.children) drop_unseen(child);
  std::erase_if(node.children, is_unseen);
}

/// Whether one group may hold what two neighbours hold. Groups that are seen through may not: what
/// overlaps in one is not seen twice.
bool can_be_joined(const XmlNode& first, const XmlNode& second) {
  return first.name == "g" && second.name == "g" && first.attributes == second.attributes &&
         first.find("id") == nullptr && first.find("opacity") == nullptr;
}

void join_equal_groups(XmlNode& node) {
  std::vector<XmlNode> joined;
  for (XmlNode& child : node.children) {
    if (!joined.empty() && can_be_joined(joined.back(), child)) {
      std::ranges::move(child.children, std::back_inserter(joined.back().children));
    } else {
      joined.push_back(std::move(child));
    }
  }
  node.children = std::move(joined);
  for (XmlNode& child : node.children) join_equal_groups(child);
}

/// What an element hands on to those within it, and gnuplot says again at each.
constexpr const char* handed_on[] = {"fill", "color", "stroke", "stroke-width"};

/// Puts the attributes that all groups of an element have, with their most frequent values, on one
/// group around them, and takes them from those that have these values.
void hoist_attributes(XmlNode& node) {
  const auto is_group = [](const XmlNode& child) { return child.name == "g"; };
  const auto first = std::ranges::find_if(node.children, is_group);
  if (!std::all_of(first, node.children.end(), is_group)) return;
  XmlNode around{.name = "g"};
  for (const char* name : handed_on) {
    std::map<std::string, std::size_t> count;
    for (auto child = first; child != node.children.end(); ++child) {
      if (const std::string* value = child->find(name)) ++count[*value];
    }
    std::size_t all = 0;
    for (const auto& [value, times] : count) all += times;
    if (count.empty() || all != static_cast<std::size_t>(node.children.end() - first)) continue;
    const auto usual =
        std::ranges::max_element(count, {}, [](const auto& each) { return each.second; });
    const XmlNode::Attribute attribute{name, usual->first};
    around.attributes.push_back(attribute);
    for (auto child = first; child != node.children.end(); ++child) {
      std::erase(child->attributes, attribute);
    }
  }
  if (around.attributes.empty()) return;
  std::move(first, node.children.end(), std::back_inserter(around.children));
  node.children.erase(first, node.children.end());
  node.children.push_back(std::move(around));
}

void hoist_in_canvas(XmlNode& root) {
  for (XmlNode& child : root.children) {
    const std::string* id = child.find("id");
    if (id != nullptr && *id == "gnuplot_canvas") hoist_attributes(child);
  }
}

/// A group that says nothing holds what it has as well as the one around it.
void unwrap_silent_groups(XmlNode& node) {
  std::vector<XmlNode> children;
  for (XmlNode& child : node.children) {
    unwrap_silent_groups(child);
    if (child.name == "g" && child.attributes.empty()) {
      std::ranges::move(child.children, std::back_inserter(children));
    } else {
      children.push_back(std::move(child));
    }
  }
  node.children = std::move(children);
}

bool uses_font(const XmlNode& node, const std::string& font) {
  const std::string* own = node.find("font-family");
  return (own == nullptr || *own == font) &&
         std::ranges::all_of(node.children,
                             [&](const XmlNode& child) { return uses_font(child, font); });
}

void drop_font(XmlNode& node) {
  std::erase_if(node.attributes, [](const XmlNode::Attribute& attribute) {
    return attribute.name == "font-family";
  });
  for (XmlNode& child : node.children) drop_font(child);
}

const std::string* first_font(const XmlNode& node) {
  if (const std::string* own = node.find("font-family")) return own;
  for (const XmlNode& child : node.children) {
    if (const std::string* font = first_font(child)) return font;
  }
  return nullptr;
}

/// A font that all texts have is said once.
void say_font_once(XmlNode& root) {
  const std::string* found = first_font(root);
  if (found == nullptr || !uses_font(root, *found)) return;
  const std::string font = *found;
  drop_font(root);
  root.attributes.push_back({"font-family", font});
}

/// A part of a text that says nothing about itself is as good as the text.
void unwrap_silent_texts(XmlNode& node) {
  std::vector<XmlNode> children;
  for (XmlNode& child : node.children) {
    unwrap_silent_texts(child);
    if (child.name == "tspan" && child.attributes.empty()) {
      std::ranges::move(child.children, std::back_inserter(children));
    } else {
      children.push_back(std::move(child));
    }
  }
  node.children = std::move(children);
}

}  // namespace

std::string compact_svg(const std::string& svg) {
  std::optional<XmlNode> root = parse_xml(svg);
  if (!root || root->name != "svg") return svg;
  unwrap_plots(*root);
  shorten_attributes(*root, !has_other_joins(*root));
  say_font_once(*root);
  drop_unseen(*root);
  unwrap_silent_texts(*root);
  hoist_in_canvas(*root);
  unwrap_silent_groups(*root);
  join_equal_groups(*root);
  return xml_text(*root);
}

}  // namespace piae::page
