#include "figures/twin_space.hpp"

#include "figures/stored_source.hpp"
#include "signal/window_set.hpp"
#include "twin/space.hpp"

namespace piae::figures {
namespace {

class TwinSpaceFigure : public StoredSource {
 protected:
  /// Adds two known windows at (1, 2) and (3, 6) without units, and one generated window of each
  /// class.
  void add_model(bool simulated) const {
    artefact::Writer model("model");
    write(model, three_classes("cwru"));
    twin::TwinSpace({{1, 2}, {3, 6}}, 2).write(model);
    model.save(layout_.model("piae-dt", 0), {"train", "", {}});
    save("windows", windows({1, 2}, {{2e8, 300}, {4e8, 500}}),
         layout_.generated_windows("piae-dt", 0));
    save("windows", windows({1, 2}, simulated ? both_true : none_true), layout_.known_windows(0));
  }

  using Parameters = std::vector<signal::DynamicParameters>;
  const Parameters both_true{{1e8, 250}, {3e8, 650}};
  const Parameters none_true{};

  static signal::WindowSet windows(const std::vector<Label>& labels, const Parameters& parameters) {
    signal::WindowSet set;
    set.info = three_classes("cwru");
    set.length = 4;
    set.labels = labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      set.samples.insert(set.samples.end(), {1, 2, 1, 2});
    }
    set.parameters = parameters;
    return set;
  }
  static void save(const std::string& kind, const signal::WindowSet& set,
                   const std::filesystem::path& path) {
    artefact::Writer writer(kind);
    write(writer, set);
    writer.save(path, {"test", "", {}});
  }
};

TEST_F(TwinSpaceFigure, HasTheJointHistogramAndItsMarginalsInUnits) {
  add_model(false);
  Source one = source("piae-dt", "10to1", "0");
  const Numbers space = twin_space(one);
  EXPECT_EQ(field(space, "piae-dt,bin,,1e+08,200,2e+08,400", 7), "1");
  EXPECT_EQ(field(space, "piae-dt,bin,,1e+08,400,2e+08,600", 7), "0");
  EXPECT_EQ(field(space, "piae-dt,bin,,2e+08,400,3e+08,600", 7), "1");
  EXPECT_EQ(field(space, "piae-dt,k-bin,,1e+08,200,2e+08,600", 7), "1");
  EXPECT_EQ(field(space, "piae-dt,c-bin,,1e+08,400,3e+08,600", 7), "1");
}

TEST_F(TwinSpaceFigure, ShowsKnownGeneratedAndTrueValues) {
  add_model(true);
  Source one = source("piae-dt", "10to1", "0");
  const std::string first = three_classes("cwru").classes[1].name;
  const Numbers space = twin_space(one);
  EXPECT_EQ(field(space, "piae-dt,known," + first, 4), "200");
  EXPECT_EQ(field(space, "piae-dt,generated," + first, 3), "2e+08");
  EXPECT_EQ(field(space, "piae-dt,true," + first, 4), "250");
}

TEST_F(TwinSpaceFigure, IsLeftOutIfNoMethodInfers) {
  Source one = source("smote of-another-program", "10to1", "0");
  EXPECT_THROW((void)one.inferring_methods(), LeftOut);
}

}  // namespace
}  // namespace piae::figures
