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

/// A name and, if it has several elements, one of them.
struct PathStep {
  std::string name;
  std::size_t number = 0;  ///< number or row of the element, counted from 1; 0 if none is named
  std::size_t column = 0;  ///< column of the element, counted from 1; 0 if one number names it
  std::string key = {};    ///< field whose text is `value` in the element
  std::string value = {};
};

/// Path to a variable inside others, in the notation of data set descriptions:
///   bearing.gs                   a field of a structure
///   K.Y(2).Data, c{2}            of the second element of an array of structures; of a cell array
///   K.Y(1,2).Data, c{1,2}        the same by row and column
///   K.Y[Name=vibration_1].Data   of the element whose field Name holds this text
///   data(2,:), data(:,2)         the second row, the second column of a matrix
struct VariablePath {
  std::vector<PathStep> steps;
  std::optional<MatrixLine> line = std::nullopt;
};

/// Parses a path; returns nothing for other texts.
std::optional<VariablePath> parse_variable(const std::string& text);

/// Returns a hint on the notation of parts if a missing name looks like a part; otherwise "".
std::string hint_at_parts(const std::string& name);

/// Takes "(2,:)" or "(:,2)" from the end of a text; returns nothing for other endings.
std::optional<MatrixLine> take_matrix_line(std::string& text);

}  // namespace piae::raw
