#include "artefact/belongs_in.hpp"

namespace piae::artefact {

std::string belongs_in(hid_t file) {
  if (H5Aexists(file, "role") > 0) return hdf5::read_string_attribute(file, "/", "role") + ".h5";
  if (H5Lexists(file, "features", H5P_DEFAULT) > 0) return "features.h5";
  return hdf5::read_string_attribute(file, "/", "kind") + ".h5";
}

}  // namespace piae::artefact
