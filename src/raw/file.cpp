#include "signal/raw_file.hpp"

#include <algorithm>
#include <cctype>

#include "base/error.hpp"
#include "base/one_line.hpp"

namespace piae::signal {

namespace {

/// In lower case, as loggers write .CSV and .MAT, too.
std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

std::vector<double> read_here(const std::filesystem::path& file, const std::string& variable) {
  const std::string extension = extension_of(file);
  if (extension == ".mat") return read_mat(file, variable);
  if (extension == ".csv" || extension == ".txt") return read_csv(file, variable);
  if (extension == ".h5" || extension == ".hdf5") return read_hdf5(file, variable);
  refuse_raw_file(file, "unknown format '" + file.extension().string() +
                            "'; known are .mat, .csv, .txt, .h5 and .hdf5");
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 20;
  constexpr std::size_t longest = 80;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    list += (list.empty() ? "" : ", ") + names[i].substr(0, longest);
  }
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " more";
  return list.empty() ? "none" : list;
}

void refuse_raw_file(const std::filesystem::path& where, const std::string& what) {
  throw Error(Exit::bad_input, one_line(where.string() + ": " + what));
}

}  // namespace piae::signal
