#include "page/compact_svg.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <optional>

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

void shorten_attributes(XmlNode& node, bool drop_initial) {
  if (drop_initial) std::erase_if(node.attributes, is_initial);
  for (XmlNode::Attribute& attribute : node.attributes) {
    attribute.value = short_colour(attribute.value);
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

void drop_empty_groups(XmlNode& node) {
  for (XmlNode& child : node.children) drop_empty_groups(child);
  std::erase_if(node.children, [](const XmlNode& child) {
    return child.name == "g" && child.children.empty() && child.find("id") == nullptr;
  });
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

}  // namespace

std::string compact_svg(const std::string& svg) {
  std::optional<XmlNode> root = parse_xml(svg);
  if (!root || root->name != "svg") return svg;
  unwrap_plots(*root);
  shorten_attributes(*root, !has_other_joins(*root));
  drop_empty_groups(*root);
  join_equal_groups(*root);
  return xml_text(*root);
}

}  // namespace piae::page
