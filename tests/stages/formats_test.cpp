// From recordings in the files of several instruments to a diagnosis.

#include <matio.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "artefact/reader.hpp"
#include "base/sha256.hpp"
#include "bearing/kinematics.hpp"
#include "scoring/diagnosis_record.hpp"
#include "stages/tiny.hpp"
#include "support/little_endian.hpp"
#include "support/made_recordings.hpp"
#include "support/tdms_writer.hpp"

namespace piae::stages {
namespace {

constexpr double sampled_hz = 12000;

std::vector<double> recording(double impacts_hz, double seconds, const std::string& name) {
  return impact_recording(sampled_hz, seconds, impacts_hz, "formats/" + name);
}

/// Returns a channel of NI's recorders, with the time between samples.
std::string tdms(const std::vector<double>& samples) {
  const tdms::Writer write;
  const std::vector<std::string> objects{
      write.object("/", write.no_values()), write.object("/'rig'", write.no_values()),
      write.object("/'rig'/'acc'", write.index(tdms::dbl, samples.size()),
                   {write.property("wf_increment", 1 / sampled_hz)})};
  return write.segment(tdms::new_values, objects, write.numbers(samples));
}

/// Returns a WAV file of one channel of 32-bit floats (format tag 3).
std::string wav(const std::vector<double>& samples) {
  std::string data;
  for (const double x : samples) {
    data += little(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
  }
  const auto rate = static_cast<std::uint32_t>(sampled_hz);
  const std::string chunks = "WAVEfmt " + little(16, 4) + little(3, 2) + little(1, 2) +
                             little(rate, 4) + little(4 * rate, 4) + little(4, 2) + little(32, 2) +
                             "data" + little(static_cast<std::uint32_t>(data.size()), 4) + data;
  return "RIFF" + little(static_cast<std::uint32_t>(chunks.size()), 4) + chunks;
}

matvar_t* vector_called(const char* name, const std::vector<double>& values) {
  std::size_t dims[]{values.size(), 1};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims,
                       const_cast<double*>(values.data()), 0);
}

/// Writes a file like the Paderborn data center: N09.Y(2).Data is the vibration.
void write_paderborn(const fs::path& file, const std::vector<double>& samples) {
  std::size_t one[]{1, 1};
  std::size_t two[]{1, 2};
  const char* fields_of_y[]{"Name", "Data"};
  matvar_t* const y = Mat_VarCreateStruct("Y", 2, two, fields_of_y, 2);
  const std::string names[]{"force", "vibration_1"};
  for (std::size_t i = 0; i < 2; ++i) {
    std::size_t letters[]{1, names[i].size()};
    Mat_VarSetStructFieldByName(y, "Name", i,
                                Mat_VarCreate("Name", MAT_C_CHAR, MAT_T_UTF8, 2, letters,
                                              const_cast<char*>(names[i].data()), 0));
    Mat_VarSetStructFieldByName(
        y, "Data", i, vector_called("Data", i == 1 ? samples : std::vector<double>{1, 2, 3}));
  }
  const char* fields_of_n[]{"Y"};
  matvar_t* const n = Mat_VarCreateStruct("N09", 2, one, fields_of_n, 1);
  Mat_VarSetStructFieldByName(n, "Y", 0, y);
  mat_t* const mat = Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT5);
  EXPECT_EQ(Mat_VarWrite(mat, n, MAT_COMPRESSION_ZLIB), 0);
  Mat_VarFree(n);
  Mat_Close(mat);
}

std::string text(const std::vector<double>& samples) {
  std::string lines = "time,acceleration\n";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    lines += std::to_string(static_cast<double>(i) / sampled_hz) + ',' +
             std::to_string(samples[i]) + '\n';
  }
  return lines;
}

std::string record(const std::string& name, const std::string& file, const std::string& variable) {
  return "[[record]]\nclass = \"" + name + "\"\nfile = " + file + "\nvariable = \"" + variable +
         "\"\nsample_rate_hz = 12000\n";
}

class Formats : public testing::Test {
 protected:
  Outcome run_well(const std::string& stage, const Arguments& arguments) const {
    Outcome outcome = run(folder_.path(), stage, arguments);
    EXPECT_EQ(outcome.status, 0) << stage << ": " << outcome.err;
    return outcome;
  }

  Folder folder_;
};

TEST_F(Formats, ManyInstrumentsLeadToADiagnosis) {
  const bearing::FaultFrequencies lines = bearing::fault_frequencies({}, 1797);
  fs::create_directory(folder_ / "data");
  for (int i = 1; i <= 12; ++i) {
    const std::string name = std::to_string(i);
    folder_.write("data/healthy/acc_" + name + ".csv", text(recording(0, 0.5, "healthy" + name)));
  }
  folder_.write("data/inner.tdms", tdms(recording(lines.bpfi_hz, 3, "inner/1")));
  folder_.write("data/inner.wav", wav(recording(lines.bpfi_hz, 3, "inner/2")));
  write_paderborn(folder_ / "data/outer.mat", recording(lines.bpfo_hz, 6, "outer"));
  fs::copy_file(fs::path(PIAE_SOURCE) / "pipeline/bearings.csv", folder_ / "bearings.csv");
  folder_.write("datasets/rig.toml",
                "name = \"rig\"\nshaft_speed_rpm = 1797\n[bearing]\ndesignation = \"SKF 6205\"\n" +
                    described_normal + described_ir007 + described_or021 +
                    record("Normal", "\"healthy/acc_*.csv\"", "acceleration") +
                    record("IR007", "\"inner.tdms\"", "rig/acc") +
                    record("IR007", "\"inner.wav\"", "1") +
                    record("OR021", "[\"outer.mat\"]", "N09.Y[Name=vibration_1].Data"));
  run_well("ingest",
           {"--description", "datasets/rig.toml", "--data-dir", "data", "--output", "records.h5"});
  run_well("verify", {"records.h5"});
  run_well("split", {"--records", "records.h5", "--seed", "0", "--windows-per-class", "200",
                     "--test-per-class", "50", "--output-dir", "."});
  run_well("diagnose",
           {"--test", "A.h5", "--normal", "B.h5", "--known", "C.h5", "--ratio", "100to1", "--seed",
            "0", "--classifier", "nearest", "--output", "diagnosis.h5"});
  const artefact::Reader reader(folder_ / "diagnosis.h5", "diagnosis");
  EXPECT_GT(scoring::read_diagnosis(reader).accuracy(), 0.95);
}

/// The 12 files of the healthy record hold 6000 samples each: ten windows of 1024 at stride 512.
TEST_F(Formats, ManyFilesFormOneRecordWithAllDigests) {
  for (const char* name : {"2", "10", "1"}) {
    folder_.write(std::string("data/run/") + name, text(recording(0, 0.5, name)));
  }
  folder_.write("data/fault.csv", text(recording(90, 2, "fault")));
  folder_.write("rig.toml", described_bearing("rig") + described_normal + described_or021 +
                                record("Normal", "\"run/*\"", "2") +
                                record("OR021", "\"fault.csv\"", "2"));
  run_well("ingest", {"--description", "rig.toml", "--data-dir", "data", "--output", "records.h5"});
  const artefact::Reader records(folder_ / "records.h5", "records");
  EXPECT_EQ(records.numbers<std::int64_t>("/pieces/Normal", {0}).values,
            (std::vector<std::int64_t>{6000, 6000, 6000}));
  const auto inputs = records.strings(std::string(artefact::provenance_group) + "/inputs");
  std::vector<std::string> recordings;
  for (const std::string& input : inputs) {
    if (input.starts_with("recording ")) recordings.push_back(input);
  }
  ASSERT_EQ(recordings.size(), 4U);
  for (const std::string name : {"run/1", "run/2", "run/10", "fault.csv"}) {
    EXPECT_EQ(std::ranges::count(recordings, "recording " + name + " " +
                                                 sha256_of_file(folder_ / ("data/" + name))),
              1)
        << name;
  }
}

}  // namespace
}  // namespace piae::stages
