#include "signal/raw_file.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/one_line.hpp"

namespace piae::signal {

namespace {

bool is_csv(const std::filesystem::path& file) { return file.extension() == ".csv"; }
bool is_mat(const std::filesystem::path& file) { return file.extension() == ".mat"; }
bool is_hdf5(const std::filesystem::path& file) {
  return file.extension() == ".h5" || file.extension() == ".hdf5";
}

}  // namespace

std::vector<double> read_here(const std::filesystem::path& file, const std::string& variable) {
  if (is_mat(file)) return read_mat(file, variable);
  if (is_csv(file)) return read_csv(file, variable);
  if (is_hdf5(file)) return read_hdf5(file, variable);
  refuse_raw_file(file, "unknown format '" + file.extension().string() +
                            "'; known are .mat, .csv, .h5 and .hdf5");
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
