#include "formats/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "formats/exported_windows.hpp"
#include "raw/file.hpp"
#include "support/folder.hpp"

namespace piae::formats {
namespace {

TEST(ExportedCsv, HasOneLinePerWindow) {
  const std::string expected =
      "dataset,role,method,sample_rate_hz,unit_m_per_s2,window,class_name,defect,defect_size_mm,"
      "shaft_speed_rpm,condition,k_n_per_m,c_ns_per_m,start_angle_rad,parents,strikes_s,x0,x1\n"
      "rig,E,smote,12000,9.80665,0,IR,inner,0.25,900,900 rpm,100000000,500,0,0 3,0 1e-05,0.1,-2\n"
      "rig,E,smote,12000,9.80665,1,IR,inner,0.25,901.5,every,150000000,0.1,1.5,1,,3e-20,4\n"
      "rig,E,smote,12000,9.80665,2,OR,outer,0.5,900,900 rpm,200000000,1,6.25,,0.0025,16777216,-0\n"
      "rig,E,smote,12000,9.80665,3,OR,outer,0.5,900,900 rpm,0,2,3,12,0.00015,0.33333334,1e+05\n";
  EXPECT_EQ(csv(exported_windows()), expected);
}

TEST(ExportedCsv, LabelsHaveTheSameColumnsWithoutSamples) {
  const std::string text = labels_csv(exported_windows());
  EXPECT_EQ(text.find(",x0"), text.npos);
  EXPECT_NE(text.find("\nrig,E,smote,12000,9.80665,3,OR,outer,0.5,900,900 rpm,0,2,3,12,0.00015\n"),
            text.npos);
}

TEST(ExportedCsv, IsReadBackExactlyByTheRecordingReader) {
  const Folder folder;
  const signal::WindowSet windows = four_windows();
  const auto file = folder.write("E.csv", csv(exported_windows()));
  for (std::size_t t = 0; t < 2; ++t) {
    const std::vector<double> column = raw::read_csv(file, "x" + std::to_string(t));
    ASSERT_EQ(column.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto read = static_cast<float>(column[i]);
      EXPECT_EQ(read, windows.window(i)[t]);
      EXPECT_EQ(std::signbit(read), std::signbit(windows.window(i)[t]));
    }
  }
}

}  // namespace
}  // namespace piae::formats
