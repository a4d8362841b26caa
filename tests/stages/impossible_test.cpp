#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "stages/doctor.hpp"
#include "stages/tiny.hpp"
#include "verification/verify.hpp"

/// Artefacts with impossible content and correct digests: verify and the stages that read them
/// refuse them alike, in one line that names the file.
namespace piae::stages {
namespace {

using Change = std::function<void(hid_t)>;

/// A change, and a word of the refusal.
struct Case {
  const char* what;
  Change change;
  const char* word;
};

template <class T>
Change attribute(const std::string& object, const std::string& name, T value) {
  return [=](hid_t file) { replace_attribute(file, object, name, value); };
}

Change class_names(const std::vector<std::string>& names) {
  return [=](hid_t file) { replace_strings(file, "/classes/name", names); };
}

template <class T>
Change first_number(const std::string& path, T value) {
  return [=](hid_t file) {
    change_numbers<T>(file, path, [&](auto& values) { values.front() = value; });
  };
}

/// Sets numbers that are possible each, but together they keep eq. 13 busy for minutes.
void thousand_balls(hid_t file) {
  change_balls(file, 1000);
  replace_attribute(file, "/", "sample_rate_hz", 1000.0);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t huge = std::int64_t{1} << 40U;

Change without(const std::string& object, const std::string& name) {
  return [=](hid_t file) {
    artefact::hdf5::check(H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT),
                          name.c_str());
  };
}

/// Returns cases for the provenance of every artefact, which tables and pages show.
const std::vector<Case>& cases_of_provenance() {
  static const std::vector<Case> cases{
      {"cpu with a terminal's orders",
       attribute("/provenance", "cpu", std::string("AMD\x1b]0;evil\x07")), "cpu"},
      {"no cpu", without("/provenance", "cpu"), "cpu is missing"},
      {"no program", without("/provenance", "program"), "program is missing"},
      {"no version", without("/provenance", "version"), "version is missing"},
      {"no libraries", without("/provenance", "libraries"), "libraries is missing"},
      {"no inputs", [](hid_t file) { H5Ldelete(file, "/provenance/inputs", H5P_DEFAULT); },
       "/provenance/inputs is missing"},
      {"no options", [](hid_t file) { H5Ldelete(file, "/provenance/options", H5P_DEFAULT); },
       "/provenance/options is missing"},
  };
  return cases;
}

/// Returns cases for the data set description of every artefact.
const std::vector<Case>& cases_of_all() {
  static const std::vector<Case> cases{
      {"rate NaN", attribute("/", "sample_rate_hz", nan), "sample_rate_hz"},
      {"rate 0", attribute("/", "sample_rate_hz", 0.0), "sample_rate_hz"},
      {"rate 1e300", attribute("/", "sample_rate_hz", 1e300), "sample_rate_hz"},
      {"speed 0", attribute("/", "shaft_speed_rpm", 0.0), "shaft_speed_rpm"},
      {"unit -1", attribute("/", "unit_m_per_s2", -1.0), "unit_m_per_s2"},
      {"balls -1", attribute("/bearing", "balls", std::int64_t{-1}), "balls"},
      {"pitch 0", attribute("/bearing", "pitch_diameter_mm", 0.0), "pitch_diameter_mm"},
      {"balls larger than the pitch circle", attribute("/bearing", "pitch_diameter_mm", 1.0),
       "do not fit"},
      {"angle 90", attribute("/bearing", "contact_angle_deg", 90.0), "contact_angle_deg"},
      {"class without a name", class_names({"Normal", "", "OR021"}), "/classes/name"},
      {"one name twice", class_names({"Normal", "OR021", "OR021"}), "OR021 twice"},
      {"class ..", class_names({"Normal", "..", "OR021"}), "/classes/name"},
      {"class of two lines", class_names({"Normal", "a\nb", "OR021"}), "/classes/name"},
      {"class with a slash", class_names({"Normal", "a/b", "OR021"}), "/classes/name"},
      {"data set ..", [](hid_t file) { replace_attribute(file, "/", "dataset", ".."); }, "dataset"},
      {"100 000 classes",
       [](hid_t file) {
         replace_strings(file, "/classes/name", std::vector<std::string>(100'000, "x"));
       },
       "100000 classes"},
      {"two healthy classes",
       [](hid_t file) {
         replace_strings(file, "/classes/defect", {"none", "none", "outer"});
       },
       "defect 'none'"},
      {"unknown defect",
       [](hid_t file) {
         replace_strings(file, "/classes/defect", {"none", "cage", "outer"});
       },
       "/classes/defect"},
      {"a defect as large as the bearing", first_number("/classes/defect_size_mm", 40.0),
       "defect size"},
  };
  return cases;
}

class Impossible : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("score"); }

  /// Expects that `arguments`, which make the stage read "bad.h5", are refused. Every case is
  /// verified in process. The stage and the program `verify` use the same library functions, so one
  /// case of each group shows how both end.
  void expect_refused(const std::string& good, const std::vector<Case>& cases,
                      const std::string& stage, const Arguments& arguments) const {
    const fs::path bad = tiny_ / "bad.h5";
    for (const Case& c : cases) {
      SCOPED_TRACE(good + ": " + c.what);
      fs::copy_file(tiny_ / good, bad, fs::copy_options::overwrite_existing);
      doctor(bad, c.change);
      const std::vector<verification::Finding> findings = verification::verify({bad});
      ASSERT_EQ(findings.size(), 1);
      EXPECT_EQ(findings[0].reason, artefact::RefusalReason::bad_content) << findings[0].line;
      EXPECT_NE(findings[0].line.find(bad.string()), std::string::npos) << findings[0].line;
      EXPECT_NE(findings[0].line.find(c.word), std::string::npos) << findings[0].line;
      if (&c == &cases.front()) expect_programs_refuse(c, stage, arguments);
    }
  }
  void expect_programs_refuse(const Case& c, const std::string& stage,
                              const Arguments& arguments) const {
    const std::set<std::string> before = tiny_.files();
    expect_refusal(tiny_.run(stage, arguments), stage, 65, {"bad.h5", c.word});
    EXPECT_EQ(tiny_.files(), before);
    const Outcome verified = tiny_.run("verify", {"bad.h5"});
    EXPECT_EQ(verified.status, 16) << verified.out;
    EXPECT_TRUE(is_one_line(verified.out)) << verified.out;
    EXPECT_NE(verified.out.find("bad.h5"), std::string::npos) << verified.out;
  }
  /// Expects the same for a model of a method, from which a window is requested.
  void expect_model_refused(const std::string& method, const Arguments& options,
                            const std::vector<Case>& cases) const {
    Arguments arguments{"--method", method, "--known", "C.h5", "--seed", "0", "--output", "m.h5"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome trained = tiny_.run("train", arguments);
    ASSERT_EQ(trained.status, 0) << trained.err;
    const Outcome verified = tiny_.run("verify", {"m.h5"});
    ASSERT_EQ(verified.status, 0) << verified.out;
    expect_refused("m.h5", cases, "generate",
                   {"--model", "bad.h5", "--count", "2", "--seed", "0", "--output", "made.h5"});
  }
  [[nodiscard]] const Arguments& of_train() const { return train_; }

  Tiny tiny_;
  Arguments train_ = with(step_of("train").arguments, "--known", "bad.h5");
};

TEST_F(Impossible, Records) {
  const Arguments split = with(step_of("split").arguments, "--records", "bad.h5");
  expect_refused("records.h5", cases_of_all(), "split", split);
  expect_refused("records.h5",
                 {{"a sample of 1e200", first_number("/records/IR007-01", 1e200), "IR007-01"},
                  {"label -1", attribute("/records/IR007-01", "label", std::int64_t{-1}), "label"}},
                 "split", split);
}

TEST_F(Impossible, Windows) {
  expect_refused("C.h5", cases_of_all(), "train", of_train());
  expect_refused("C.h5", cases_of_provenance(), "train", of_train());
  expect_refused(
      "C.h5",
      {
          {"seed -1", attribute("/", "seed", std::int64_t{-1}), "seed"},
          {"a window in which nothing moves",
           [](hid_t file) {
             change_numbers<float>(file, "/windows", [](auto& samples) {
               std::fill_n(samples.begin(), 1024, samples.front());
             });
           },
           "window 0 is constant"},
          {"cut at the end of time",
           first_number("/first_sample", std::numeric_limits<std::int64_t>::max()), "first_sample"},
          {"a group instead of the windows",
           [](hid_t file) {
             H5Ldelete(file, "/windows", H5P_DEFAULT);
             artefact::hdf5::make_group(file, "/windows");
           },
           "/windows is not a dataset"},
      },
      "train", of_train());
}

TEST_F(Impossible, ModelsOfTwins) {
  expect_model_refused("piae-dt", {"--width", "8", "--epochs", "2"}, cases_of_all());
  expect_model_refused(
      "piae-dt", {"--width", "8", "--epochs", "2"},
      {
          {"depth 10^9", attribute("/", "depth", std::int64_t{1'000'000'000}), "depth"},
          {"width 2^40", attribute("/", "width", huge), "width"},
          {"width 10^6", attribute("/", "width", std::int64_t{1'000'000}), "shape"},
          {"samples -1", attribute("/", "samples", std::int64_t{-1}), "samples"},
          {"counts that overflow",
           first_number("/twin_space/counts", std::numeric_limits<std::int64_t>::max()), "counts"},
          {"edges in disorder", first_number("/twin_space/k_edges", 1e9), "k_edges"},
          {"a negative loss", first_number("/curves/twin", -1.0), "/curves/twin"},
          {"weights that give infinite samples",
           [](hid_t file) {
             change_numbers<float>(file, "/best/net/decoder/0/weight",
                                   [](auto& values) { std::ranges::fill(values, 3e38F); });
           },
           "infinite"},
          {"a method that is none",
           [](hid_t file) { replace_attribute(file, "/", "method", "cake"); }, "method"},
      });
}

TEST_F(Impossible, ModelsOfThePhaseTwin) {
  expect_model_refused(
      "piae-dt-phase",
      {"--width", "8", "--epochs", "2", "--simulations", "6", "--inference-epochs", "2",
       "--inference-width", "8"},
      {
          {"rate 0", attribute("/", "sample_rate_hz", 0.0), "sample_rate_hz"},
          {"bins -1", attribute("/phase", "space_bins", std::int64_t{-1}), "space_bins"},
          {"bins 2^40", attribute("/phase", "space_bins", huge), "space_bins"},
          {"a class without a known window",
           [](hid_t file) {
             change_numbers<std::int32_t>(file, "/phase/labels",
                                          [](auto& labels) { std::ranges::fill(labels, 1); });
           },
           "/phase/labels"},
          {"stiffness 0", first_number("/twin_space/points", 0.0), "/twin_space/points"},
      });
}

TEST_F(Impossible, ModelsOfTheStrikeTwin) {
  expect_model_refused(
      "strike-twin", {"--healthy", "B.h5"},
      {
          {"a rate too low for the impacts", attribute("/", "sample_rate_hz", 100.0),
           "impacts per second"},
          {"knots 2^40", attribute("/equaliser", "knots", huge), "knots"},
          {"background 2", attribute("/carry", "background", 2.0), "background"},
          {"dispersion of an hour", attribute("/carry", "dispersion_ms", 3.6e6), "dispersion_ms"},
          {"a response that is none",
           [](hid_t file) { replace_attribute(file, "/carry", "response", "cake"); },
           "minimum-phase or ring or cut"},
          {"strengths that are none",
           [](hid_t file) { replace_attribute(file, "/strengths", "from", "cake"); },
           "known or load-zone or alike"},
          {"a load zone that ends before it begins", attribute("/strengths", "least_extent", 2.0),
           "least_extent is above largest_extent"},
          {"more load that turns than stays", attribute("/strengths", "rotating", 1.5), "rotating"},
          {"no mass", attribute("/carry", "mass_kg", 0.0), "mass_kg"},
          {"healthy windows louder than any number", first_number("/healthy/log_amplitude", 1e6),
           "/healthy/log_amplitude"},
          {"a background of healthy windows that there are not",
           [](hid_t file) {
             replace_attribute(file, "/carry", "background_from", "healthy");
             H5Ldelete(file, "/healthy", H5P_DEFAULT);
           },
           "/healthy"},
          {"healthy windows of an untested condition",
           [](hid_t file) {
             change_numbers<std::int32_t>(file, "/healthy/condition",
                                          [](auto& conditions) { conditions[0] = 3; });
           },
           "/healthy/condition"},
          {"a lag before the impact", first_number("/edges/lag_s", -1.0), "/edges/lag_s"},
          {"an exit of 2", first_number("/edges/exit", 2.0), "/edges/exit"},
      });
}

TEST_F(Impossible, ModelsOfMethodsWithoutKnownFaults) {
  const auto of_a_fault = [](hid_t file) {
    change_numbers<std::int32_t>(file, "/labels", [](auto& labels) { labels[0] = 1; });
  };
  expect_model_refused(
      "piae-dt-zero", {"--healthy", "B.h5"},
      {
          {"a rate too low for the impacts", attribute("/", "sample_rate_hz", 100.0),
           "impacts per second"},
          {"a fault among the healthy windows", of_a_fault, "IR007"},
          {"slip 1", attribute("/prior", "slip", 1.0), "slip"},
          {"resonances 2^40", attribute("/prior", "resonances", huge), "resonances"},
          {"no damping", attribute("/prior", "damping_ratio_from", 0.0), "damping_ratio_from"},
          {"sizes in disorder", attribute("/prior", "size_from_mm", 9.0), "is above size_to_mm"},
          {"edges that are neither",
           [](hid_t file) { replace_attribute(file, "/prior", "edges", "cake"); }, "on or off"},
          {"no mass", attribute("/prior", "mass_kg", 0.0), "mass_kg"},
      });
  expect_model_refused(
      "healthy-plus-impulses", {"--healthy", "B.h5"},
      {
          {"a fault among the healthy windows", of_a_fault, "IR007"},
          {"modulation 2", attribute("/impulses", "modulation", 2.0), "modulation"},
          {"levels in disorder", attribute("/impulses", "level_from_db", 50.0),
           "is above level_to_db"},
      });
}

TEST_F(Impossible, ModelsOfOtherMethods) {
  expect_model_refused(
      "smote", {},
      {
          {"neighbours 0", attribute("/", "neighbours", std::int64_t{0}), "from 1"},
          {"neighbours 2^40", attribute("/", "neighbours", huge), "to 4"},
      });
  expect_model_refused(
      "adasyn", {"--healthy", "B.h5"},
      {
          {"neighbours 2^40", attribute("/", "neighbours", huge), "to 4"},
          {"foreign-among 0", attribute("/", "foreign_among", std::int64_t{0}), "foreign_among"},
          {"-1 foreign neighbours", first_number("/foreign_neighbours", std::int64_t{-1}),
           "/foreign_neighbours"},
          {"another number of classes as smote",
           attribute("/", "classes_as_smote", std::int64_t{99}), "classes_as_smote"},
      });
  expect_model_refused("aligned-mixup", {},
                       {{"alpha 0", attribute("/mixup", "alpha", 0.0), "alpha"}});
  expect_model_refused("spectral", {},
                       {{"knots 2^40", attribute("/equaliser", "knots", huge), "knots"}});
  expect_model_refused("shift", {},
                       {{"a class without windows",
                         [](hid_t file) {
                           change_numbers<std::int32_t>(file, "/labels",
                                                        [](auto& l) { std::ranges::fill(l, 1); });
                         },
                         "OR021"}});
  expect_model_refused(
      "vae", {"--epochs", "2", "--width", "8"},
      {
          {"latent 2^40", attribute("/", "latent", huge), "latent"},
          {"depth 10^9", attribute("/", "depth", std::int64_t{1'000'000'000}), "depth"},
          {"RMS 0", first_number("/classes/rms", 0.0), "/classes/rms"},
      });
  expect_model_refused("dynamics", {},
                       {
                           {"samples 2^40", attribute("/", "samples", huge), "samples"},
                           {"mass 0", attribute("/simulation", "mass_kg", 0.0), "mass_kg"},
                           {"no contact", attribute("/simulation", "load_n", 1e-3), "load"},
                           {"one sample", attribute("/", "samples", std::int64_t{1}), "samples"},
                           {"windows of hours", attribute("/", "sample_rate_hz", 1.0), "too many"},
                           {"1000 balls", thousand_balls, "too many"},
                       });
}

/// Names that programs print and put into tables.
TEST_F(Impossible, NamesOfMethodsAndRatios) {
  const auto text = [](const std::string& name, const std::string& value) {
    return Change([=](hid_t file) { replace_attribute(file, "/", name, value); });
  };
  const std::vector<Case> methods{
      {"markup", text("method", "<b>x</b>"), "attribute method"},
      {"no name", text("method", ""), "attribute method"},
      {"a very long one", text("method", std::string(60'000, 'x')), "attribute method"}};
  expect_refused("E.h5", methods, "score",
                 with(step_of("score").arguments, "--generated", "bad.h5"));
  Arguments diagnose{"--test",      "A.h5",   "--normal", "B.h5",  "--known", "C.h5",
                     "--generated", "bad.h5", "--ratio",  "50to1", "--seed",  "0",
                     "--epochs",    "1",      "--output", "d.h5"};
  expect_refused("E.h5", methods, "diagnose", diagnose);
}

/// Refusals of windows by rooms that do not know file names.
TEST_F(Impossible, RefusalsNameTheFiles) {
  doctor(tiny_ / "D.h5", [](hid_t file) {
    change_numbers<float>(file, "/windows", [](auto& values) { std::ranges::fill(values, 0.0F); });
  });
  expect_refusal(tiny_.run_step("score"), "score", 65, {"D.h5", "window 0 is constant"});
}

}  // namespace
}  // namespace piae::stages
