#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace piae::raw {

/// A data set 58 of a universal file, "function at nodal degree of freedom".
struct UffFunction {
  std::string name;       ///< first ID line
  int function_type = 0;  ///< 1 for a time response
  int ordinate_type = 0;  ///< 2, 4: single, double; 5, 6: the same, complex
  std::size_t count = 0;  ///< number of values, or of pairs
  bool is_even = true;    ///< false if each value has its abscissa before it
  double increment = 0;   ///< step of the abscissa
  int abscissa_type = 0;  ///< 17 for time
  bool is_binary = false;
  bool is_big_endian = false;
  std::string_view values = {};  ///< lines or bytes of the values
  std::size_t first_line = 0;    ///< first line of `values`; wrong after binary data
};

/// Returns the data sets 58 in the text of a file. Throws Error(bad_input) if a data set has no end
/// or no readable header, or if no data set has type 58.
std::vector<UffFunction> uff_functions(const std::filesystem::path& file, std::string_view text);

}  // namespace piae::raw
