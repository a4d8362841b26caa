#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <sstream>

#include "base/sha256.hpp"
#include "classification/record.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "scoring/diagnosis_record.hpp"
#include "signal/recordings.hpp"
#include "signal/window_set.hpp"
#include "stages/doctor.hpp"
#include "stages/tiny.hpp"

/// Keeps a classifier and applies it to recordings.
namespace piae::stages {
namespace {

using testing::HasSubstr;

class KeepClassifier : public testing::Test {
 protected:
  void SetUp() override { tiny_.run_chain_before("diagnose"); }

  /// Returns arguments without generated windows and without an output.
  static Arguments diagnose(const std::string& classifier = "wdcnn") {
    return {"--test", "A.h5",   "--normal", "B.h5",     "--known", "C.h5",         "--ratio",
            "100to1", "--seed", "0",        "--epochs", "2",       "--classifier", classifier};
  }
  [[nodiscard]] Outcome keep(const std::string& classifier = "wdcnn",
                             const std::string& file = "classifier.h5") const {
    const Outcome outcome =
        tiny_.run("diagnose", with(diagnose(classifier), "--keep-classifier", file));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome;
  }
  /// Returns a recording as CSV, one number per line.
  [[nodiscard]] std::string csv_of(std::span<const float> samples) const {
    std::ostringstream text;
    text.precision(9);
    for (const float sample : samples) text << sample << '\n';
    return text.str();
  }
  [[nodiscard]] static Arguments classify(const std::string& recording = "recording.csv") {
    return {"--classifier", "classifier.h5", "--recording",      recording, "--variable", "1",
            "--speed-rpm",  "1797",          "--sample-rate-hz", "12000"};
  }

  [[nodiscard]] std::string digest_of(const std::string& file, const std::string& kind) const {
    return artefact::Reader(tiny_ / file, kind).digest();
  }

  const Tiny tiny_;
};

TEST_F(KeepClassifier, ReportsItsCalibrationAndPassesVerify) {
  const Outcome outcome = keep();
  EXPECT_TRUE(is_one_line(outcome.out)) << outcome.out;
  EXPECT_THAT(outcome.out, testing::StartsWith("kept wdcnn with temperature "));
  EXPECT_THAT(outcome.out, HasSubstr(" from 40 left-out windows: calibration error "));
  EXPECT_THAT(outcome.out, HasSubstr(": classifier.h5 ("));
  const Outcome verified = tiny_.run("verify", {"classifier.h5"});
  EXPECT_EQ(verified.status, 0) << verified.out;
  EXPECT_EQ(tiny_.left_overs(), std::set<std::string>{});
}

// The diagnosis has the contents of one of a run that keeps nothing.
TEST_F(KeepClassifier, ChangesNothingInTheDiagnosis) {
  Arguments arguments = diagnose();
  arguments.emplace_back("--reproducible");
  const Arguments alone = with(arguments, "--output", "alone.h5");
  ASSERT_EQ(tiny_.run("diagnose", alone).status, 0);
  const Arguments both =
      with(with(arguments, "--output", "both.h5"), "--keep-classifier", "classifier.h5");
  const Outcome outcome = tiny_.run("diagnose", both);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nkept wdcnn "));
  EXPECT_EQ(digest_of("both.h5", "diagnosis"), digest_of("alone.h5", "diagnosis"));
}

TEST_F(KeepClassifier, GivesTheSameContentsEachTime) {
  (void)keep("wdcnn", "a.h5");
  (void)keep("wdcnn", "b.h5");
  EXPECT_EQ(digest_of("a.h5", "classifier"), digest_of("b.h5", "classifier"));
}

TEST_F(KeepClassifier, NeedsOneOfTheOutputs) {
  expect_refusal(tiny_.run("diagnose", diagnose()), "diagnose", 2,
                 {"give --output or --keep-classifier"});
}

// Applied to A again, each predicts what its diagnosis predicted.
TEST_F(KeepClassifier, EveryClassifierPredictsLikeItsDiagnosis) {
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    const std::string name = each.name;
    SCOPED_TRACE(name);
    Arguments arguments = with(with(diagnose(name), "--output", name + ".diagnosis.h5"),
                               "--keep-classifier", name + ".h5");
    if (each.fit != nullptr) arguments = with(arguments, "--network", stored_network());
    if (each.adapts()) arguments = with(arguments, "--unlabelled", "D.h5");
    const Outcome outcome = tiny_.run("diagnose", arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Outcome verified = tiny_.run("verify", {name + ".h5"});
    EXPECT_EQ(verified.status, 0) << verified.out;
    diagnosis::KeptClassifier kept(artefact::Reader(tiny_ / (name + ".h5"), "classifier"));
    EXPECT_EQ(kept.classifier().name, name);
    EXPECT_EQ(kept.origin().training_windows, 40);
    const signal::WindowSet test =
        signal::read_window_set(artefact::Reader(tiny_ / "A.h5", "windows"));
    const scoring::DiagnosisRecord record =
        scoring::read_diagnosis({tiny_ / (name + ".diagnosis.h5"), "diagnosis"});
    const std::vector<float> scores = kept.uncalibrated(test).scores;
    ASSERT_EQ(scores.size(), record.scores.size());
    for (std::size_t i = 0; i < scores.size(); ++i) {
      EXPECT_NEAR(scores[i], record.scores[i], 1e-6) << i;
    }
    EXPECT_EQ(diagnosis::most_likely(scores, 3), record.predictions);
  }
}

TEST_F(KeepClassifier, RecordsTheMethodOfGeneratedWindows) {
  const Outcome outcome =
      tiny_.run("diagnose", {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--generated",
                             "E.h5", "--ratio", "50to1", "--seed", "3", "--classifier", "nearest",
                             "--keep-classifier", "classifier.h5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const diagnosis::KeptClassifier kept(artefact::Reader(tiny_ / "classifier.h5", "classifier"));
  EXPECT_EQ(kept.origin().method, "piae-dt");
  EXPECT_EQ(kept.origin().ratio, "50to1");
  EXPECT_EQ(kept.origin().generated_per_class, 5);
  EXPECT_EQ(kept.origin().seed, 3);
}

/// Provides a classifier, and windows of A, which it was not trained on, as recordings.
class Classify : public KeepClassifier {
 protected:
  void SetUp() override {
    KeepClassifier::SetUp();
    (void)keep();
    test_ = signal::read_window_set(artefact::Reader(tiny_ / "A.h5", "windows"));
    tiny_.write("recording.csv", csv_of(test_.window(12)));
  }
  void expect_refused(const Arguments& arguments, int status,
                      const std::vector<std::string>& words) const {
    const std::set<std::string> before = tiny_.files();
    Arguments all = arguments;
    all.insert(all.end(), {"--csv", "out.csv", "--picture", "out.svg", "--page", "out.html",
                           "--output", "out.h5"});
    expect_refusal(tiny_.run("classify", all), "classify", status, words);
    EXPECT_EQ(tiny_.files(), before);
  }
  [[nodiscard]] static Arguments without(Arguments arguments, const std::string& option) {
    const auto found = std::ranges::find(arguments, option);
    arguments.erase(found, found + 2);
    return arguments;
  }
  /// Writes a description of recordings of the tiny machine, in the classifier's unit.
  void describe(const std::string& speed = "1797") const {
    const signal::Recordings recordings =
        signal::read_recordings(artefact::Reader(tiny_ / "records.h5", "records"));
    std::string text =
        described_bearing("mine") + described_normal + described_ir007 + described_or021;
    for (const signal::Record& record : recordings.records) {
      const std::vector<float> samples(record.signal.begin(), record.signal.end());
      tiny_.write("data/" + record.name + ".csv", csv_of(samples));
      text += "[[record]]\nclass = \"" + recordings.info.class_of(record.label).name +
              "\"\nfile = \"" + record.name + ".csv\"\nvariable = \"1\"\nsample_rate_hz = 12000\n" +
              "shaft_speed_rpm = " + speed + "\n";
    }
    tiny_.write("mine.toml", text);
  }

  signal::WindowSet test_;
};

TEST_F(Classify, PredictsLikeTheDiagnosis) {
  ASSERT_EQ(tiny_.run("diagnose", with(diagnose(), "--output", "diagnosis.h5")).status, 0);
  const scoring::DiagnosisRecord record =
      scoring::read_diagnosis({tiny_ / "diagnosis.h5", "diagnosis"});
  // All of A as one recording of consecutive windows.
  tiny_.write("recording.csv", csv_of(test_.samples));
  const Outcome outcome = tiny_.run("classify", with(classify(), "--output", "out.h5"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const artefact::Reader reader(tiny_ / "out.h5", "classification");
  EXPECT_EQ(reader.numbers<Label>("/windows/label", {0}).values, record.predictions);
  EXPECT_EQ(reader.text("/", "classifier_digest"),
            artefact::Reader(tiny_ / "classifier.h5", "classifier").digest());
  diagnosis::KeptClassifier kept(artefact::Reader(tiny_ / "classifier.h5", "classifier"));
  const std::vector<float> expected = kept.predict(test_).probabilities;
  const std::vector<float> printed = reader.numbers<float>("/windows/probabilities", {0, 3}).values;
  ASSERT_EQ(printed.size(), expected.size());
  for (std::size_t i = 0; i < printed.size(); ++i) EXPECT_NEAR(printed[i], expected[i], 1e-6) << i;
}

TEST_F(Classify, PrintsAtMostEightyColumns) {
  const Outcome outcome = tiny_.run("classify", classify());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, testing::StartsWith("recording      named"));
  EXPECT_THAT(outcome.out, HasSubstr("\nrecording.csv  "));
  EXPECT_THAT(outcome.out,
              HasSubstr("\nby wdcnn of tiny, trained on 40 windows (none 100to1, seed 0)\n"));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST_F(Classify, WritesAllRequestedFiles) {
  describe();
  const Arguments arguments{"--classifier", "classifier.h5", "--description", "mine.toml",
                            "--data-dir",   "data",          "--csv",         "out.csv",
                            "--picture",    "out.svg",       "--output",      "out.h5"};
  const Outcome outcome = tiny_.run("classify", arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const std::string name : {"IR007-01", "IR007-02", "Normal-01", "OR021-02"}) {
    EXPECT_THAT(outcome.out, HasSubstr("\n" + name + " "));
  }
  EXPECT_EQ(tiny_.run("verify", {"out.h5"}).status, 0);
  // 0.5 s are 6000 samples: two windows of 2048 for each record, and the header.
  const std::string csv = bytes_of(tiny_ / "out.csv");
  const auto windows = 6 * static_cast<std::ptrdiff_t>(6000 / test_.length);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + windows);
  EXPECT_THAT(csv, testing::StartsWith("recording,start_s,class,probability,strangeness,unknown,"
                                       "p_Normal,p_IR007,p_OR021\n"));
  const std::string picture = bytes_of(tiny_ / "out.svg");
  EXPECT_THAT(picture, HasSubstr(">IR007-02 (described as IR007): "));
  // Parse it as XML with an independent program.
  const std::string check = "python3 -c 'import sys, xml.dom.minidom as d; d.parse(sys.argv[1])' ";
  if (std::system("python3 -c '' 2>/dev/null") == 0) {
    EXPECT_EQ(std::system((check + (tiny_ / "out.svg").string()).c_str()), 0);
  }
  EXPECT_EQ(tiny_.left_overs(), std::set<std::string>{});
}

TEST_F(Classify, WritesThePageOfOneRecording) {
  describe();
  const Arguments arguments{"--classifier", "classifier.h5", "--description", "mine.toml",
                            "--data-dir",   "data",          "--record",      "IR007-02",
                            "--csv",        "out.csv",       "--page",        "out.html"};
  const Outcome outcome = tiny_.run("classify", arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(tiny_ / "out.csv"));
  const std::string page = bytes_of(tiny_ / "out.html");
  EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>\n"));
  EXPECT_THAT(page, HasSubstr("<h1>IR007-02</h1>"));
  EXPECT_THAT(page, HasSubstr("<dd>0.50 s, 15 turns</dd>"));  // 6000 samples; 1797 rpm
  EXPECT_THAT(page, HasSubstr("Classified by wdcnn of tiny, trained on 40 windows"));
  EXPECT_EQ(tiny_.left_overs(), std::set<std::string>{});
}

TEST_F(Classify, RefusesAPageOfSeveralRecordings) {
  describe();
  expect_refused(
      {"--classifier", "classifier.h5", "--description", "mine.toml", "--data-dir", "data"}, 2,
      {"--page: shows one recording, not 6; choose one by --record"});
}

// A page that cannot be written takes the CSV with it, so that no half of the results is left.
TEST_F(Classify, WritesNothingIfThePageCannotBeWritten) {
  const std::set<std::string> before = tiny_.files();
  Arguments arguments = classify();
  arguments.insert(arguments.end(), {"--csv", "out.csv", "--page", "recording.csv/out.html"});
  expect_refusal(tiny_.run("classify", arguments), "classify", 1,
                 {"recording.csv: cannot make this folder", "choose another"});
  EXPECT_EQ(tiny_.files(), before);
}

TEST_F(Classify, UsesTheRequestedRecordsOfADescription) {
  describe();
  const Arguments arguments{"--classifier", "classifier.h5", "--description",
                            "mine.toml",    "--data-dir",    "data",
                            "--record",     "OR021-01",      "IR007-02"};
  const Outcome outcome = tiny_.run("classify", arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nOR021-01 "));
  EXPECT_THAT(outcome.out, HasSubstr("\nIR007-02 "));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("Normal-01 ")));
  Arguments other = arguments;
  other.back() = "IR007-03";
  // The error comes before the recordings are read.
  fs::remove(tiny_ / "data/OR021-01.csv");
  expect_refused(other, 2, {"mine.toml does not have a record 'IR007-03'; known:", "OR021-02"});
}

TEST_F(Classify, HasAWindowAtEachStep) {
  const auto windows_by = [&](const Arguments& arguments) {
    const Outcome outcome = tiny_.run("classify", with(arguments, "--output", "out.h5"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const artefact::Reader reader(tiny_ / "out.h5", "classification");
    return reader.numbers<Label>("/windows/label", {0}).values.size();
  };
  tiny_.write("recording.csv", csv_of(std::span(test_.samples).first(3 * test_.length)));
  EXPECT_EQ(windows_by(classify()), 3U);
  EXPECT_EQ(windows_by(with(classify(), "--step", std::to_string(test_.length / 2))), 5U);
}

TEST_F(Classify, JudgesCheckedRecordsLikeTheirDescription) {
  describe();
  const auto judged = [&](const Arguments& from) {
    Arguments arguments{"--classifier", "classifier.h5", "--output", "out.h5"};
    arguments.insert(arguments.end(), from.begin(), from.end());
    const Outcome outcome = tiny_.run("classify", arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::map<std::string, std::string> faults;
    for (const classification::Named& each :
         classification::read_named({tiny_ / "out.h5", "classification"})) {
      EXPECT_EQ(each.recording.substr(0, each.recording.find('-')), each.true_class);
      faults[each.recording] = each.fault;
    }
    return faults;
  };
  const auto described = judged({"--description", "mine.toml", "--data-dir", "data"});
  EXPECT_EQ(described.size(), 6U);
  EXPECT_EQ(judged({"--records", "records.h5"}), described);
  EXPECT_EQ(judged({"--records", "records.h5", "--record", "OR021-01"}).size(), 1U);
  expect_refused({"--classifier", "classifier.h5", "--records", "records.h5", "--record", "a"}, 2,
                 {"records.h5 does not have a record 'a'; known: IR007-01"});
  expect_refused({"--classifier", "classifier.h5", "--records", "A.h5"}, 65,
                 {"A.h5: is an artefact"});
}

TEST_F(Classify, NeedsOneSourceOfRecordings) {
  const std::string words = "give one of --recording, --description and --records";
  expect_refused({"--classifier", "classifier.h5"}, 2, {words});
  describe();
  expect_refused(with(classify(), "--description", "mine.toml"), 2, {words});
  expect_refused(with(classify(), "--records", "records.h5"), 2, {words});
  for (const std::string option : {"--variable", "--speed-rpm", "--sample-rate-hz"}) {
    expect_refused(without(classify(), option), 2,
                   {"--recording needs --variable, --sample-rate-hz and --speed-rpm"});
  }
}

TEST_F(Classify, RefusesASignalThatDoesNotFitAndNamesTheRemedy) {
  expect_refused(with(classify(), "--sample-rate-hz", "8000"), 65,
                 {"recording.csv: is sampled at 8000 Hz", "at that rate or a higher one"});
  expect_refused(
      with(classify(), "--speed-rpm", "900"), 65,
      {"recording.csv: was recorded at 900 rpm", "trained at 1797 rpm", "0.95 to 1.05 times"});
  expect_refused(
      with(classify(), "--sample-rate-hz", "48000"), 65,
      {"recording.csv: has 256 samples at 12000 Hz", "has 1024", "make a longer recording"});
  describe("1000");
  expect_refused(
      {"--classifier", "classifier.h5", "--description", "mine.toml", "--data-dir", "data"}, 65,
      {"record IR007-01: was recorded at 1000 rpm"});
}

TEST_F(Classify, DoesNotReplaceInputsOrWriteAFileTwice) {
  const auto expect_usage = [&](const Arguments& outputs, const std::string& word) {
    Arguments all = classify();
    all.insert(all.end(), outputs.begin(), outputs.end());
    expect_refusal(tiny_.run("classify", all), "classify", 2, {word});
  };
  const std::string recording = sha256_of_file(tiny_ / "recording.csv");
  expect_usage({"--picture", "recording.csv"}, "recording.csv: is an input");
  expect_usage({"--csv", "classifier.h5"}, "classifier.h5: is an input");
  expect_usage({"--csv", "out", "--output", "./out"}, "out: is named by two options");
  EXPECT_EQ(sha256_of_file(tiny_ / "recording.csv"), recording);
}

TEST_F(Classify, RefusesAnImpossibleStep) {
  expect_refused(with(classify(), "--step", "-1"), 2, {"--step"});
}

TEST_F(Classify, RefusesADamagedRecording) {
  const std::string good = csv_of(test_.window(0));
  tiny_.write("dead.csv", good + csv_of(std::vector<float>(test_.length, 0.5F)));
  expect_refused(classify("dead.csv"), 65,
                 {"dead.csv: is constant from ", "(a dead channel); cut that stretch out"});
  tiny_.write("nan.csv", good + "nan\n" + good);
  expect_refused(classify("nan.csv"), 65,
                 {"nan.csv: sample " + std::to_string(test_.length) + " (counted from 0) is NaN"});
  expect_refused(with(classify(), "--variable", "2"), 65, {"recording.csv", "2"});
  expect_refused(classify("nowhere.csv"), 66, {"nowhere.csv"});
  describe();
  tiny_.write("data/IR007-01.csv", good + "nan\n" + good);
  expect_refused(
      {"--classifier", "classifier.h5", "--description", "mine.toml", "--data-dir", "data"}, 65,
      {"IR007-01.csv"});
}

TEST_F(Classify, RefusesAFileThatIsNotAClassifier) {
  expect_refused(with(classify(), "--classifier", "A.h5"), 65, {"A.h5", "classifier"});
  expect_refused(with(classify(), "--classifier", "nowhere.h5"), 66, {"nowhere.h5"});
  std::string bytes = bytes_of(tiny_ / "classifier.h5");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  tiny_.write("damaged.h5", bytes);
  expect_refused(with(classify(), "--classifier", "damaged.h5"), 65, {"damaged.h5"});
}

// Digests are correct, but no stage writes such content: verify and classify find it.
TEST_F(Classify, RefusesAnImpossibleClassifier) {
  const std::string good = bytes_of(tiny_ / "classifier.h5");
  const auto expect_found = [&](const std::function<void(hid_t)>& change, const std::string& word) {
    tiny_.write("classifier.h5", good);
    doctor((tiny_ / "classifier.h5").string(), change);
    const Outcome verified = tiny_.run("verify", {"classifier.h5"});
    EXPECT_EQ(verified.status, 16) << word << ": " << verified.out << verified.err;
    EXPECT_THAT(verified.out, HasSubstr(word));
    expect_refused(classify(), 65, {"classifier.h5", word});
  };
  expect_found([](hid_t f) { replace_attribute(f, "/", "classifier", std::string("svm")); }, "svm");
  expect_found([](hid_t f) { replace_attribute(f, "/", "temperature", 0.0); }, "temperature");
  expect_found([](hid_t f) { replace_attribute(f, "/reference", "threshold", -1.0); }, "threshold");
  expect_found([](hid_t f) { replace_attribute(f, "/trust", "accuracy", 1.5); }, "accuracy");
  expect_found([](hid_t f) { replace_attribute(f, "/", "window_length", std::int64_t{2050}); },
               "cannot classify a window");
  expect_found(
      [](hid_t f) {
        change_numbers<Label>(f, "/trust/untrained_class", [](auto& all) { all.front() = 7; });
      },
      "/trust/untrained_class");
  expect_found(
      [](hid_t f) {
        change_numbers<Label>(f, "/reference/labels", [](auto& all) { all.front() = 3; });
      },
      "/reference/labels");
  expect_found(
      [](hid_t f) {
        change_numbers<float>(f, "/learned/dense/running_variance",
                              [](auto& all) { all.front() = -1; });
      },
      "/learned/dense/running_variance");
}

TEST_F(Classify, DamagedFileIsRefusedOrChangesNoValue) {
  ASSERT_EQ(tiny_.run("classify", with(classify(), "--output", "classification.h5")).status, 0);
  std::mt19937_64 random(20261125);
  for (const std::string name : {"classifier.h5", "classification.h5"}) {
    const std::string good = bytes_of(tiny_ / name);
    const std::string digest = artefact::Reader(tiny_ / name, "").digest();
    int refused = 0;
    for (int i = 0; i < 40; ++i) {
      std::string bytes = good;
      char& byte = bytes[random() % bytes.size()];
      byte = static_cast<char>(byte ^ static_cast<char>(1 + random() % 255));
      write_bytes(tiny_ / name, bytes);
      try {
        EXPECT_EQ(artefact::Reader(tiny_ / name, "").digest(), digest);
      } catch (const Error& error) {
        EXPECT_EQ(error.exit(), Exit::bad_input) << error.what();
        ++refused;
        if (i % 8 == 0 && name == "classifier.h5") expect_refused(classify(), 65, {name});
      }
    }
    EXPECT_GT(refused, 20) << name;
    write_bytes(tiny_ / name, good);
  }
}

/// Tables of kept classifiers.
class TrustStage : public KeepClassifier {
 protected:
  static Arguments trust() {
    return {"--run",    "run",    "--dataset", "tiny", "--methods",     "none",
            "--ratios", "100to1", "--seeds",   "0",    "--classifiers", "wdcnn"};
  }
};

TEST_F(TrustStage, MakesTheTables) {
  (void)keep("wdcnn", "run/tiny/seed0/none/100to1/wdcnn/classifier.h5");
  const Arguments arguments = trust();
  (void)keep("nearest", "run/tiny/seed0/none/100to1/nearest/classifier.h5");
  const Outcome outcome = tiny_.run("trust", arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "tabulated 2 kept classifiers: run/tiny/trust.md\n");
  const std::string csv = bytes_of(tiny_ / "run/tiny/trust.csv");
  EXPECT_THAT(csv, HasSubstr("\ntiny,wdcnn,none,100to1,1,accuracy,,"));
  EXPECT_THAT(csv, HasSubstr("\ntiny,nearest,none,100to1,1,untrained_auroc,OR021,"));
  EXPECT_THAT(bytes_of(tiny_ / "run/tiny/trust.md"), testing::StartsWith("# tiny: how far"));
}

TEST_F(TrustStage, NamesMissingCells) {
  const std::set<std::string> before = tiny_.files();
  expect_refusal(tiny_.run("trust", trust()), "trust", 66,
                 {"run/tiny/seed0/none/100to1/wdcnn/classifier.h5"});
  EXPECT_EQ(tiny_.files(), before);
}

}  // namespace
}  // namespace piae::stages
