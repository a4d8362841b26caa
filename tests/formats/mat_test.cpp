#include "formats/mat.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <cstring>
#include <memory>

#include "formats/exported_windows.hpp"
#include "raw/file.hpp"
#include "support/folder.hpp"

namespace piae::formats {
namespace {

using testing::ElementsAre;

struct CloseMat {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, CloseMat>;

/// Reads a variable with libmatio, an independent implementation.
Variable read_variable(const std::filesystem::path& path, const char* name) {
  const std::unique_ptr<mat_t, CloseMat> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  EXPECT_NE(file, nullptr);
  Variable variable(Mat_VarRead(file.get(), name));
  EXPECT_NE(variable, nullptr) << name;
  return variable;
}

std::vector<double> doubles_of(const matvar_t& variable) {
  const auto* first = static_cast<const double*>(variable.data);
  return {first, first + variable.nbytes / sizeof(double)};
}

std::string text_of(const matvar_t& variable) {
  const auto* units = static_cast<const std::uint16_t*>(variable.data);
  return {units, units + variable.dims[1]};
}

struct ExportedMat : testing::Test {
  ExportedMat() : file(folder.write("E.mat", mat(exported_windows()))) {}
  Folder folder;
  std::filesystem::path file;
};

TEST_F(ExportedMat, HoldsTheSamplesAsSingles) {
  const Variable windows = read_variable(file, "windows");
  EXPECT_EQ(windows->class_type, MAT_C_SINGLE);
  ASSERT_EQ(windows->rank, 2);
  EXPECT_EQ(windows->dims[0], 4U);
  EXPECT_EQ(windows->dims[1], 2U);
  const auto* samples = static_cast<const float*>(windows->data);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t t = 0; t < 2; ++t) EXPECT_EQ(samples[4 * t + i], four_windows().window(i)[t]);
  }
}

TEST_F(ExportedMat, HoldsNumbersAndListsAndTexts) {
  EXPECT_THAT(doubles_of(*read_variable(file, "k_n_per_m")), ElementsAre(1e8, 1.5e8, 2e8, 0));
  EXPECT_EQ(read_variable(file, "k_n_per_m")->dims[0], 4U);
  EXPECT_THAT(doubles_of(*read_variable(file, "unit_m_per_s2")), ElementsAre(9.80665));
  const Variable names = read_variable(file, "class_name");
  ASSERT_EQ(names->class_type, MAT_C_CELL);
  EXPECT_EQ(text_of(*static_cast<matvar_t**>(names->data)[3]), "OR");
  const Variable parents = read_variable(file, "parents");
  ASSERT_EQ(parents->class_type, MAT_C_CELL);
  EXPECT_THAT(doubles_of(*static_cast<matvar_t**>(parents->data)[0]), ElementsAre(0, 3));
  EXPECT_EQ(static_cast<matvar_t**>(parents->data)[2]->dims[1], 0U);
  EXPECT_EQ(text_of(*read_variable(file, "method")), "smote");
}

TEST_F(ExportedMat, IsReadByTheRecordingReader) {
  EXPECT_THAT(raw::read_mat(file, "start_angle_rad"), ElementsAre(0, 1.5, 6.25, 3));
  const auto one = folder.write("one.mat", mat(select(four_windows(), {"IR"}, 1)));
  EXPECT_THAT(raw::read_mat(one, "windows"), ElementsAre(0.1F, -2));
}

}  // namespace
}  // namespace piae::formats
