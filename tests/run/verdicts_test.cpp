#include "run/verdicts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/stored_verdicts.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::run {
namespace {

const Combination by_nearest{"none", "100to1", "nearest"};

TEST(Verdicts, AreRightIfTheFaultIsNamed) {
  const Folder folder;
  const Layout layout(folder.path(), "toys");
  store_verdicts(layout, 0, {0, 1, 2, 2});
  store_verdicts(layout, 1, {1, 0, 0, 0});  // the healthy record is wrong, too
  const Verdicts verdicts = read_verdicts(layout, by_nearest, 0);
  EXPECT_EQ(verdicts.protocol, signal::Protocol::random);
  ASSERT_EQ(verdicts.records.size(), 4U);
  EXPECT_FALSE(verdicts.is_faulty(verdicts.records[0]));
  EXPECT_TRUE(verdicts.is_faulty(verdicts.records[3]));
  EXPECT_EQ(verdicts.count_right_faults(), 2U);
  EXPECT_EQ(read_verdicts(layout, by_nearest, 1).count_right_faults(), 0U);
}

TEST(Verdicts, AreRefusedIfMadeByAnotherClassifier) {
  const Folder folder;
  const Layout layout(folder.path(), "toys");
  store_verdicts(layout, 0, {0, 1, 2, 2});
  artefact::Writer("classifier")
      .save(layout.kept_classifier("none", "100to1", 0, "nearest"), {"test", "", {}});
  EXPECT_ERROR(read_verdicts(layout, by_nearest, 0), Exit::bad_input,
               "classification.h5: / was not made by ");
}

}  // namespace
}  // namespace piae::run
