#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "raw/array.hpp"
#include "raw/variable_path.hpp"

namespace piae::raw {

/// A variable of a MATLAB or HDF5 file, or a part of one. Callers use only the functions that fit
/// its kind().
class Node {
 public:
  enum class Kind { numbers, text, structure, cell, other };

  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  [[nodiscard]] virtual Kind kind() const = 0;
  /// Describes a node of kind `other`, and how to export its numbers.
  [[nodiscard]] virtual std::string what() const = 0;
  /// Returns the extents; for a structure, the extents of the array of such structures.
  [[nodiscard]] virtual Shape shape() const = 0;

  [[nodiscard]] virtual std::vector<std::string> fields() const = 0;
  /// Returns a field of one element of a structure array, counted from 0; null if it is empty.
  /// Require first that the field exists.
  [[nodiscard]] virtual std::unique_ptr<Node> field(const std::string& name,
                                                    std::size_t element) const = 0;
  /// Returns an element of a cell array, counted from 0; null if it is empty.
  [[nodiscard]] virtual std::unique_ptr<Node> element(std::size_t element) const = 0;

  [[nodiscard]] virtual std::string text() const = 0;
  [[nodiscard]] virtual std::vector<double> numbers() const = 0;
  /// True if the first index varies fastest, as in MATLAB; otherwise the last index does.
  [[nodiscard]] virtual bool is_column_major() const = 0;
};

/// Returns the vector in a node, or a row or column of its matrix. Throws Error(bad_input) like
/// vector_of(), and if the node is not an array of numbers.
std::vector<double> vector_in(const Where& where, const Node& node,
                              const std::optional<MatrixLine>& line);

/// Returns the vector at the end of a path; `node` is the object of the first step. Throws like
/// vector_in(), and if a step does not exist; the error lists the steps that do.
std::vector<double> vector_at(const std::filesystem::path& file, std::unique_ptr<Node> node,
                              const VariablePath& path);

}  // namespace piae::raw
