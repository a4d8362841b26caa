#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "artefact/digest.hpp"
#include "artefact/hdf5.hpp"

namespace piae::stages {

inline void replace_attribute(hid_t file, const std::string& object, const std::string& name,
                              const std::string& value) {
  artefact::hdf5::check(H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT),
                        name.c_str());
  artefact::hdf5::write_attribute(file, object, name, value);
}

/// Changes an artefact in place and corrects its digests, so that only its content is wrong, not
/// its bytes.
inline void doctor(const std::string& file, const std::function<void(hid_t)>& change) {
  const artefact::hdf5::Handle open(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
  change(open);
  const artefact::Digests digests = artefact::digests_of(open, artefact::hdf5::object_paths(open));
  replace_attribute(open, artefact::provenance_group, artefact::digest_attribute,
                    digests.provenance);
  replace_attribute(open, "/", artefact::digest_attribute, digests.content);
}

template <artefact::hdf5::Number T>
void replace_attribute(hid_t file, const std::string& object, const std::string& name, T value) {
  artefact::hdf5::check(H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT),
                        name.c_str());
  artefact::hdf5::write_attribute(file, object, name, artefact::hdf5::stored_type<T>(), &value);
}

inline void replace_strings(hid_t file, const std::string& path,
                            const std::vector<std::string>& values) {
  artefact::hdf5::check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), path.c_str());
  artefact::hdf5::write_strings(file, path, values);
}

/// Overwrites a dataset with the numbers that `change` makes of its own.
template <artefact::hdf5::Number T>
void change_numbers(hid_t file, const std::string& path,
                    const std::function<void(std::vector<T>&)>& change) {
  using namespace artefact::hdf5;
  const Handle dataset = open_dataset(file, path);
  std::size_t count = 1;
  for (const std::size_t n : shape_of(dataset)) count *= n;
  std::vector<T> values(count);
  const hid_t type = stored_type<T>();
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path.c_str());
  change(values);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path.c_str());
}

/// Sets the number of balls, in a bearing with enough room.
inline void change_balls(hid_t file, std::int64_t balls) {
  replace_attribute(file, "/bearing", "balls", balls);
  replace_attribute(file, "/bearing", "ball_diameter_mm", 0.1);
  replace_attribute(file, "/bearing", "pitch_diameter_mm", 1000.0);
  replace_attribute(file, "/bearing", "inner_raceway_mm", 999.9);
  replace_attribute(file, "/bearing", "outer_raceway_mm", 1000.1);
  change_numbers<double>(file, "/classes/defect_size_mm", [](auto& sizes) {
    for (double& size : sizes) size = std::min(size, 0.05);
  });
}

}  // namespace piae::stages
