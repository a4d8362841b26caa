#include "signal/raw_file.hpp"

#include "base/error.hpp"

namespace piae::signal {

std::vector<double> read_raw_file(const std::filesystem::path& file, const std::string& variable) {
  const std::string extension = file.extension().string();
  if (extension == ".mat") return read_mat(file, variable);
  if (extension == ".csv") return read_csv(file, variable);
  if (extension == ".h5" || extension == ".hdf5") return read_hdf5(file, variable);
  refuse_raw_file(file, "unknown format '" + extension + "'; known are .mat, .csv, .h5 and .hdf5");
}

void refuse_raw_file(const std::filesystem::path& where, const std::string& what) {
  throw Error(Exit::bad_input, where.string() + ": " + what);
}

}  // namespace piae::signal
