#include "regression/run_measurements.hpp"

#include <gmock/gmock.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "run/stored_verdicts.hpp"
#include "support/stored_run.hpp"

namespace piae::regression {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using RunMeasurements = StoredRun;

/// Reads the run of support/stored_run.hpp. It has two classes: the metrics' means are (0.5 + 1e-7)
/// / 2 and so on.
TEST_F(RunMeasurements, HaveTheirVersionsAndSettings) {
  add_all();
  const std::vector<Measurements> datasets = read_run(folder_.path() / "run", {});
  ASSERT_EQ(datasets.size(), 1U);
  const Measurements& run = datasets.front();
  EXPECT_EQ(run.dataset, "cwru");
  EXPECT_EQ(run.protocol, signal::Protocol::random);
  EXPECT_THAT(run.versions, ElementsAre(artefact::build_version()));
  EXPECT_THAT(run.settings,
              ElementsAre(artefact::cpu_settings() + "; " + artefact::build_libraries()));
  std::string text;
  for (const Measured& each : run.values) {
    if (each.seed == 0) {
      text += each.method + ' ' + each.ratio + ' ' + each.quantity + ' ' +
              std::to_string(each.value) + '\n';
    }
  }
  EXPECT_EQ(text,
            "none 100to1 accuracy 0.600000\n"
            "vae 10to1 accuracy 0.750000\n"
            "vae 2to1 accuracy 0.850000\n"
            "vae  aligned_rmse 2.000000\n"
            "vae  amplitude_ratio 2.500000\n"
            "vae  fault_line_db 3.500000\n"
            "vae  fault_line_difference_db 4.000000\n"
            "vae  mmd 0.250000\n"
            "vae  rmse 1.000000\n"
            "vae  spectral_distance_db 3.000000\n");
}

TEST_F(RunMeasurements, HaveTheClassifierOfEachAccuracy) {
  add_all();
  add(by("nearest", diagnosis("none", "100to1", 0, 0, 19)));
  const auto run = folder_.path() / "run";
  std::string text;
  const std::vector<Measurements> datasets = read_run(run, {});
  for (const Measured& each : datasets.front().values) {
    const bool is_accuracy = each.quantity == "accuracy";
    EXPECT_EQ(each.classifier.empty(), !is_accuracy);
    if (each.seed == 0 && is_accuracy) {
      text += each.method + ' ' + each.classifier + ' ' + each.ratio + '\n';
    }
  }
  EXPECT_EQ(text, "none wdcnn 100to1\nnone nearest 100to1\nvae wdcnn 10to1\nvae wdcnn 2to1\n");
  EXPECT_EQ(read_run(run, {.methods = {"none"}, .classifiers = {"nearest"}}).front().values.size(),
            1U);
}

TEST_F(RunMeasurements, CountTheRightVerdictsOfKeptClassifiers) {
  const auto run = folder_.path() / "verdicts";
  run::store_verdicts(run::Layout(run, "toys"), 3, {0, 1, 2, 2});
  const std::vector<Measurements> datasets = read_run(run, {});
  ASSERT_EQ(datasets.size(), 1U);
  ASSERT_EQ(datasets.front().values.size(), 1U);
  const Measured& measured = datasets.front().values.front();
  EXPECT_EQ(measured.classifier, "nearest");
  EXPECT_EQ(measured.quantity, "right_verdicts");
  EXPECT_EQ(measured.seed, 3);
  EXPECT_DOUBLE_EQ(measured.value, 2);  // of three faulty records
  EXPECT_THROW(read_run(run, {.classifiers = {"wdcnn"}}), Error);
}

TEST_F(RunMeasurements, ReadTheSelectionOnly) {
  add_all();
  const auto run = folder_.path() / "run";
  EXPECT_EQ(
      read_run(run, {.methods = {"vae"}, .ratios = {"2to1"}, .seeds = {1}}).front().values.size(),
      8U);
  for (const run::Selection& nothing :
       {run::Selection{.datasets = {"hit-sm"}}, run::Selection{.seeds = {9}}}) {
    try {
      (void)read_run(run, nothing);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::input_missing);
      EXPECT_THAT(error.what(), HasSubstr("run: has none of the requested diagnoses, scores"));
    }
  }
}

/// Counts how often each of some files is opened from now on, by inotify.
class OpenCounter {
 public:
  explicit OpenCounter(const std::vector<std::filesystem::path>& files)
      : descriptor_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    for (const auto& file : files) {
      const int watch = inotify_add_watch(descriptor_, file.c_str(), IN_OPEN);
      EXPECT_GE(watch, 0) << file;
      names_[watch] = file;
    }
  }
  OpenCounter(const OpenCounter&) = delete;
  OpenCounter& operator=(const OpenCounter&) = delete;
  ~OpenCounter() { ::close(descriptor_); }

  [[nodiscard]] std::map<std::filesystem::path, int> counts() const {
    std::map<std::filesystem::path, int> counts;
    for (const auto& [watch, name] : names_) counts[name] = 0;
    // Events of a watched file have no name, so all have the same size.
    std::array<inotify_event, 64> events{};
    for (ssize_t bytes = 0; (bytes = ::read(descriptor_, events.data(), sizeof events)) > 0;) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(bytes) / sizeof events[0]; ++i) {
        ++counts[names_.at(events[i].wd)];
      }
    }
    return counts;
  }

 private:
  int descriptor_;
  std::map<int, std::filesystem::path> names_;
};

TEST_F(RunMeasurements, OpenEachFileOnce) {
  add_all();
  std::vector<std::filesystem::path> cells;
  for (const int seed : {0, 1}) {
    cells.push_back(layout_.score("vae", seed));
    cells.push_back(layout_.diagnosis("none", "100to1", seed));
    for (const char* ratio : {"10to1", "2to1"}) {
      cells.push_back(layout_.diagnosis("vae", ratio, seed));
    }
  }
  const OpenCounter opened(cells);
  (void)read_run(folder_.path() / "run", {});
  for (const auto& [file, count] : opened.counts()) EXPECT_EQ(count, 1) << file;
}

TEST_F(RunMeasurements, RefuseAnImpossibleCell) {
  add_all();
  const auto expect_refused = [&](const std::string& what) {
    try {
      (void)read_run(folder_.path() / "run", {});
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      EXPECT_THAT(error.what(), HasSubstr(what));
    }
  };
  scoring::DiagnosisRecord other = diagnosis("vae", "2to1", 145, 1, 9);
  other.protocol = signal::Protocol::blocked;
  add(other);
  expect_refused("seed1/vae/2to1/wdcnn/diagnosis.h5: the split protocol is blocked");
  save("diagnosis", diagnosis("ae", "2to1", 145, 1, 9), layout_.diagnosis("vae", "2to1", 1));
  expect_refused("the method is ae, here it must be vae");
  std::filesystem::resize_file(layout_.diagnosis("vae", "2to1", 1), 1000);
  expect_refused("seed1/vae/2to1/wdcnn/diagnosis.h5");
}

}  // namespace
}  // namespace piae::regression
