// Writes small recordings in binary formats of MATLAB, HDF5 and TDMS into mat/, hdf5/ and tdms/
// below a folder.

#include <hdf5.h>
#include <matio.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/tdms_writer.hpp"

namespace fs = std::filesystem;

namespace {

constexpr std::size_t samples = 120;

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

std::vector<double> signal() {
  std::vector<double> values(samples);
  for (std::size_t i = 0; i < samples; ++i) values[i] = std::sin(static_cast<double>(i) / 3);
  return values;
}

void write_variable(mat_t* file, const char* name, matio_classes kind, matio_types type,
                    const void* data, matio_compression compression) {
  std::array<std::size_t, 2> extents{samples, 1};
  const std::unique_ptr<matvar_t, Close> variable(
      Mat_VarCreate(name, kind, type, 2, extents.data(), const_cast<void*>(data), 0));
  if (!variable || Mat_VarWrite(file, variable.get(), compression) != 0) {
    throw std::runtime_error(std::string(name) + ": cannot be written");
  }
}

/// Writes what real files hold in addition to signals: text and numbers in a structure.
void write_structure(mat_t* file, matio_compression compression) {
  std::array<std::size_t, 2> one{1, 1};
  std::array<const char*, 2> fields{"rpm", "note"};
  const std::unique_ptr<matvar_t, Close> structure(
      Mat_VarCreateStruct("about", 2, one.data(), fields.data(), fields.size()));
  double rpm = 1797;
  Mat_VarSetStructFieldByName(
      structure.get(), "rpm", 0,
      Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, one.data(), &rpm, 0));
  std::array<std::size_t, 2> length{1, 4};
  std::string note = "test";
  Mat_VarSetStructFieldByName(
      structure.get(), "note", 0,
      Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, length.data(), note.data(), 0));
  Mat_VarWrite(file, structure.get(), compression);
}

void write_mat(const fs::path& path, mat_ft version, matio_compression compression) {
  const std::unique_ptr<mat_t, Close> file(Mat_CreateVer(path.c_str(), nullptr, version));
  if (!file) throw std::runtime_error(path.string() + ": cannot be made");
  const std::vector<double> values = signal();
  std::vector<std::int16_t> counts(samples);
  for (std::size_t i = 0; i < samples; ++i) counts[i] = static_cast<std::int16_t>(i * 7);
  write_variable(file.get(), "n", MAT_C_INT16, MAT_T_INT16, counts.data(), compression);
  if (version == MAT_FT_MAT5) write_structure(file.get(), compression);
  write_variable(file.get(), "x", MAT_C_DOUBLE, MAT_T_DOUBLE, values.data(), compression);
}

void write_hdf5(const fs::path& path, bool new_format, bool compressed) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, new_format ? H5F_LIBVER_LATEST : H5F_LIBVER_EARLIEST,
                       H5F_LIBVER_LATEST);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  const hsize_t extent = samples;
  const hsize_t chunk = 50;
  const hid_t space = H5Screate_simple(1, &extent, nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  if (compressed) {
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 6);
  }
  const hid_t group = H5Gcreate2(file, "/rig", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const std::vector<double> values = signal();
  for (const char* name : {"/x", "/rig/y"}) {
    const hid_t dataset =
        H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    if (H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
      throw std::runtime_error(path.string() + ": cannot be written");
    }
    H5Dclose(dataset);
  }
  H5Gclose(group);
  H5Pclose(creation);
  H5Sclose(space);
  H5Fclose(file);
  H5Pclose(access);
}

/// Writes two segments with a scaled 16-bit channel and a channel in double precision.
void write_tdms(const fs::path& path, bool is_big, std::uint32_t layout, std::uint64_t size) {
  const piae::tdms::Writer write(is_big);
  const std::vector<std::string> objects{
      write.object("/", write.no_values(), {write.property("name", std::string("run"))}),
      write.object("/'rig'", write.no_values()),
      write.object(
          "/'rig'/'n'", write.index(piae::tdms::int16, samples),
          {write.property("wf_increment", 1 / 12000.0), write.property("NI_Number_Of_Scales", 1U),
           write.property("NI_Scale[0]_Scale_Type", std::string("Linear")),
           write.property("NI_Scale[0]_Linear_Slope", 0.5),
           write.property("NI_Scale[0]_Linear_Y_Intercept", 1.0)}),
      write.object("/'rig'/'x'", write.index(piae::tdms::dbl, samples))};
  std::string counts;
  for (std::size_t i = 0; i < samples; ++i)
    counts += write.number(static_cast<std::int16_t>(i * 7));
  const std::string raw = counts + write.numbers(signal());
  std::ofstream(path, std::ios::binary)
      << write.segment(piae::tdms::new_values | layout, objects, raw)
      << write.segment(piae::tdms::raw_data | layout, {}, raw, size);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const fs::path folder = argv[1];
  try {
    fs::create_directories(folder / "mat");
    fs::create_directories(folder / "hdf5");
    fs::create_directories(folder / "tdms");
    write_mat(folder / "mat/refused-v4.mat", MAT_FT_MAT4, MAT_COMPRESSION_NONE);
    write_mat(folder / "mat/v5.mat", MAT_FT_MAT5, MAT_COMPRESSION_NONE);
    write_mat(folder / "mat/v5-compressed.mat", MAT_FT_MAT5, MAT_COMPRESSION_ZLIB);
    write_mat(folder / "mat/v73.mat", MAT_FT_MAT73, MAT_COMPRESSION_NONE);
    write_hdf5(folder / "hdf5/old.h5", false, false);
    write_hdf5(folder / "hdf5/new.h5", true, false);
    write_hdf5(folder / "hdf5/compressed.h5", false, true);
    write_tdms(folder / "tdms/contiguous.tdms", false, 0, 0);
    write_tdms(folder / "tdms/interleaved.tdms", true, piae::tdms::interleaved, 0);
    write_tdms(folder / "tdms/crashed.tdms", false, 0, piae::tdms::crashed);
  } catch (const std::exception& error) {
    std::cerr << "storm_raw: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
