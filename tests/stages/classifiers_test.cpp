#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "artefact/digest.hpp"
#include "artefact/reader.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/diagnosis_record.hpp"
#include "stages/doctor.hpp"
#include "stages/tiny.hpp"

/// Classifiers of `diagnose`, requested as users do.
namespace piae::stages {
namespace {

class Classifiers : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("diagnose"); }

  [[nodiscard]] static Arguments diagnose_by(const std::string& classifier) {
    Arguments arguments = with(with(step_of("diagnose").arguments, "--classifier", classifier),
                               "--output", classifier + ".h5");
    const diagnosis::Classifier* const found = diagnosis::find_classifier(classifier);
    if (found != nullptr && found->fit != nullptr) {
      arguments = with(arguments, "--network", stored_network());
    }
    if (found != nullptr && found->adapts()) {
      arguments = with(arguments, "--unlabelled", "D.h5");
    }
    if (found == nullptr || !found->rule) return arguments;
    const auto generated = std::ranges::find(arguments, "--generated");
    arguments.erase(generated, generated + 2);
    return with(arguments, "--ratio", "100to1");
  }
  [[nodiscard]] Outcome run_well(const Arguments& arguments) const {
    const Outcome outcome = tiny_.run("diagnose", arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome;
  }
  [[nodiscard]] scoring::DiagnosisRecord record_of(const std::string& classifier) const {
    return scoring::read_diagnosis({tiny_ / (classifier + ".h5"), "diagnosis"});
  }
  [[nodiscard]] std::string bytes_of(const std::string& file) const {
    std::ifstream in(tiny_ / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const Tiny tiny_;
};

TEST_F(Classifiers, AreTestedOnTheTestWindows) {
  Arguments files;
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    const std::string name = each.name;
    const std::string printed = run_well(diagnose_by(name)).out;
    EXPECT_EQ(printed.find(name + ", seed 0") != printed.npos, name != "wdcnn") << printed;
    EXPECT_EQ(printed.find("in training") != printed.npos, each.trains()) << printed;
    const scoring::DiagnosisRecord record = record_of(name);
    EXPECT_EQ(record.classifier, name);
    EXPECT_EQ(record.labels.size(), 30U);
    EXPECT_EQ(record.loss.size(), each.represent != nullptr ? 2U : each.own_epochs) << name;
    EXPECT_FALSE(record.train_windows_per_second) << name;
    files.push_back(name + ".h5");
  }
  const Outcome verified = tiny_.run("verify", files);
  EXPECT_EQ(verified.status, 0) << verified.err;
}

// Files from before other classifiers existed equal those of today, to the last byte.
TEST_F(Classifiers, PapersClassifierIsTheDefaultAndNotNamedInItsFile) {
  (void)run_well(diagnose_by("wdcnn"));
  (void)run_well(with(step_of("diagnose").arguments, "--output", "default.h5"));
  EXPECT_TRUE(bytes_of("wdcnn.h5") == bytes_of("default.h5"));
  const artefact::Reader reader(tiny_ / "default.h5", "diagnosis");
  EXPECT_FALSE(reader.has_attribute("/", "classifier"));
  const std::string options =
      reader.strings(std::string(artefact::provenance_group) + "/options").front();
  EXPECT_EQ(options.find("classifier"), std::string::npos) << options;
  (void)run_well(diagnose_by("nearest"));
  const artefact::Reader other(tiny_ / "nearest.h5", "diagnosis");
  EXPECT_NE(other.strings(std::string(artefact::provenance_group) + "/options")
                .front()
                .find("classifier = \"nearest\""),
            std::string::npos);
}

TEST_F(Classifiers, AreReproducibleAndHaveTheirOwnStreams) {
  std::set<std::vector<float>> scores;
  for (const std::string name : {"wdcnn", "wdcnn-spectrum", "wdcnn-envelope", "wdcnn-spectra",
                                 "symptom-net", "wdcnn-orders", "prototypes", "dann", "cdan"}) {
    (void)run_well(diagnose_by(name));
    const std::string first = bytes_of(name + ".h5");
    (void)run_well(diagnose_by(name));
    EXPECT_TRUE(first == bytes_of(name + ".h5")) << name;
    EXPECT_TRUE(scores.insert(record_of(name).scores).second) << name;
  }
}

// Anything that depended on the labels of D would change some bits.
TEST_F(Classifiers, AdaptWithoutTheLabelsOfD) {
  for (const std::string name : {"dann", "cdan"}) {
    (void)run_well(diagnose_by(name));
    const std::vector<float> scores = record_of(name).scores;
    fs::copy_file(tiny_ / "D.h5", tiny_ / "mixed.h5", fs::copy_options::overwrite_existing);
    doctor((tiny_ / "mixed.h5").string(), [](hid_t file) {
      change_numbers<Label>(file, "/labels", [](auto& all) { std::ranges::reverse(all); });
    });
    (void)run_well(with(diagnose_by(name), "--unlabelled", "mixed.h5"));
    EXPECT_EQ(record_of(name).scores, scores) << name;
  }
}

TEST_F(Classifiers, AdaptToUnlabelledWindowsOnly) {
  Arguments without = with(step_of("diagnose").arguments, "--output", "x.h5");
  expect_refusal(tiny_.run("diagnose", with(without, "--classifier", "dann")), "diagnose", 2,
                 {"--classifier dann needs --unlabelled, D.h5 of split"});
  const Arguments given = with(without, "--unlabelled", "D.h5");
  for (const std::string name : {"wdcnn", "nearest"}) {
    expect_refusal(tiny_.run("diagnose", with(given, "--classifier", name)), "diagnose", 2,
                   {"--unlabelled: " + name + " must not see D"});
  }
  for (const std::string file : {"A.h5", "C.h5", "E.h5"}) {
    expect_refusal(
        tiny_.run("diagnose", with(with(given, "--classifier", "cdan"), "--unlabelled", file)),
        "diagnose", 65, {file, "must have role D"});
  }
  expect_refusal(
      tiny_.run("diagnose", with(with(given, "--classifier", "cdan"), "--backend", "libtorch")),
      "diagnose", 2, {"--backend, --device: cdan is computed on one core only"});
  EXPECT_FALSE(fs::exists(tiny_ / "x.h5"));
}

TEST_F(Classifiers, NearestPredictsWithCertainty) {
  (void)run_well(diagnose_by("nearest"));
  const scoring::DiagnosisRecord record = record_of("nearest");
  for (std::size_t i = 0; i < record.predictions.size(); ++i) {
    for (std::size_t label = 0; label < 3; ++label) {
      EXPECT_EQ(record.scores[3 * i + label], index_of(record.predictions[i]) == label ? 1 : 0);
    }
  }
}

TEST_F(Classifiers, UnknownNamesAreRefused) {
  expect_refusal(tiny_.run("diagnose", diagnose_by("svm")), "diagnose", 2,
                 {"unknown classifier 'svm'", "wdcnn-spectra, nearest"});
  EXPECT_FALSE(fs::exists(tiny_ / "svm.h5"));
}

TEST_F(Classifiers, WithoutLayersRefuseToKeepFeatures) {
  for (const std::string name : {"nearest", "nearest-orders", "exclusion-rule"}) {
    Arguments arguments = diagnose_by(name);
    arguments.emplace_back("--keep-features");
    expect_refusal(tiny_.run("diagnose", arguments), "diagnose", 2, {"--keep-features", name});
    EXPECT_FALSE(fs::exists(tiny_ / (name + ".h5")));
  }
}

TEST_F(Classifiers, SymptomNetKeepsItsHiddenLayer) {
  Arguments arguments = diagnose_by("symptom-net");
  arguments.emplace_back("--keep-features");
  (void)run_well(arguments);
  const auto features = record_of("symptom-net").features;
  ASSERT_TRUE(features);
  EXPECT_EQ(features->hidden.size(), 30U * 48);
  EXPECT_EQ(features->output.size(), 30U * 3);
}

TEST_F(Classifiers, RulesRefuseGeneratedWindows) {
  expect_refusal(tiny_.run("diagnose", with(diagnose_by("exclusion-rule"), "--generated", "E.h5")),
                 "diagnose", 2, {"--generated: exclusion-rule is a rule"});
  EXPECT_FALSE(fs::exists(tiny_ / "exclusion-rule.h5"));
}

TEST_F(Classifiers, RulesReportTheHealthyWindows) {
  const Outcome outcome = run_well(diagnose_by("envelope-rule"));
  EXPECT_NE(outcome.out.find("diagnosed 30 windows by comparison with 30 healthy windows ("),
            std::string::npos)
      << outcome.out;
}

TEST_F(Classifiers, RulesNeedWindowsThatSeparateTheLines) {
  const Outcome split = tiny_.run(
      "split", with(with(step_of("split").arguments, "--window", "256"), "--output-dir", "."));
  ASSERT_EQ(split.status, 0) << split.err;
  for (const std::string name : {"envelope-rule", "symptom-net"}) {
    expect_refusal(tiny_.run("diagnose", {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5",
                                          "--ratio", "100to1", "--seed", "0", "--output", "cell.h5",
                                          "--classifier", name}),
                   "diagnose", 65,
                   {"--normal: windows of 256 samples are too short to tell the fault lines"});
    EXPECT_FALSE(fs::exists(tiny_ / "cell.h5"));
  }
}

TEST_F(Classifiers, SymptomNetAndOrdersNeedTheSpeedOfGeneratedWindows) {
  tiny_.write("tiny.toml",
              tiny_description +
                  "[[simulation.condition]]\nname = \"fast\"\nshaft_speed_rpm = 1797\n"
                  "[[simulation.condition]]\nname = \"slow\"\nshaft_speed_rpm = 1400\n");
  for (const std::string stage : {"simulate", "split"}) {
    const Outcome made = tiny_.run_step(stage);
    ASSERT_EQ(made.status, 0) << made.err;
  }
  for (const std::string method : {"smote", "strike-twin"}) {
    ASSERT_EQ(tiny_
                  .run("train", {"--method", method, "--known", "C.h5", "--seed", "0", "--output",
                                 "model.h5"})
                  .status,
              0);
    ASSERT_EQ(tiny_.run_step("generate").status, 0);
    for (const std::string name :
         {"symptom-net", "nearest-orders", "wdcnn-orders", "prototypes", "dann"}) {
      const Arguments diagnose = with(diagnose_by(name), "--output", method + ".h5");
      if (method == "strike-twin") {
        (void)run_well(diagnose);
        continue;
      }
      expect_refusal(tiny_.run("diagnose", diagnose), "diagnose", 65,
                     {"--generated: the windows lack shaft speeds"});
      EXPECT_FALSE(fs::exists(tiny_ / "smote.h5"));
    }
    if (method == "smote") (void)run_well(with(diagnose_by("nearest"), "--output", "smote.h5"));
  }
}

TEST_F(Classifiers, SpectraAcceptWindowsTooShortForTheWaveform) {
  const Outcome split = tiny_.run(
      "split", with(with(step_of("split").arguments, "--window", "512"), "--output-dir", "."));
  ASSERT_EQ(split.status, 0) << split.err;
  const auto known_alone = [](const std::string& classifier) {
    return Arguments{"--test",   "A.h5",    "--normal",     "B.h5",    "--known",  "C.h5",
                     "--ratio",  "100to1",  "--seed",       "0",       "--epochs", "2",
                     "--output", "cell.h5", "--classifier", classifier};
  };
  expect_refusal(tiny_.run("diagnose", known_alone("wdcnn")), "diagnose", 65,
                 {"512 samples are too short", "at least 1024"});
  for (const std::string name : {"wdcnn-spectrum", "wdcnn-envelope", "wdcnn-spectra", "nearest",
                                 "wdcnn-orders", "nearest-orders", "prototypes"}) {
    (void)run_well(known_alone(name));
  }
}

TEST_F(Classifiers, VerifyFindsUnknownNames) {
  (void)run_well(diagnose_by("nearest"));
  doctor((tiny_ / "nearest.h5").string(),
         [](hid_t file) { replace_attribute(file, "/", "classifier", std::string("svm")); });
  const Outcome outcome = tiny_.run("verify", {"nearest.h5"});
  EXPECT_EQ(outcome.status, 16) << outcome.out << outcome.err;
  EXPECT_NE((outcome.out + outcome.err).find("attribute classifier"), std::string::npos)
      << outcome.out << outcome.err;
}

}  // namespace
}  // namespace piae::stages
