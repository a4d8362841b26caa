#include "augment/catalogue.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <set>

#include "augment/methods.hpp"
#include "support/errors.hpp"
#include "support/three_classes.hpp"

namespace piae::augment {
namespace {

using testing::ElementsAre;

std::vector<std::string> names_of(const std::function<bool(const CatalogueEntry&)>& chosen) {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue()) {
    if (chosen(entry)) names.emplace_back(entry.name);
  }
  return names;
}

TEST(Catalogue, HasEveryNameOnce) {
  const std::vector<std::string> all = names_of([](const auto&) { return true; });
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
  for (const std::string& name : all) EXPECT_EQ(find_entry(name)->name, name);
  EXPECT_EQ(find_entry("another"), nullptr);
}

TEST(Catalogue, NumbersThePapersFiveModelsInTheirOrder) {
  std::vector<int> models;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.model > 0) models.push_back(entry.model);
  }
  EXPECT_THAT(models, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_EQ(names_of([](const auto& entry) { return entry.kind == Kind::ablation; }),
            names_of([](const auto& entry) { return entry.model > 1; }));
}

TEST(Catalogue, MarksTheAblationsOfThePaperAndOfItsOutlook) {
  EXPECT_THAT(names_of(is_ablation), ElementsAre("ae", "physics", "piae-dt-cnn", "piae-dt-rnn",
                                                 "piae-dt-tcn", "piae-dt-transformer"));
}

TEST(Catalogue, HasOneBaselineThatGeneratesNothing) {
  EXPECT_THAT(names_of([](const auto& entry) { return entry.kind == Kind::baseline; }),
              ElementsAre(no_method));
  EXPECT_THAT(names_of([](const auto& entry) { return entry.make == nullptr; }),
              ElementsAre(no_method));
}

TEST(Catalogue, MarksMethodsThatInferStiffnessAndDamping) {
  artefact::Writer writer("model");
  writer.attribute("/", "method", std::string("any"));
  writer.save(scratch_file("empty.h5"), {});
  const artefact::Reader model(scratch_file("empty.h5"), "model");
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.make == nullptr) continue;
    // Methods that can infer fail differently, on the empty model.
    std::string refusal;
    try {
      (void)entry.make()->infer(model, known_windows(), {});
    } catch (const std::exception& error) {
      refusal = error.what();
    }
    EXPECT_NE(refusal, "") << entry.name;
    EXPECT_EQ(refusal.find("infers neither") == std::string::npos, entry.infers) << refusal;
  }
}

/// Only training by epochs checks for interruption. The windows are longer than a turn of the
/// shaft, as piae-dt-phase needs.
TEST(Catalogue, MarksMethodsTrainedInEpochs) {
  nets::Checkpoint stopped = checkpoint_at("cut");
  stopped.interrupted = [] { return true; };
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.make == nullptr) continue;
    bool in_epochs = false;
    try {
      train(entry.name, "", known_windows(512), stopped, "model.h5");
    } catch (const Error& error) {
      in_epochs = error.exit() == Exit::interrupted;
    }
    EXPECT_EQ(in_epochs, entry.trains) << entry.name;
    std::filesystem::remove(stopped.path);
  }
}

TEST(Catalogue, MarksMethodsThatWorkWithoutKnownWindows) {
  signal::WindowSet none;
  none.info = known_windows().info;
  none.length = known_windows().length;
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_NO_THROW(require_known_windows(entry, known_windows(), "C.h5"));
    if (works_without_known(entry)) {
      EXPECT_NO_THROW(require_known_windows(entry, none, "C.h5"));
    } else {
      EXPECT_ERROR(require_known_windows(entry, none, "C.h5"), Exit::bad_input,
                   "C.h5: has no known fault windows (known-per-class = 0), but " +
                       std::string(entry.name) + " learns from them; use a method that does not: ");
    }
  }
  EXPECT_THAT(methods_without_known(), testing::Contains("oracle"));
  EXPECT_THAT(methods_without_known(), testing::Not(testing::Contains("smote")));
  EXPECT_FALSE(works_without_known({.name = "a", .kind = Kind::ours, .what = ""}));
  EXPECT_TRUE(
      works_without_known({.name = "a", .kind = Kind::ours, .what = "", .without_known = true}));
}

TEST(Catalogue, ListsAllMethodsForAnUnknownName) {
  EXPECT_ERROR(make_method("another"), Exit::usage, "unknown method 'another'; known: dynamics");
  EXPECT_ERROR(make_method(no_method), Exit::usage, "known: dynamics");
}

TEST(Catalogue, CountsTheFaultsThatAMethodLearnsFrom) {
  signal::WindowSet windows;
  windows.info = three_classes();
  windows.labels = {1, 2, 2};
  EXPECT_EQ(counted_faults(windows), "3 windows of 2 fault classes");
  windows.labels.clear();
  EXPECT_EQ(counted_faults(windows), "no fault window");
}

TEST(Catalogue, RefusesAMethodIfTheDescriptionLacksWhatItNeeds) {
  signal::DatasetInfo info;
  info.name = "rig";
  info.classes = {{"ok", signal::Defect::none, 0}, {"bad", signal::Defect::outer, 0}};
  const auto refusal = [&](const char* method) -> std::string {
    try {
      require_described_faults(*find_entry(method), info, "C.h5");
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(
      refusal("piae-dt-phase"),
      "C.h5: piae-dt-phase needs defect_size_mm of class bad, which the description of rig "
      "does not give; use a method that does not need it: smote, vae, wgan-gp, ae, strike-twin, "
      "piae-dt-zero, oversample, shift, mixup, aligned-mixup, spectral, adasyn, borderline-smote, "
      "resample, "
      "randomise, healthy-plus-impulses, ddpm, ddpm-angle, ddpm-healthy, "
      "ddpm-healthy-angle, flow, flow-angle, oracle");
  EXPECT_EQ(refusal("piae-dt-zero"), "");
  info.classes[1].defect = signal::Defect::other;
  EXPECT_EQ(
      refusal("piae-dt-zero"),
      "C.h5: piae-dt-zero needs the impact rate of class bad, whose defect is 'other', which the "
      "description of rig does not give; use a method that does not need it: smote, vae, wgan-gp, "
      "ae, "
      "oversample, shift, mixup, aligned-mixup, spectral, adasyn, borderline-smote, resample, "
      "randomise, ddpm, ddpm-healthy, flow, oracle");
  EXPECT_EQ(refusal("ae"), "");
  info.has_bearing = false;
  EXPECT_EQ(refusal("ae"),
            "C.h5: ae needs the bearing geometry, table [bearing], which the description of rig "
            "does not give; "
            "use a method that does not need it: smote, vae, wgan-gp, oversample, shift, mixup, "
            "aligned-mixup, spectral, adasyn, borderline-smote, resample, randomise, "
            "ddpm, ddpm-healthy, flow, oracle");
  EXPECT_EQ(refusal("shift"), "");
  info.has_bearing = true;
  info.classes[1] = {"bad", signal::Defect::outer, 0.5};
  for (const CatalogueEntry& entry : catalogue()) EXPECT_EQ(refusal(entry.name), "");
}

}  // namespace
}  // namespace piae::augment
