#include "report/labels.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "run/grid.hpp"

namespace piae::report {

std::string number_label(double number, NumberStyle style) {
  return style.sign ? fmt::format("{:+.{}f}", number, style.decimals)
                    : fmt::format("{:.{}f}", number, style.decimals);
}

std::string mean_label(const scoring::Summary& summary, NumberStyle style) {
  std::string mean = number_label(summary.mean, style);
  if (!summary.deviation) return mean;
  return mean + " ± " + number_label(*summary.deviation, {style.decimals});
}

std::string interval_label(const scoring::Summary& summary, NumberStyle style) {
  if (!summary.interval) return no_number;
  return "[" + number_label(summary.interval->low, style) + ", " +
         number_label(summary.interval->high, style) + "]";
}

std::string method_label(const std::string& method) {
  return augment::is_ceiling(method) ? method + " (ceiling)" : method;
}

std::string looks_of(const std::string& method) {
  return augment::is_ceiling(method) ? "ceiling" : "";
}

std::string about_adapting(const std::vector<std::string>& classifiers) {
  const bool any = std::ranges::any_of(classifiers, [](const std::string& name) {
    return diagnosis::the_classifier(name).adapts();
  });
  return any ? "A classifier that sees D learns from these windows of the tested condition, too, "
               "without their labels: more than the others get. With the random split they overlap "
               "the tested windows."
             : "";
}

std::string marked_if(bool fewer_seeds, const std::string& label) {
  return fewer_seeds ? label + " " + mark_of_fewer_seeds : label;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

std::string short_ratio_label(const std::string& name) {
  const std::size_t to = name.find("to");
  return name.substr(0, to) + ":" + name.substr(to + 2);
}

std::string ratio_label(const std::string& name, std::optional<double> true_ratio) {
  const std::size_t to = name.find("to");
  const double named = std::stod(name.substr(0, to)) / std::stod(name.substr(to + 2));
  const std::string label = short_ratio_label(name);
  if (!true_ratio) return label + " (no faults)";
  const bool as_named = std::abs(*true_ratio - named) < 0.005 * named;
  return as_named ? label : fmt::format("{} ({:.3g}:1)", label, *true_ratio);
}

std::string four_decimals(std::optional<double> number) {
  return number ? fmt::format("{:.4f}", *number) : "";
}

std::string counted(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

}  // namespace piae::report
