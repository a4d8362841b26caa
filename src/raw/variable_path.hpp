#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace piae::raw {

/// A row or a column of a matrix, counted from 1.
struct MatrixLine {
  bool is_row = true;
  std::size_t number = 1;
};

/// A name, and where several are called so, which one of them.
struct PathStep {
  std::string name;
  std::size_t number = 0;  ///< of the element, or of its row, counted from 1; 0 where none is named
  std::size_t column = 0;  ///< of the element, counted from 1; 0 where one number names it
  std::string key = {};    ///< of the element whose field `key` holds `value`
  std::string value = {};
};

/// A variable inside others, as descriptions write it:
///   bearing.gs                   a field of a structure
///   K.Y(2).Data, c{2}            of the second element of an array of structures; of a cell array
///   K.Y(1,2).Data, c{1,2}        the same by row and column
///   K.Y[Name=vibration_1].Data   of the element whose field Name holds this text
///   data(2,:), data(:,2)         the second row, the second column of a matrix
struct VariablePath {
  std::vector<PathStep> steps;
  std::optional<MatrixLine> line = std::nullopt;
};

/// Empty where the text is none of these.
std::optional<VariablePath> parse_variable(const std::string& text);

/// Says how parts of a variable are written, where a name that is not found seems to mean one.
std::string hint_at_parts(const std::string& name);

/// Takes "(2,:)" or "(:,2)" from the end of a text; empty where neither stands there.
std::optional<MatrixLine> take_matrix_line(std::string& text);

}  // namespace piae::raw
