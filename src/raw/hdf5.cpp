#include <algorithm>
#include <new>

#include "artefact/hdf5.hpp"
#include "base/error.hpp"
#include "signal/raw_file.hpp"
#include "signal/raw_limits.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;
namespace hdf5 = artefact::hdf5;

/// A file's datasets, as far as a message needs them: there may be millions, in groups that go on
/// for ever.
struct Datasets {
  std::vector<std::string> names;
  std::string group = "/";  ///< that is looked at, with a slash at its end
  int groups_above = 0;
  int looked_at = 0;
};

herr_t note_datasets(hid_t group, const char* name, const H5L_info_t* link, void* out) {
  constexpr int most = 10'000;
  constexpr int deepest = 30;
  auto& datasets = *static_cast<Datasets*>(out);
  H5O_info_t object{};
  if (++datasets.looked_at > most) return 1;
  if (link->type != H5L_TYPE_HARD) return 0;
  if (H5Oget_info_by_name(group, name, &object, H5P_DEFAULT) < 0) return -1;
  if (object.type == H5O_TYPE_DATASET) datasets.names.push_back(datasets.group + name);
  if (object.type != H5O_TYPE_GROUP || datasets.groups_above == deepest) return 0;
  const std::string above = datasets.group;
  datasets.group += std::string(name) + "/";
  ++datasets.groups_above;
  const herr_t result = H5Literate_by_name(group, name, H5_INDEX_NAME, H5_ITER_INC, nullptr,
                                           note_datasets, out, H5P_DEFAULT);
  --datasets.groups_above;
  datasets.group = above;
  return result;
}

[[noreturn]] void refuse_missing_dataset(const fs::path& path, hid_t file,
                                         const std::string& wanted) {
  Datasets datasets;
  hdf5::check(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_datasets, &datasets),
              "list of datasets");
  std::ranges::sort(datasets.names);
  refuse_raw_file(path, "has no dataset " + wanted + "; it has " + listed(datasets.names));
}

/// Whether all of a path is there, and none of it a link to elsewhere.
bool is_there(hid_t file, const std::string& name) {
  for (std::size_t end = 0; end != std::string::npos;) {
    const std::size_t begin = end + 1;
    end = name.find('/', begin);
    const std::string part = name.substr(begin, end - begin);
    if (part.empty() || part == ".") return false;
    H5L_info_t link{};
    const std::string path = name.substr(0, end);
    if (H5Lexists(file, path.c_str(), H5P_DEFAULT) <= 0) return false;
    hdf5::check(H5Lget_info(file, path.c_str(), &link, H5P_DEFAULT), path.c_str());
    if (link.type != H5L_TYPE_HARD) return false;
  }
  return true;
}

bool is_dataset(hid_t file, const std::string& path) {
  const hdf5::Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
  return H5Iget_type(object) == H5I_DATASET;
}

void require_own_values(const fs::path& path, hid_t dataset, const std::string& what) {
  const hdf5::Handle creation(H5Dget_create_plist(dataset), what.c_str());
  if (H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) != 0) {
    refuse_raw_file(path, what + " has its values in another file");
  }
}

std::size_t dataset_length(const fs::path& path, hid_t dataset, const std::string& what) {
  require_own_values(path, dataset, what);
  const hdf5::Shape shape = hdf5::shape_of(dataset);
  return vector_length(path, what, shape.data(), shape.size());
}

void require_numbers(const fs::path& path, hid_t dataset, const std::string& name) {
  const hdf5::Handle type(H5Dget_type(dataset), name.c_str());
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) {
    refuse_raw_file(path, "dataset " + name + " does not hold numbers");
  }
}

hdf5::Handle opened(const fs::path& path) {
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open"};
}

std::vector<double> read_dataset(const fs::path& path, const std::string& name) {
  const hdf5::Handle file = opened(path);
  if (!is_there(file, name) || !is_dataset(file, name)) refuse_missing_dataset(path, file, name);
  const hdf5::Handle dataset = hdf5::open_dataset(file, name);
  require_numbers(path, dataset, name);
  std::vector<double> numbers(dataset_length(path, dataset, "dataset " + name));
  if (!numbers.empty()) {
    hdf5::check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
                name.c_str());
  }
  return numbers;
}

/// HDF5's own errors name no file.
template <class Action>
auto naming(const fs::path& file, const Action& action) {
  try {
    return action();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    refuse_raw_file(file,
                    std::string("truncated, damaged or not an HDF5 file (") + error.what() + ")");
  }
}

}  // namespace

std::vector<double> read_hdf5(const fs::path& file, const std::string& dataset) {
  const std::string absolute = dataset.starts_with('/') ? dataset : "/" + dataset;
  return naming(file, [&] { return read_dataset(file, absolute); });
}

void require_own_vector(const fs::path& path, const std::string& variable) {
  naming(path, [&] {
    const std::string name = "/" + variable;
    const std::string what = "variable " + variable;
    const hdf5::Handle file = opened(path);
    if (H5Lexists(file, name.c_str(), H5P_DEFAULT) <= 0) return;
    if (!is_there(file, name)) refuse_raw_file(path, what + " is a link to elsewhere");
    if (!is_dataset(file, name)) return;
    (void)dataset_length(path, hdf5::open_dataset(file, name), what);
  });
}

}  // namespace piae::signal
