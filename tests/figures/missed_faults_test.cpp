#include "figures/missed_faults.hpp"

#include "figures/diagnosed_windows.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

using MissedFaults = DiagnosedWindows;

TEST_F(MissedFaults, CountFaultsClassifiedAsHealthy) {
  add_two_seeds();
  Source two = source("vae", "10to1 2to1");
  const Numbers numbers = missed_faults(two);
  EXPECT_EQ(field(numbers, "vae,0,2to1,fault,IR,0", 6), "50");
  EXPECT_EQ(field(numbers, "vae,0,2to1,fault,IR,1", 6), "0");
  EXPECT_EQ(field(numbers, "vae,0,2to1,fault,IR,mean", 6), "25");
  EXPECT_EQ(field(numbers, "vae,0,2to1,fault,OR,0", 6), "0") << "taken for another fault";
  EXPECT_EQ(field(numbers, "vae,0,2to1,all-faults,,0", 6), "25");
  EXPECT_EQ(field(numbers, "vae,0,2to1,all-faults,,mean", 6), "12.5");
}

TEST_F(MissedFaults, IncludeHealthyWindowsClassifiedAsAFault) {
  add_two_seeds();
  Source two = source("vae", "10to1 2to1");
  const Numbers numbers = missed_faults(two);
  EXPECT_EQ(field(numbers, "vae,0,2to1,healthy,,0", 6), "0");
  EXPECT_EQ(field(numbers, "vae,0,2to1,healthy,,1", 6), "50");
  EXPECT_EQ(field(numbers, "vae,0,2to1,healthy,,mean", 6), "25");
}

TEST_F(MissedFaults, OmitAClassWithoutTestWindows) {
  add(record_of("vae", "2to1", 145, 0, {0, 1}, {0, 1}));
  Source one = source("vae", "2to1", "0");
  EXPECT_EQ(field(missed_faults(one), "vae,0,2to1,fault,OR,mean", 6), "no row");
}

TEST_F(MissedFaults, NameAMissingDiagnosis) {
  add_two_seeds();
  Source three = source("vae", "2to1", "0 1 2");
  EXPECT_ERROR(missed_faults(three), Exit::input_missing, "seed2/vae/2to1/wdcnn/diagnosis.h5");
}

}  // namespace
}  // namespace piae::figures
