#include "diagnosis/catalogue.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"
#include "signal/ranges.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

TEST(Classifiers, StartWithThePapersAndIncludeTheBaseline) {
  EXPECT_STREQ(classifiers().front().name, scoring::paper_classifier);
  EXPECT_NE(find_classifier(reference_classifier), nullptr);
}

// Names are folders next to those of ratios, words of make, and lines of tables.
TEST(Classifiers, HaveUniqueNamesAndDescriptions) {
  std::set<std::string> names;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) names.insert(ratio.name);
  for (const Classifier& each : classifiers()) {
    EXPECT_TRUE(names.insert(each.name).second) << each.name;
    EXPECT_TRUE(signal::ranges::is_plain_name(each.name)) << each.name;
    EXPECT_NE(std::string(each.what), "") << each.name;
    EXPECT_NE(std::string(each.input), "") << each.name;
  }
}

TEST(Classifiers, AreTrainedExceptNearestTheRulesAndWhatWasTaughtBefore) {
  for (const Classifier& each : classifiers()) {
    const bool is_rule = std::string(each.name).ends_with("-rule") || each.fit != nullptr;
    EXPECT_EQ(each.rule, is_rule) << each.name;
    EXPECT_EQ(each.trains(), !std::string(each.name).starts_with("nearest") && !is_rule)
        << each.name;
  }
}

TEST(Classifiers, HaveExactlyOneWayToPredict) {
  for (const Classifier& each : classifiers()) {
    EXPECT_EQ((each.represent != nullptr) + (each.learn != nullptr) + (each.fit != nullptr), 1)
        << each.name;
    EXPECT_EQ(each.represent != nullptr, each.read == nullptr) << each.name;
  }
}

TEST(Classifiers, AreFoundByName) {
  ASSERT_NE(find_classifier("wdcnn-spectra"), nullptr);
  EXPECT_STREQ(find_classifier("wdcnn-spectra")->name, "wdcnn-spectra");
  EXPECT_EQ(find_classifier("wdcnn-"), nullptr);
  EXPECT_STREQ(the_classifier("nearest").name, "nearest");
  EXPECT_ERROR(the_classifier("svm"), Exit::usage,
               "unknown classifier 'svm'; known: wdcnn, wdcnn-spectrum, wdcnn-envelope, "
               "wdcnn-spectra, nearest, envelope-rule, exclusion-rule, symptom-net, wdcnn-orders, "
               "nearest-orders, prototypes, any-bearing, dann, cdan");
}

TEST(Classifiers, ThatAdaptAreMarked) {
  for (const Classifier& each : classifiers()) {
    const std::string name = each.name;
    EXPECT_EQ(marked_name(name), name == "dann" || name == "cdan" ? name + " (sees D)" : name);
  }
  EXPECT_EQ(marked_name("smote"), "smote");
}

}  // namespace
}  // namespace piae::diagnosis
