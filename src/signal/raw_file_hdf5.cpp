#include <algorithm>

#include "artefact/hdf5.hpp"
#include "base/error.hpp"
#include "signal/raw_file.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;
namespace hdf5 = artefact::hdf5;

bool is_dataset(hid_t file, const std::string& path) {
  const hdf5::Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
  return H5Iget_type(object) == H5I_DATASET;
}

std::vector<std::string> datasets_in(hid_t file) {
  std::vector<std::string> paths = hdf5::object_paths(file);
  std::erase_if(paths, [&](const std::string& path) { return !is_dataset(file, path); });
  return paths;
}

void require_dataset(const fs::path& path, hid_t file, const std::string& wanted) {
  std::string list;
  for (const std::string& name : datasets_in(file)) {
    if (name == wanted) return;
    list += (list.empty() ? "" : ", ") + name;
  }
  refuse_raw_file(path, "has no dataset " + wanted + "; it has " + (list.empty() ? "none" : list));
}

std::size_t length_of(const fs::path& path, hid_t dataset, const std::string& name) {
  const hdf5::Handle type(H5Dget_type(dataset), name.c_str());
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) {
    refuse_raw_file(path, "dataset " + name + " does not hold numbers");
  }
  std::size_t count = 1;
  std::size_t longest = 1;
  for (const std::size_t extent : hdf5::shape_of(dataset)) {
    count *= extent;
    longest = std::max(longest, extent);
  }
  if (count > 0 && count != longest) refuse_raw_file(path, "dataset " + name + " is not a vector");
  return count;
}

std::vector<double> read_dataset(const fs::path& path, const std::string& name) {
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open");
  require_dataset(path, file, name);
  const hdf5::Handle dataset = hdf5::open_dataset(file, name);
  std::vector<double> numbers(length_of(path, dataset, name));
  if (!numbers.empty()) {
    hdf5::check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
                name.c_str());
  }
  return numbers;
}

}  // namespace

std::vector<double> read_hdf5(const fs::path& file, const std::string& dataset) {
  const std::string absolute = dataset.starts_with('/') ? dataset : "/" + dataset;
  try {
    return read_dataset(file, absolute);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    refuse_raw_file(file,
                    std::string("truncated, damaged or not an HDF5 file (") + error.what() + ")");
  }
}

}  // namespace piae::signal
