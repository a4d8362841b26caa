#include "figures/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefact/file.hpp"
#include "support/errors.hpp"
#include "support/stored_run.hpp"

namespace piae::figures {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

Numbers number(const std::string& value) {
  Numbers numbers({"value"});
  numbers.row({value});
  return numbers;
}

Numbers one(Source&) { return number("1"); }
Numbers first_mean(Source&, const report::ClassifierRows& shown) {
  return number(digits(shown.rows.front().summary.mean));
}
Numbers of_paper_alone(Source&, const report::ClassifierRows& shown) {
  if (shown.classifier != scoring::paper_classifier) throw LeftOut("it has no such method");
  return number("1");
}
std::vector<Picture> two(Source&) { return {{"b", number("2")}, {"a", number("1")}}; }
std::vector<Picture> only_a(Source&) { return {{"a", number("3")}}; }
Numbers none(Source&) { throw Error(Exit::input_missing, "there is nothing"); }

Figure figure(const char* name) {
  return {.name = name, .paper = "", .title = "", .caption = "", .from = ""};
}

class FigureFiles : public StoredRun {
 protected:
  [[nodiscard]] fs::path file(const std::string& name) const { return layout_.figure_csv(name); }
  void draw(const std::string& name) const {
    for (const char* const ending : {".svg", ".pdf"}) {
      artefact::write_file_atomically(fs::path(file(name)).replace_extension(ending), {});
    }
  }

  Source source_{layout_, grid_, {}};
  Figure figure_ = figure("fig");
};

TEST_F(FigureFiles, HaveTheNameOfAFigureWithOnePicture) {
  figure_.numbers = one;
  save_pictures(source_, figure_);
  EXPECT_EQ(bytes_of(file("fig")), "value\n1\n");
  EXPECT_THAT(stored_pictures(layout_, figure_), ElementsAre("fig"));
}

TEST_F(FigureFiles, ShowAccuraciesForEachClassifier) {
  add_all();
  figure_.accuracies = first_mean;
  EXPECT_THAT(save_pictures(source_, figure_), ElementsAre(file("fig")));
  for (const int seed : {0, 1}) add(by("wdcnn-envelope", diagnosis("none", "100to1", 0, seed, 18)));
  Source two{layout_, grid_, {}};
  EXPECT_THAT(save_pictures(two, figure_), ElementsAre(file("fig"), file("fig@wdcnn-envelope")));
  EXPECT_EQ(bytes_of(file("fig")), "value\n62.5\n");
  EXPECT_EQ(bytes_of(file("fig@wdcnn-envelope")), "value\n90\n");
  // Data that a classifier lacks affects only its own picture.
  figure_.accuracies = of_paper_alone;
  EXPECT_THAT(save_pictures(two, figure_), ElementsAre(file("fig")));
  EXPECT_THAT(stored_pictures(layout_, figure_), ElementsAre("fig"));
}

/// If no fault is known, a run may have only rules and symptom-net.
TEST_F(FigureFiles, ShowAccuraciesWithoutThePapersClassifier) {
  for (const int seed : {0, 1}) add(by("symptom-net", diagnosis("vae", "10to1", 45, seed, 18)));
  figure_.accuracies = first_mean;
  Source other{layout_, {.dataset = dataset_, .scored = {}, .combinations = {}, .seeds = {}}, {}};
  EXPECT_THAT(save_pictures(other, figure_), ElementsAre(file("fig@symptom-net")));
  figure_.accuracies = of_paper_alone;
  EXPECT_THROW(save_pictures(other, figure_), LeftOut);
}

TEST_F(FigureFiles, AreOneForEachPart) {
  figure_.pictures = two;
  EXPECT_THAT(save_pictures(source_, figure_), ElementsAre(file("fig@b"), file("fig@a")));
  EXPECT_EQ(bytes_of(file("fig@b")), "value\n2\n");
  EXPECT_THAT(stored_pictures(layout_, figure_), ElementsAre("fig@a", "fig@b"));
}

TEST_F(FigureFiles, AreRemovedWithThePicturesOfRemovedParts) {
  figure_.pictures = two;
  save_pictures(source_, figure_);
  draw("fig@a");
  draw("fig@b");
  figure_.pictures = only_a;
  save_pictures(source_, figure_);
  EXPECT_THAT(stored_pictures(layout_, figure_), ElementsAre("fig@a"));
  EXPECT_EQ(bytes_of(file("fig@a")), "value\n3\n");
  EXPECT_TRUE(fs::exists(file("fig@a").replace_extension(".svg")));
  EXPECT_FALSE(fs::exists(file("fig@b").replace_extension(".svg")));
  EXPECT_FALSE(fs::exists(file("fig@b").replace_extension(".pdf")));
}

TEST_F(FigureFiles, AreRemovedIfTheFigureCannotBeMade) {
  figure_.numbers = one;
  save_pictures(source_, figure_);
  draw("fig");
  figure_.numbers = none;
  EXPECT_ERROR(save_pictures(source_, figure_), Exit::input_missing, "there is nothing");
  EXPECT_THAT(stored_pictures(layout_, figure_), IsEmpty());
  EXPECT_FALSE(fs::exists(file("fig").replace_extension(".svg")));
}

TEST_F(FigureFiles, StayForOtherFigures) {
  Figure longer = figure("fig-b");
  longer.numbers = one;
  save_pictures(source_, longer);
  figure_.pictures = two;
  save_pictures(source_, figure_);
  EXPECT_THAT(stored_pictures(layout_, figure_), ElementsAre("fig@a", "fig@b"));
  EXPECT_THAT(stored_pictures(layout_, longer), ElementsAre("fig-b"));
}

TEST_F(FigureFiles, AreNotRewrittenIfUnchanged) {
  figure_.numbers = one;
  save_pictures(source_, figure_);
  const fs::file_time_type old = fs::last_write_time(file("fig")) - std::chrono::hours(1);
  fs::last_write_time(file("fig"), old);
  save_pictures(source_, figure_);
  EXPECT_EQ(fs::last_write_time(file("fig")), old);
}

}  // namespace
}  // namespace piae::figures
