#include "run/grid.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "support/command_line.hpp"

namespace piae::run {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Strings = std::vector<std::string>;

Strings cells(const Grid& grid) {
  Strings cells;
  for (const Combination& c : grid.combinations) cells.push_back(c.method + " " + c.ratio);
  return cells;
}

void expect_usage_error(const GridOptions& options, const std::string& what) {
  try {
    resolve(options);
    ADD_FAILURE() << "not refused: " << what;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_THAT(error.what(), HasSubstr(what));
  }
}

TEST(Grid, HasNoneAt100to1AndOtherMethodsAtOtherRatios) {
  const Grid grid = resolve(
      {"cwru", {"vae", "none", "smote", "oracle"}, {"1to1", "100to1", "10to1"}, {"10", "2", "0"}});
  EXPECT_THAT(cells(grid), ElementsAre("vae 10to1", "vae 1to1", "none 100to1", "smote 10to1",
                                       "smote 1to1", "oracle 10to1", "oracle 1to1"));
  EXPECT_THAT(grid.scored, ElementsAre("vae", "smote"));
  EXPECT_THAT(grid.seeds, ElementsAre(0, 2, 10));
  EXPECT_EQ(grid.dataset, "cwru");
}

TEST(Grid, AcceptsListsAsOneWord) {
  const Grid grid = resolve({"cwru", {"none piae-dt"}, {"100to1,10to1", "1to1"}, {" 0, 1  2 "}});
  EXPECT_THAT(cells(grid), ElementsAre("none 100to1", "piae-dt 10to1", "piae-dt 1to1"));
  EXPECT_THAT(grid.seeds, ElementsAre(0, 1, 2));
}

TEST(Grid, AcceptsSeveralValuesAfterOneOption) {
  GridOptions options;
  cli::parse("--dataset cwru --methods none piae-dt --ratios 100to1 --seeds 0 1 2",
             [&](const cli::Options& command) { bind(command, options); });
  EXPECT_EQ(options.dataset, "cwru");
  EXPECT_EQ(options.methods, (Strings{"none", "piae-dt"}));
  EXPECT_EQ(options.ratios, Strings{"100to1"});
  EXPECT_EQ(options.seeds, (Strings{"0", "1", "2"}));
}

const augment::CatalogueEntry none{.name = "none", .kind = augment::Kind::baseline, .what = ""};
const augment::CatalogueEntry learns{
    .name = "learns", .kind = augment::Kind::published, .what = ""};
const augment::CatalogueEntry invents{
    .name = "invents", .kind = augment::Kind::ours, .what = "", .without_known = true};
const augment::CatalogueEntry ceiling{
    .name = "ceiling", .kind = augment::Kind::ceiling, .what = ""};
const diagnosis::Classifier network{.name = "network", .what = "", .input = ""};
const diagnosis::Classifier rule{.name = "rule", .what = "", .input = "", .rule = true};

TEST(Grid, CombinesRulesOnlyWithNone) {
  for (const bool nothing_known : {false, true}) {
    EXPECT_TRUE(go_together(none, rule, nothing_known));
    for (const augment::CatalogueEntry& method : {learns, invents, ceiling}) {
      EXPECT_FALSE(go_together(method, rule, nothing_known)) << method.name;
    }
  }
}

TEST(Grid, NeedsMethodsWithoutKnownWindowsIfNothingIsKnown) {
  for (const augment::CatalogueEntry& method : {none, learns, invents, ceiling}) {
    EXPECT_TRUE(go_together(method, network, false)) << method.name;
  }
  EXPECT_FALSE(go_together(none, network, true));
  EXPECT_FALSE(go_together(learns, network, true));
  EXPECT_TRUE(go_together(invents, network, true));
  EXPECT_TRUE(go_together(ceiling, network, true));
  EXPECT_FALSE(go_together("not in the catalogue", "wdcnn", true));
  EXPECT_TRUE(go_together("not in the catalogue", "wdcnn", false));
}

TEST(Grid, HasNeitherNoneNorItsNearestIfNothingIsKnown) {
  GridOptions options{"rig", {"none smote oracle"}, {"100to1 10to1"}, {"0"}, {"wdcnn nearest"}};
  EXPECT_THAT(cells(resolve(options)), ElementsAre("none 100to1", "smote 10to1", "oracle 10to1",
                                                   "none 100to1", "smote 10to1", "oracle 10to1"));
  options.nothing_known = {"another", "rig"};
  const Grid grid = resolve(options);
  EXPECT_THAT(cells(grid), ElementsAre("oracle 10to1", "oracle 10to1"));
  EXPECT_EQ(grid.combinations.back().classifier, "nearest");
  EXPECT_TRUE(grid.scored.empty());
  options.methods = {"none smote"};
  expect_usage_error(options, "without known fault windows there are only 'none' by rules and");
  options.nothing_known = {"another"};
  EXPECT_EQ(resolve(options).combinations.size(), 4U);
}

TEST(Grid, RefusesInvalidMethodsRatiosAndSeeds) {
  expect_usage_error({"cwru", {"none"}, {"3to1"}, {"0"}}, "unknown ratio '3to1'");
  expect_usage_error({"cwru", {"none"}, {"10to1"}, {"0"}}, "cannot be combined");
  expect_usage_error({"cwru", {"vae"}, {"100to1"}, {"0"}}, "cannot be combined");
  expect_usage_error({"cwru", {"none"}, {"100to1"}, {"0 1 0"}}, "--seeds names 0 twice");
  expect_usage_error({"cwru", {"none"}, {"100to1"}, {"00 0"}}, "--seeds names 0 twice");
  expect_usage_error({"cwru", {"vae", "vae"}, {"1to1"}, {"0"}}, "--methods names vae twice");
  expect_usage_error({"cwru", {" "}, {"1to1"}, {"0"}}, "--methods is empty");
  for (const char* seed : {"-1", "x", "1.5", "99999999999999999999"}) {
    expect_usage_error({"cwru", {"none"}, {"100to1"}, {seed}}, "is not a seed");
  }
}

}  // namespace
}  // namespace piae::run
