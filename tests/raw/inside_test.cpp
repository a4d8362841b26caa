#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

/// Variables inside structures, cell arrays and matrices.
namespace piae::raw {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

const std::vector<double> first{1.5, -2, 3};
const std::vector<double> second{4, 5, 6};

matvar_t* vector(const char* name, const std::vector<double>& values) {
  std::size_t dims[]{1, values.size()};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims,
                       const_cast<double*>(values.data()), 0);
}

matvar_t* text(const char* name, const std::string& words) {
  std::size_t dims[]{1, words.size()};
  return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dims, const_cast<char*>(words.data()), 0);
}

/// Writes Paderborn's layout, K.Y(2).Data; a structure b.gs, a cell array c, a 2 x 3 matrix data.
fs::path write_nested(const fs::path& path, mat_ft version) {
  mat_t* const file = Mat_CreateVer(path.c_str(), nullptr, version);
  std::size_t one[]{1, 1};
  std::size_t two[]{1, 2};
  const char* fields_of_b[]{"gs", "rate"};
  matvar_t* const b = Mat_VarCreateStruct("b", 2, one, fields_of_b, 2);
  Mat_VarSetStructFieldByName(b, "gs", 0, vector("gs", first));
  Mat_VarSetStructFieldByName(b, "rate", 0, text("rate", "12 kHz"));
  const char* fields_of_y[]{"Name", "Data"};
  matvar_t* const y = Mat_VarCreateStruct("Y", 2, two, fields_of_y, 2);
  Mat_VarSetStructFieldByName(y, "Name", 0, text("Name", "force"));
  Mat_VarSetStructFieldByName(y, "Data", 0, vector("Data", first));
  Mat_VarSetStructFieldByName(y, "Name", 1, text("Name", "vibration_1"));
  Mat_VarSetStructFieldByName(y, "Data", 1, vector("Data", second));
  const char* fields_of_k[]{"Y"};
  matvar_t* const k = Mat_VarCreateStruct("K", 2, one, fields_of_k, 1);
  Mat_VarSetStructFieldByName(k, "Y", 0, y);
  matvar_t* cells[]{vector("", first), vector("", second)};
  matvar_t* const c = Mat_VarCreate("c", MAT_C_CELL, MAT_T_CELL, 2, two, cells, 0);
  const std::vector<double> six{1, 2, 3, 4, 5, 6};
  std::size_t matrix[]{2, 3};
  matvar_t* const data = Mat_VarCreate("data", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, matrix,
                                       const_cast<double*>(six.data()), 0);
  for (matvar_t* const variable : {b, k, c, data}) {
    EXPECT_EQ(Mat_VarWrite(file, variable, MAT_COMPRESSION_ZLIB), 0);
    Mat_VarFree(variable);
  }
  Mat_Close(file);
  return path;
}

class Nested : public testing::TestWithParam<mat_ft> {
 protected:
  [[nodiscard]] std::vector<double> at(const std::string& variable) const {
    return read_mat(file_, variable);
  }
  void expect_refused(const std::string& variable, const std::string& why) const {
    EXPECT_ERROR(at(variable), Exit::bad_input, "a.mat: " + why);
  }

  Folder folder_;
  fs::path file_ = write_nested(folder_ / "a.mat", GetParam());
};

TEST_P(Nested, VariablesAreRead) {
  EXPECT_EQ(at("b.gs"), first);
  EXPECT_EQ(at("K.Y(2).Data"), second);
  EXPECT_EQ(at("K.Y[Name=vibration_1].Data"), second);
  EXPECT_EQ(at("K.Y[Name=force].Data"), first);
  EXPECT_EQ(at("c{2}"), second);
  EXPECT_EQ(at("c(1)"), first);
}

TEST_P(Nested, RowsAndColumnsAreRead) {  // MATLAB's order: 1 and 2 are the first column
  EXPECT_THAT(at("data(2,:)"), ElementsAre(2, 4, 6));
  EXPECT_THAT(at("data(:,3)"), ElementsAre(5, 6));
  EXPECT_THAT(at("b.gs(1,:)"), ElementsAre(1.5, -2, 3));
}

TEST_P(Nested, UnsupportedVariablesAreRefusedWithTheirType) {
  expect_refused("b", "variable b is a structure with the fields gs, rate; name one of them: b.gs");
  expect_refused("b.rate", "variable b.rate does not hold numbers, but text");
  expect_refused("b.g", "variable b has no field g; it has gs, rate");
  expect_refused("b.gs.x", "variable b.gs is neither a structure nor a cell array");
  expect_refused("K.Y",
                 "variable K.Y is an array of 2 structures; name one of them: K.Y(1), or "
                 "K.Y[Name=force], K.Y[Name=vibration_1]");
  expect_refused("K.Y.Data", "variable K.Y is an array of 2 structures");
  expect_refused("K.Y(3).Data", "variable K.Y has 2 elements; number 3 does not exist");
  expect_refused("K.Y(2)", "variable K.Y(2) is a structure with the fields ");
  expect_refused(
      "K.Y[Name=x].Data",
      "variable K.Y has no element whose Name is x; name one by its number, or K.Y[Name=");
  expect_refused("c", "variable c is a cell array of 2; name one of them: c{1}");
  expect_refused(
      "data", "variable data is not a vector, but a matrix of 2 x 3; name a row of it: data(1,:)");
  expect_refused("data(3,:)", "variable data has 2 rows; number 3 does not exist");
  expect_refused("data(2,3)",
                 "variable data holds numbers, and (2,3) is only one of them; name a row data(1,:) "
                 "or a column data(:,1)");
  for (const char* variable : {"data(0,:)", "data[0,:]", "data(1:2,:)", "c{0}"}) {
    expect_refused(variable, std::string("has no variable ") + variable + "; it has ");
    EXPECT_ERROR(at(variable), Exit::bad_input,
                 "; write a row as data(1,:), a column as data(:,1), an element as c{1} or s(1).x, "
                 "counted from 1");
  }
  expect_refused("nothing.gs", "has no variable nothing; it has ");
}

INSTANTIATE_TEST_SUITE_P(Versions, Nested, testing::Values(MAT_FT_MAT5, MAT_FT_MAT73),
                         [](const auto& info) { return info.param == MAT_FT_MAT5 ? "v5" : "v73"; });

/// Writes an array of four structures, two of which have the same Name.
fs::path write_namesakes(const fs::path& path, mat_ft version) {
  mat_t* const file = Mat_CreateVer(path.c_str(), nullptr, version);
  std::size_t four[]{1, 4};
  const char* fields[]{"Name", "Data"};
  matvar_t* const y = Mat_VarCreateStruct("Y", 2, four, fields, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    Mat_VarSetStructFieldByName(
        y, "Name", i, text("Name", i % 2 == 1 ? "vibration" : "speed" + std::to_string(i)));
    Mat_VarSetStructFieldByName(y, "Data", i, vector("Data", i == 3 ? second : first));
  }
  EXPECT_EQ(Mat_VarWrite(file, y, MAT_COMPRESSION_NONE), 0);
  Mat_VarFree(y);
  Mat_Close(file);
  return path;
}

/// Uses cells and structures in rows and columns, which MATLAB stores column by column.
TEST(Elements, CanBeNamedByRowAndColumn) {
  const Folder folder;
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    mat_t* const file = Mat_CreateVer((folder / "a.mat").c_str(), nullptr, version);
    std::size_t dims[]{2, 3};
    const char* fields[]{"d"};
    matvar_t* const sa = Mat_VarCreateStruct("sa", 2, dims, fields, 1);
    std::vector<matvar_t*> cells;
    for (std::size_t i = 0; i < 6; ++i) {
      const double number = static_cast<double>(i) + 1;
      Mat_VarSetStructFieldByName(sa, "d", i, vector("d", {number, -number}));
      cells.push_back(vector("", {number, -number}));
    }
    matvar_t* const c = Mat_VarCreate("c", MAT_C_CELL, MAT_T_CELL, 2, dims, cells.data(), 0);
    for (matvar_t* const variable : {sa, c}) {
      EXPECT_EQ(Mat_VarWrite(file, variable, MAT_COMPRESSION_NONE), 0);
      Mat_VarFree(variable);
    }
    Mat_Close(file);
    const auto at = [&](const std::string& variable) {
      return read_mat(folder / "a.mat", variable);
    };
    EXPECT_THAT(at("sa(2,1).d"), ElementsAre(2, -2));
    EXPECT_THAT(at("sa(1,3).d"), ElementsAre(5, -5));
    EXPECT_THAT(at("sa(5).d"), ElementsAre(5, -5));
    EXPECT_THAT(at("c{2,3}"), ElementsAre(6, -6));
    EXPECT_THAT(at("c(1,2)"), ElementsAre(3, -3));
    EXPECT_ERROR(at("sa(3,1).d"), Exit::bad_input,
                 "variable sa is an array of 2 x 3, which has no element (3,1)");
    EXPECT_ERROR(at("sa(2,3)"), Exit::bad_input,
                 "variable sa(2,3) is a structure with the fields d; name one of them: sa(2,3).d");
    EXPECT_ERROR(at("c{1,2}.x"), Exit::bad_input, "variable c{1,2} ");
  }
}

TEST(Namesakes, AreRefusedWithNumbersAmongElements) {
  const Folder folder;
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    const fs::path file = write_namesakes(folder / "a.mat", version);
    EXPECT_ERROR(read_mat(file, "Y[Name=vibration].Data"), Exit::bad_input,
                 "a.mat: variable Y has 2 elements whose Name is vibration: Y(2), Y(4); name one "
                 "of these");
    EXPECT_EQ(read_mat(file, "Y(4).Data"), second);
    EXPECT_EQ(read_mat(file, "Y[Name=speed2].Data"), first);
  }
}

TEST(Namesakes, AreRefusedAmongVariables) {
  const Folder folder;
  for (const auto compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    std::string bytes;
    for (const auto& [name, values] :
         {std::pair("x", first), std::pair("y", first), std::pair("x", second)}) {
      mat_t* const file = Mat_CreateVer((folder / "one.mat").c_str(), nullptr, MAT_FT_MAT5);
      matvar_t* const variable = vector(name, values);
      EXPECT_EQ(Mat_VarWrite(file, variable, compression), 0);
      Mat_VarFree(variable);
      Mat_Close(file);
      const std::string one = bytes_of(folder / "one.mat");
      constexpr std::size_t header = 128;
      bytes += bytes.empty() ? one : one.substr(header);
    }
    const fs::path file = folder.write("a.mat", bytes);
    EXPECT_ERROR(read_mat(file, "x"), Exit::bad_input,
                 "a.mat: has 2 variables named x, and programs");
    EXPECT_EQ(read_mat(file, "y"), first);
  }
}

TEST(Namesakes, AreRefusedAmongFields) {
  const Folder folder;
  mat_t* const file = Mat_CreateVer((folder / "a.mat").c_str(), nullptr, MAT_FT_MAT5);
  std::size_t one[]{1, 1};
  const char* fields[]{"x", "y", "x"};
  matvar_t* const b = Mat_VarCreateStruct("b", 2, one, fields, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    Mat_VarSetStructFieldByIndex(b, i, 0, vector(fields[i], i < 2 ? first : second));
  }
  EXPECT_EQ(Mat_VarWrite(file, b, MAT_COMPRESSION_NONE), 0);
  Mat_VarFree(b);
  Mat_Close(file);
  EXPECT_ERROR(read_mat(folder / "a.mat", "b.x"), Exit::bad_input,
               "a.mat: variable b has 2 fields named x, and programs");
  EXPECT_EQ(read_mat(folder / "a.mat", "b.y"), first);
}

/// Writes an HDF5 file with a 2 x 3 dataset and links to it.
fs::path write_links(const fs::path& path) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t extents[]{2, 3};
  const std::vector<float> six{1, 2, 3, 4, 5, 6};
  const hid_t space = H5Screate_simple(2, extents, nullptr);
  const hid_t group = H5Gcreate2(file, "sensor", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t set =
      H5Dcreate2(group, "accel", H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(H5Dwrite(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, six.data()), 0);
  H5Lcreate_soft("/sensor/accel", file, "link", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("sensor", file, "group", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/round", file, "round", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/nowhere", file, "broken", H5P_DEFAULT, H5P_DEFAULT);
  for (const auto& [id, close] : std::vector<std::pair<hid_t, herr_t (*)(hid_t)>>{
           {set, H5Dclose}, {group, H5Gclose}, {space, H5Sclose}, {file, H5Fclose}}) {
    close(id);
  }
  return path;
}

TEST(Hdf5, ReadsRowsAndColumnsInPythonOrderFrom1) {
  const Folder folder;
  const fs::path file = write_links(folder / "a.h5");
  EXPECT_THAT(read_hdf5(file, "sensor/accel(2,:)"), ElementsAre(4, 5, 6));
  EXPECT_THAT(read_hdf5(file, "/sensor/accel(:,1)"), ElementsAre(1, 4));
  EXPECT_ERROR(read_hdf5(file, "sensor/accel"), Exit::bad_input,
               "dataset /sensor/accel is not a vector, but a matrix of 2 x 3; name a row of it: "
               "/sensor/accel(1,:)");
}

TEST(Hdf5, FollowsSoftLinksWithinTheFile) {
  const Folder folder;
  const fs::path file = write_links(folder / "a.h5");
  EXPECT_THAT(read_hdf5(file, "link(1,:)"), ElementsAre(1, 2, 3));
  EXPECT_THAT(read_hdf5(file, "group/accel(1,:)"), ElementsAre(1, 2, 3));
  EXPECT_ERROR(read_hdf5(file, "round"), Exit::bad_input,
               "a.h5: /round leads in a circle of soft links; name the dataset itself");
  EXPECT_ERROR(read_hdf5(file, "broken"), Exit::bad_input, "a.h5: has no dataset /broken");
}

}  // namespace
}  // namespace piae::raw
