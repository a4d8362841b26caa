#include "figures/protocols.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

using testing::HasSubstr;
using testing::Not;

class Protocols : public StoredSource {
 protected:
  /// Adds a cell of vae to the blocked run, with 60 percent at 10to1.
  void add_blocked(int seed, signal::Protocol protocol = signal::Protocol::blocked) const {
    scoring::DiagnosisRecord record = diagnosis("vae", "10to1", 45, seed, 12);
    record.protocol = protocol;
    save("diagnosis", record, layout_.blocked().diagnosis("vae", "10to1", seed));
  }
};

TEST_F(Protocols, CompareTheSameCellsOfBothRuns) {
  add_all();  // vae: 75 and 75 at 10to1
  add_blocked(0);
  add_blocked(1);
  Source all = source("none vae", "100to1 10to1 2to1");
  const Numbers numbers = protocols(all);
  EXPECT_EQ(field(numbers, "vae,0,10to1,random,0", 5), "75");
  EXPECT_EQ(field(numbers, "vae,0,10to1,blocked,0", 5), "60");
  EXPECT_EQ(field(numbers, "vae,0,10to1,blocked,mean", 5), "60");
  EXPECT_EQ(field(numbers, "vae,0,10to1,blocked,mean", 6), "") << "an interval of two seeds";
}

TEST_F(Protocols, LeaveOutCellsThatTheOtherRunLacks) {
  add_all();
  add_blocked(1);
  Source all = source("none vae", "100to1 10to1 2to1");
  const Numbers numbers = protocols(all);
  EXPECT_EQ(field(numbers, "vae,0,10to1,random,0", 5), "no row");
  EXPECT_EQ(field(numbers, "vae,0,10to1,random,1", 5), "75");
  EXPECT_THAT(numbers.csv(), Not(HasSubstr("2to1")));
  EXPECT_THAT(numbers.csv(), Not(HasSubstr("none")));
}

TEST_F(Protocols, AreLeftOutWithoutTheOtherRun) {
  add_all();
  Source all = source("none vae", "100to1 10to1");
  EXPECT_THROW(protocols(all), LeftOut);
  EXPECT_ERROR(protocols(all), Exit::input_missing,
               "the run with the other split is missing; run `make contrast`");
}

TEST_F(Protocols, AreTwo) {
  add_all();
  add_blocked(0, signal::Protocol::random);
  Source all = source("none vae", "100to1 10to1", "0");
  EXPECT_ERROR(protocols(all), Exit::bad_input, "run-blocked/cwru: its split is random");
}

}  // namespace
}  // namespace piae::figures
