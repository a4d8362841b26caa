#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "raw/array.hpp"
#include "raw/variable_path.hpp"

namespace piae::raw {

/// A variable of a MATLAB or HDF5 file, or a part of one. Questions that do not fit its kind are
/// never asked.
class Node {
 public:
  enum class Kind { numbers, text, structure, cell, other };

  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  [[nodiscard]] virtual Kind kind() const = 0;
  /// Says what a node of another kind is, and how its numbers can be exported.
  [[nodiscard]] virtual std::string what() const = 0;
  /// Its extents; those of a structure are of the array whose elements have the same fields.
  [[nodiscard]] virtual Shape shape() const = 0;

  [[nodiscard]] virtual std::vector<std::string> fields() const = 0;
  /// A field of an element of a structure, or an element of a cell array, counted from 0.
  [[nodiscard]] virtual std::unique_ptr<Node> field(const std::string& name,
                                                    std::size_t element) const = 0;
  [[nodiscard]] virtual std::unique_ptr<Node> element(std::size_t element) const = 0;

  [[nodiscard]] virtual std::string text() const = 0;
  [[nodiscard]] virtual std::vector<double> numbers() const = 0;
  /// True if the first index runs fastest among the numbers, as in MATLAB; else the last one does.
  [[nodiscard]] virtual bool is_column_major() const = 0;
};

/// The vector in a node, or a row or column of its matrix. Throws Error(bad_input) as vector_of()
/// does, and where the node is no array of numbers.
std::vector<double> vector_in(const Where& where, const Node& node,
                              const std::optional<MatrixLine>& line);

/// The vector at the end of a path; `node` is what its first step names. Throws as vector_in()
/// does, and where a step leads nowhere, with the steps that there are.
std::vector<double> vector_at(const std::filesystem::path& file, std::unique_ptr<Node> node,
                              const VariablePath& path);

}  // namespace piae::raw
