#include "raw/node.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>

#include "raw/file.hpp"

namespace piae::raw {

namespace {

using Kind = Node::Kind;

/// Lists the elements of an array of structures by their field Name, if there is one.
std::string element_names(const Where& where, const Node& node) {
  constexpr std::size_t most = 10;
  std::vector<std::string> names;
  const std::vector<std::string> fields = node.fields();
  if (std::ranges::find(fields, "Name") == fields.end()) return "";
  for (std::size_t i = 0; i < std::min(count_of(node.shape()), most); ++i) {
    const auto field = node.field("Name", i);
    if (field && field->kind() == Kind::text) {
      names.push_back(fmt::format("{}[Name={}]", where.name, field->text()));
    }
  }
  return names.empty() ? "" : ", or " + listed(names);
}

[[noreturn]] void refuse_structure(const Where& where, const Node& node) {
  const std::vector<std::string> fields = node.fields();
  refuse(where, fmt::format("is a structure with the fields {}; name one of them: {}.{}",
                            listed(fields), where.name, fields.empty() ? "FIELD" : fields.front()));
}

/// Refuses a node that is not an array of numbers.
[[noreturn]] void refuse_kind(const Where& where, const Node& node) {
  const std::size_t count = count_of(node.shape());
  if (node.kind() == Kind::text)
    refuse(where, "does not hold numbers, but text; name another variable");
  if (node.kind() == Kind::cell) {
    refuse(where,
           fmt::format("is a cell array of {}; name one of them: {}{{1}}", count, where.name));
  }
  if (node.kind() == Kind::structure && count == 1) refuse_structure(where, node);
  if (node.kind() == Kind::structure) {
    refuse(where, fmt::format("is an array of {} structures; name one of them: {}(1){}", count,
                              where.name, element_names(where, node)));
  }
  refuse(where, "is " + node.what());
}

bool names_element(const PathStep& step) { return step.number > 0 || !step.key.empty(); }

std::string brackets_of(const PathStep& step, Kind kind) {
  if (step.number > 0) {
    const std::string number = step.column == 0 ? fmt::format("{}", step.number)
                                                : fmt::format("{},{}", step.number, step.column);
    return kind == Kind::cell ? "{" + number + "}" : "(" + number + ")";
  }
  return step.key.empty() ? "" : fmt::format("[{}={}]", step.key, step.value);
}

void require_field(const Where& where, const Node& node, const std::string& name) {
  const std::vector<std::string> fields = node.fields();
  const auto count = std::ranges::count(fields, name);
  if (count == 1) return;
  if (count > 1) {
    refuse(
        where,
        fmt::format(
            "has {} fields named {}, and programs read different ones; save it with distinct names",
            count, name));
  }
  refuse(where, fmt::format("has no field {}; it has {}", name, listed(fields)));
}

/// Returns the element, counted from 0, whose field `key` holds the text.
std::size_t element_called(const Where& where, const Node& node, const PathStep& step) {
  if (node.kind() != Kind::structure) refuse_kind(where, node);
  require_field(where, node, step.key);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < count_of(node.shape()); ++i) {
    const auto field = node.field(step.key, i);
    if (field && field->kind() == Kind::text && field->text() == step.value) found.push_back(i);
  }
  if (found.size() == 1) return found.front();
  if (found.size() > 1) {
    std::vector<std::string> elements;
    elements.reserve(found.size());
    for (const std::size_t i : found) elements.push_back(fmt::format("{}({})", where.name, i + 1));
    refuse(where, fmt::format("has {} elements whose {} is {}: {}; name one of these", found.size(),
                              step.key, step.value, listed(elements)));
  }
  refuse(where, fmt::format("has no element whose {} is {}; name one by its number{}", step.key,
                            step.value, element_names(where, node)));
}

/// Returns the element in a row and a column, counted from 0 down the columns, as MATLAB stores
/// them.
std::size_t element_at(const Where& where, const Shape& shape, const PathStep& step) {
  if (shape.size() != 2 || step.number > shape[0] || step.column > shape[1]) {
    refuse(where, fmt::format("is an array of {}, which has no element ({},{})",
                              fmt::join(shape, " x "), step.number, step.column));
  }
  return step.number - 1 + (step.column - 1) * shape[0];
}

/// Returns the element of a structure or cell array that a step names, counted from 0.
std::size_t element_of(const Where& where, const Node& node, const PathStep& step) {
  if (node.kind() == Kind::numbers && step.number > 0) {
    refuse(where, fmt::format("holds numbers, and {} is only one of them; name a row {}(1,:) or a "
                              "column {}(:,1) of a matrix, or a whole vector {}",
                              brackets_of(step, node.kind()), where.name, where.name, where.name));
  }
  if (node.kind() != Kind::structure && node.kind() != Kind::cell) {
    refuse(where, "is neither a structure nor a cell array");
  }
  if (!step.key.empty()) return element_called(where, node, step);
  const std::size_t count = count_of(node.shape());
  if (step.column > 0) return element_at(where, node.shape(), step);
  if (step.number > count) {
    refuse(where, fmt::format("has {} elements; number {} does not exist", count, step.number));
  }
  if (step.number == 0 && count != 1) refuse_kind(where, node);
  return step.number == 0 ? 0 : step.number - 1;
}

}  // namespace

std::vector<double> vector_in(const Where& where, const Node& node,
                              const std::optional<MatrixLine>& line) {
  if (node.kind() != Kind::numbers) refuse_kind(where, node);
  return vector_of(where,
                   {.shape = node.shape(),
                    .is_column_major = node.is_column_major(),
                    .numbers = [&] { return node.numbers(); }},
                   line);
}

std::vector<double> vector_at(const std::filesystem::path& file, std::unique_ptr<Node> node,
                              const VariablePath& path) {
  Where where{.file = file, .noun = "variable", .name = path.steps.front().name};
  for (std::size_t i = 0; i < path.steps.size(); ++i) {
    const PathStep& step = path.steps[i];
    const bool is_last = i + 1 == path.steps.size();
    if (is_last && !names_element(step)) break;
    std::size_t element = element_of(where, *node, step);
    where.name += brackets_of(step, node->kind());
    if (node->kind() == Kind::cell) {
      node = node->element(element);
      element = 0;
      if (!node) refuse(where, "is empty");
      if (is_last) break;
    }
    if (is_last) refuse_structure(where, *node);
    if (node->kind() != Kind::structure) refuse_kind(where, *node);
    const std::string& next = path.steps[i + 1].name;
    require_field(where, *node, next);
    node = node->field(next, element);
    where.name += '.' + next;
    if (!node) refuse(where, "is empty");
  }
  return vector_in(where, *node, path.line);
}

}  // namespace piae::raw
