#include "report/identifiability.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;

/// Two windows of each of two classes. The inferred damping is 10 % too high, the stiffness random.
Identification identification(std::int64_t seed) {
  Identification one{.method = "piae-dt", .seed = seed, .windows = {}, .inferred = {}};
  one.windows.info.name = "example";
  one.windows.info.classes = {{"Normal", signal::Defect::none, 0},
                              {"IR", signal::Defect::inner, 0.2},
                              {"OR", signal::Defect::outer, 0.2}};
  one.windows.labels = {1, 1, 2, 2};
  one.windows.length = 1;
  one.windows.samples = {0, 0, 0, 0};
  one.windows.parameters = {{1e8, 100}, {2e8, 200}, {3e8, 300}, {4e8, 400}};
  for (const auto& p : one.windows.parameters) {
    one.inferred.push_back({2.5e8, 1.1 * p.damping_ns_per_m});
  }
  return one;
}

TEST(Identifiability, CoversAllWindowsAndEachClass) {
  const auto rows = identifiability_rows({identification(0), identification(1)});
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0].class_name, "all");
  EXPECT_DOUBLE_EQ(rows[0].r2.mean, 0);  // the true mean for every window
  EXPECT_EQ(rows[0].r2.count, 2U);
  EXPECT_EQ(rows[4].parameter, "damping");
  EXPECT_EQ(rows[4].class_name, "IR");
  // Errors 10 and 20, deviations 50 and 50.
  EXPECT_NEAR(rows[4].r2.mean, 1 - 500 / 5000.0, 1e-12);
  EXPECT_NEAR(rows[4].bias.mean, 0.1, 1e-12);
  EXPECT_NEAR(rows[4].correlation2.mean, 1, 1e-12);
}

TEST(Identifiability, IsWrittenAsCsv) {
  const std::vector<Identification> all{identification(0)};
  const std::string csv = identifiability_csv("example", identifiability_rows(all));
  EXPECT_THAT(csv, HasSubstr("\nexample,piae-dt,damping,IR,1,0.9000,,0.1000,,1.0000,\n"));
  EXPECT_THAT(scatter_csv("example", all),
              HasSubstr("\nexample,piae-dt,stiffness,1e+08,1e+08,1,2.5e+08,2.5e+08,2.5e+08\n"));
}

TEST(Identifiability, IsShownInTables) {
  const std::vector<Identification> all{identification(0), identification(1)};
  const std::string text =
      markdown(identifiability_document("example", identifiability_rows(all), all));
  EXPECT_THAT(text, HasSubstr("2 seeds (0, 1)."));
  EXPECT_THAT(text, HasSubstr("| piae-dt | stiffness | all   |  0.000 ± 0.000 |"));
  EXPECT_THAT(text, HasSubstr("## Scatter of stiffness, MN/m"));
}

TEST(Identifiability, ListsTheSeedsOfEachMethod) {
  std::vector<Identification> all{identification(0), identification(1), identification(4)};
  all.push_back(identification(1));
  all.back().method = "ae";
  const std::string text =
      markdown(identifiability_document("example", identifiability_rows(all), all));
  EXPECT_THAT(text, HasSubstr("piae-dt: 3 seeds (0, 1, 4), ae: 1 seed (1)."));
}

TEST(Identifiability, NeedsTrueValues) {
  Identification without = identification(0);
  without.windows.parameters.clear();
  EXPECT_THAT([&] { identifiability_rows({without}); },
              testing::ThrowsMessage<Error>(HasSubstr("are not known")));
  Identification constant = identification(0);
  constant.windows.parameters.assign(4, {1e8, 100});
  EXPECT_THAT([&] { identifiability_rows({constant}); },
              testing::ThrowsMessage<Error>(HasSubstr("does not vary")));
}

}  // namespace
}  // namespace piae::report
