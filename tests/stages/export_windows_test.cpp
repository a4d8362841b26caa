// Windows in the formats of other programs, read back by these programs.

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "raw/file.hpp"
#include "signal/window_set.hpp"
#include "stages/tiny.hpp"

namespace piae::stages {
namespace {

bool shell_succeeds(const std::string& command) { return std::system(command.c_str()) == 0; }

/// Returns a python3 with these modules, from PATH or the system; empty if neither has them.
std::string python_with(const std::string& modules) {
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    if (shell_succeeds(python + " -c 'import " + modules + "' > /dev/null 2>&1")) return python;
  }
  return {};
}

/// The chain up to E, and another E by smote, whose windows have parents.
struct Export : testing::Test {
  void SetUp() override {
    tiny.run_chain_before("score");
    const auto made = [&](const std::string& stage, const Arguments& arguments) {
      const Outcome outcome = tiny.run(stage, arguments);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
    };
    made("train", {"--method", "smote", "--known", "C.h5", "--seed", "0", "--output", "smote.h5"});
    made("generate",
         {"--model", "smote.h5", "--count", "7", "--seed", "0", "--output", "generated.h5"});
    windows = signal::read_window_set(artefact::Reader(tiny / "generated.h5", "windows"));
    // Samples for comparison by the other programs, row by row.
    std::string samples(windows.samples.size() * sizeof(float), '\0');
    std::memcpy(samples.data(), windows.samples.data(), samples.size());
    tiny.write("expected.f32", samples);
    std::string parents;
    for (const signal::Parents& own : windows.parents) {
      parents += std::to_string(own.at(0)) + ' ' + std::to_string(own.at(1)) + '\n';
    }
    tiny.write("expected.parents", parents);
  }

  [[nodiscard]] Outcome exported(const std::string& output, const Arguments& more = {}) const {
    Arguments arguments{"--windows", "generated.h5", "--output", output};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tiny.run("export_windows", arguments);
  }

  void export_all() const {
    for (const std::string file : {"E.csv", "E.mat", "E.npy", "E.wav"}) {
      const Outcome outcome = exported(file);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.out, "exported 14 windows of 1024 samples: " + file + "\n");
    }
  }

  void expect_read(const std::string& command) const {
    EXPECT_TRUE(shell_succeeds("cd '" + tiny.path().string() + "' && " + command + " > log 2>&1"))
        << bytes_of(tiny / "log");
  }

  Tiny tiny;
  signal::WindowSet windows;
};

TEST_F(Export, WritesEveryFormatAndLeavesNothingElse) {
  const std::set<std::string> before = tiny.files();
  export_all();
  std::set<std::string> expected = before;
  expected.insert({"E.csv", "E.mat", "E.npy", "E.wav", "E.labels.csv"});
  EXPECT_EQ(tiny.files(), expected);
}

TEST_F(Export, WritesTheSameBytesTwice) {
  export_all();
  for (const std::string file : {"E.csv", "E.mat", "E.npy", "E.wav", "E.labels.csv"}) {
    const std::string ending = file.substr(file.find_last_of('.'));
    if (file != "E.labels.csv") {
      ASSERT_EQ(exported("again/E" + ending).status, 0);
    }
    EXPECT_TRUE(bytes_of(tiny / file) == bytes_of(tiny / ("again/" + file))) << file;
  }
}

TEST_F(Export, IsReadByTheReaderOfRecordings) {
  export_all();
  for (const std::size_t t : {0U, 1U, 1023U}) {
    const std::vector<double> column = raw::read(tiny / "E.csv", "x" + std::to_string(t));
    ASSERT_EQ(column.size(), windows.size());
    for (std::size_t i = 0; i < column.size(); ++i) {
      EXPECT_EQ(static_cast<float>(column[i]), windows.window(i)[t]);
    }
  }
  ASSERT_EQ(exported("one.mat", {"--class", "OR021", "--count", "1"}).status, 0);
  const std::vector<double> one = raw::read(tiny / "one.mat", "windows");
  ASSERT_EQ(one.size(), 1024U);
  for (std::size_t t = 0; t < 1024; ++t) EXPECT_EQ(one[t], double{windows.window(7)[t]});
}

TEST_F(Export, IsReadByNumPyAndSciPy) {
  const std::string python = python_with("numpy, scipy.io.wavfile");
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy and scipy (make test-all)";
  export_all();
  tiny.write("read.py", R"(
import csv, warnings
import numpy as np, scipy.io, scipy.io.wavfile
expected = np.fromfile("expected.f32", "<f4").reshape(14, 1024)
parents = [[int(i) for i in line.split()] for line in open("expected.parents")]
names = ["IR007"] * 7 + ["OR021"] * 7

npy = np.load("E.npy")
assert npy.dtype == np.float32 and np.array_equal(npy, expected)

mat = scipy.io.loadmat("E.mat")
assert mat["windows"].dtype == np.float32 and np.array_equal(mat["windows"], expected)
assert [row[0][0] for row in mat["class_name"]] == names
assert [list(row[0][0]) for row in mat["parents"]] == parents
assert mat["role"][0] == "E" and mat["method"][0] == "smote" and mat["sample_rate_hz"][0, 0] == 12000

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # SciPy warns of markers, which it does not read
    rate, wav = scipy.io.wavfile.read("E.wav")
assert rate == 12000 and wav.dtype == np.float32 and np.array_equal(wav, expected.ravel())

for file in "E.csv", "E.labels.csv":
    rows = list(csv.DictReader(open(file, newline="")))
    assert [row["class_name"] for row in rows] == names
    assert [[int(i) for i in row["parents"].split()] for row in rows] == parents
    assert all(row["unit_m_per_s2"] == "1" for row in rows)
rows = list(csv.DictReader(open("E.csv", newline="")))
samples = np.array([[np.float32(row["x%d" % t]) for t in range(1024)] for row in rows])
assert np.array_equal(samples, expected)
)");
  expect_read(python + " read.py");
}

TEST_F(Export, IsReadByOctave) {
  if (!shell_succeeds("octave-cli --version > /dev/null 2>&1")) {
    GTEST_SKIP() << "Octave is not installed (make test-all)";
  }
  export_all();
  tiny.write("read.m", R"(
file = fopen("expected.f32");
expected = fread(file, [1024, 14], "single=>single")';
parents = load("-ascii", "expected.parents");
mat = load("E.mat");
assert(isa(mat.windows, "single") && isequal(mat.windows, expected));
assert(isequal(cell2mat(mat.parents), parents));
assert(isequal(unique(mat.class_name), {"IR007"; "OR021"}));
assert(mat.sample_rate_hz == 12000 && strcmp(mat.method, "smote"));
[samples, rate] = audioread("E.wav");
assert(rate == 12000 && isequal(single(samples), reshape(expected', [], 1)));
)");
  expect_read("octave-cli --no-gui --norc read.m");
}

TEST_F(Export, OfOneClassHasItsFirstWindows) {
  ASSERT_EQ(exported("E.npy", {"--class", "OR021", "--count", "2"}).status, 0);
  std::vector<float> samples(2 * windows.length);
  const std::string bytes = bytes_of(tiny / "E.npy");
  ASSERT_EQ(bytes.size(), 128 + samples.size() * sizeof(float));
  std::memcpy(samples.data(), bytes.data() + 128, samples.size() * sizeof(float));
  EXPECT_TRUE(std::equal(samples.begin(), samples.end(), windows.window(7).begin()));
}

TEST_F(Export, RecordedWindowsHaveTheirPositions) {
  for (const std::string role : {"A", "B", "C", "D"}) {
    const Outcome outcome = tiny.run(
        "export_windows", {"--windows", role + ".h5", "--output", role + ".csv", "--count", "1"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string text = bytes_of(tiny / (role + ".csv"));
    EXPECT_TRUE(text.starts_with("dataset,role,sample_rate_hz,")) << text.substr(0, 80);
    EXPECT_NE(text.find(",record,first_sample,"), text.npos);
    EXPECT_NE(text.find("\ntiny," + role + ",12000,1,"), text.npos);
  }
}

TEST_F(Export, ReportsWhatItCannotDo) {
  tiny.write("E.labels.csv", "former");
  const std::set<std::string> before = tiny.files();
  expect_refusal(exported("E.xlsx"), "export_windows", 2, {"E.xlsx", ".csv, .mat, .npy or .wav"});
  expect_refusal(exported("E.csv", {"--class", "XR"}), "export_windows", 2,
                 {"XR", "IR007", "OR021"});
  expect_refusal(exported("E.csv", {"--class", "Normal"}), "export_windows", 65,
                 {"generated.h5", "Normal"});
  expect_refusal(tiny.run("export_windows", {"--windows", "model.h5", "--output", "E.csv"}),
                 "export_windows", 65, {"model.h5"});
  expect_refusal(tiny.run("export_windows", {"--windows", "none.h5", "--output", "E.csv"}),
                 "export_windows", 66, {"none.h5"});
  EXPECT_EQ(tiny.files(), before);
}

TEST_F(Export, DoesNotReplaceItsInput) {
  fs::rename(tiny / "generated.h5", tiny / "E.labels.csv");
  const std::string before = bytes_of(tiny / "E.labels.csv");
  const Outcome outcome =
      tiny.run("export_windows", {"--windows", "E.labels.csv", "--output", "E.npy"});
  expect_refusal(outcome, "export_windows", 2, {"E.labels.csv: is an input"});
  EXPECT_TRUE(bytes_of(tiny / "E.labels.csv") == before);
  EXPECT_FALSE(fs::exists(tiny / "E.npy"));
}

TEST_F(Export, FullDiskLeavesNothing) {
  const std::set<std::string> before = tiny.files();
  Surroundings small_disk;
  small_disk.largest_file = 2000;
  for (const std::string file : {"E.csv", "E.mat", "E.npy", "E.wav"}) {
    const Outcome outcome = stages::run(
        tiny.path(), "export_windows", {"--windows", "generated.h5", "--output", file}, small_disk);
    expect_refusal(outcome, "export_windows", 1, {file, "File too large"});
  }
  EXPECT_EQ(tiny.files(), before);
}

}  // namespace
}  // namespace piae::stages
