#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "stages/tiny.hpp"

/// `monitor`: samples in, alarms out.
namespace piae::stages {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Monitored : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("score");
    Arguments arguments = with(step_of("diagnose").arguments, "--epochs", "12");
    arguments =
        with(with(arguments, "--output", "diagnosis.h5"), "--keep-classifier", "classifier.h5");
    const Outcome outcome = tiny_.run("diagnose", arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  /// Writes the raw samples of a machine to a file.
  void simulate(const std::string& class_name, double duration_s, double appears_at_s,
                const std::string& file) const {
    const Outcome outcome =
        tiny_.run("simulate", {"--description", "tiny.toml", "--stream", class_name, "--duration-s",
                               std::to_string(duration_s), "--appears-at-s",
                               std::to_string(appears_at_s), "--output", file});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  [[nodiscard]] Outcome monitor(const Arguments& more,
                                const Surroundings& surroundings = {}) const {
    return run(tiny_.path(), "monitor", arguments(more), surroundings);
  }
  [[nodiscard]] static Arguments arguments(const Arguments& more) {
    Arguments all{"--classifier", "classifier.h5"};
    all.insert(all.end(), more.begin(), more.end());
    if (std::ranges::find(all, "--sample-rate-hz") == all.end()) {
      all.insert(all.end(), {"--sample-rate-hz", "12000"});
    }
    if (std::ranges::find(all, "--speed-rpm") == all.end()) {
      all.insert(all.end(), {"--speed-rpm", "1797"});
    }
    return all;
  }

  /// Returns the time of the first line with an alarm, if any.
  static std::optional<double> alarm_s(const std::string& lines) {
    const std::size_t raised = lines.find("\"raised\"");
    if (raised == std::string::npos) return std::nullopt;
    const std::size_t line = lines.rfind("{\"time_s\": ", raised);
    return std::stod(lines.substr(line + 11));
  }

  /// Returns floats with swapped bytes.
  static std::string swapped(std::string floats) {
    for (std::size_t i = 0; i + 4 <= floats.size(); i += 4) {
      std::swap(floats[i], floats[i + 3]);
      std::swap(floats[i + 1], floats[i + 2]);
    }
    return floats;
  }
  /// Returns a header of one channel of floats at 12 kHz (0x2EE0), of unknown length.
  static std::string wav_header_of_a_pipe() {
    return {
        "RIFF\xFF\xFF\xFF\xFFWAVEfmt \x10\0\0\0\x03\0\x01\0\xE0\x2E\0\0\x80\xBB\0\0\x04\0\x20\0"
        "data\xFF\xFF\xFF\xFF",
        44};
  }

  Tiny tiny_;
};

TEST_F(Monitored, ADefectRaisesAnAlarmSoonAfterItAppears) {
  simulate("OR021", 20, 10, "raw.f32");
  Surroundings piped;
  piped.input = tiny_ / "raw.f32";
  const Outcome outcome = monitor({}, piped);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("monitor: 234 windows in 20.0 s of signal until its end: 1 "
                                     "alarm; nothing lost"));
  EXPECT_THAT(outcome.out, StartsWith("{\"time_s\": 1.024, \"windows\": 12, \"class\": "));
  const std::optional<double> at_s = alarm_s(outcome.out);
  ASSERT_TRUE(at_s.has_value()) << outcome.out;
  EXPECT_GT(*at_s, 10);
  EXPECT_LT(*at_s, 15);  // in time of the signal, not of the clock

  EXPECT_EQ(monitor({"--input", "raw.f32"}).out, outcome.out);
  EXPECT_EQ(monitor({"--input", "-"}, piped).out, outcome.out);
}

TEST_F(Monitored, AGrowingFileIsFollowedUntilSigterm) {
  simulate("OR021", 6, 0, "whole.f32");
  const std::string bytes = bytes_of(tiny_ / "whole.f32");
  write_bytes(tiny_ / "raw.f32", bytes.substr(0, 12000 * 4 + 2));  // within a sample
  Process following(tiny_.path(), "monitor",
                    arguments({"--input", "raw.f32", "--follow", "--every-s", "0"}));
  following.wait_until_it_says("\"time_s\": 0.939");
  std::ofstream(tiny_ / "raw.f32", std::ios::binary | std::ios::app) << bytes.substr(12000 * 4 + 2);
  following.wait_until_it_says("\"time_s\": 5.973");
  following.send(SIGTERM);
  const Outcome outcome = following.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, monitor({"--input", "whole.f32", "--every-s", "0"}).out);
  EXPECT_THAT(outcome.err,
              HasSubstr("70 windows in 6.0 s of signal until it was stopped: 1 alarm; nothing "
                        "lost"));
}

TEST_F(Monitored, AFileThatIsCutIsReadAnewAndSaidToBe) {
  simulate("Normal", 2, 0, "raw.f32");
  Process following(tiny_.path(), "monitor",
                    arguments({"--input", "raw.f32", "--follow", "--every-s", "0"}));
  following.wait_until_it_says("\"time_s\": 1.963");
  simulate("Normal", 1, 0, "other.f32");
  write_bytes(tiny_ / "raw.f32", bytes_of(tiny_ / "other.f32"));
  following.wait_until_it_says("\"time_s\": 2.939");
  following.send(SIGINT);
  const Outcome outcome = following.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("raw.f32: was truncated or replaced after 2.0 s of signal"));
  EXPECT_THAT(outcome.err, HasSubstr("lost: the file restarted 1 time"));
}

TEST_F(Monitored, WhatComesTooLateIsTold) {
  simulate("Normal", 1, 0, "raw.f32");
  ASSERT_EQ(::mkfifo((tiny_ / "pipe").c_str(), 0600), 0);
  Process listening(
      tiny_.path(), "monitor",
      arguments({"--input", "pipe", "--realtime", "--late-s", "0.3", "--every-s", "0"}));
  const std::string bytes = bytes_of(tiny_ / "raw.f32");
  std::ofstream recorder(tiny_ / "pipe", std::ios::binary);
  recorder << bytes << std::flush;
  listening.wait_until_it_says("\"time_s\": 0.939");
  // 0.6 s longer than the next samples take
  std::this_thread::sleep_for(std::chrono::milliseconds(1600));
  recorder << bytes << std::flush;
  recorder.close();
  const Outcome outcome = listening.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("after 1.0 s of signal, no samples arrive"));
  EXPECT_THAT(outcome.err, HasSubstr("s late"));
  EXPECT_THAT(outcome.err, HasSubstr("; late "));
}

/// Compares an hour of signal, sent through a pipe, with a minute.
TEST_F(Monitored, MemoryDoesNotGrowWithTime) {
  simulate("Normal", 60, 0, "minute.f32");
  const std::string minute = bytes_of(tiny_ / "minute.f32");
  ASSERT_EQ(::mkfifo((tiny_ / "pipe").c_str(), 0600), 0);
  const auto peak_kb = [&](int minutes) {
    Process listening(tiny_.path(), "monitor", arguments({"--input", "pipe"}));
    std::ofstream recorder(tiny_ / "pipe", std::ios::binary);
    for (int i = 0; i < minutes; ++i) recorder << minute;
    recorder.close();
    const Outcome outcome = listening.wait();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto windows = std::to_string(minutes * 60 * 12000 / 1024);
    EXPECT_THAT(outcome.err, HasSubstr(windows + " windows in "));
    return outcome.peak_kb;
  };
  const long of_a_minute = peak_kb(1);
  EXPECT_LT(peak_kb(60), 1.1 * static_cast<double>(of_a_minute));
}

TEST_F(Monitored, OtherFormatsSayTheSame) {
  simulate("OR021", 3, 0, "raw.f32");
  const std::string bytes = bytes_of(tiny_ / "raw.f32");
  std::string text;
  std::string doubles;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(float)) {
    float x = 0;
    std::memcpy(&x, bytes.data() + at, sizeof x);
    text += fmt::format("{}\n", x);
    const auto wide = static_cast<double>(x);
    doubles.append(reinterpret_cast<const char*>(&wide), sizeof wide);
  }
  write_bytes(tiny_ / "raw.txt", text);
  write_bytes(tiny_ / "raw.f64", doubles);
  write_bytes(tiny_ / "raw.f32be", swapped(bytes));
  write_bytes(tiny_ / "raw.wav", wav_header_of_a_pipe() + bytes);
  const std::string printed = monitor({"--input", "raw.f32"}).out;
  EXPECT_EQ(monitor({"--input", "raw.txt", "--format", "text"}).out, printed);
  EXPECT_EQ(monitor({"--input", "raw.f64", "--format", "f64"}).out, printed);
  EXPECT_EQ(monitor({"--input", "raw.f32be", "--format", "f32be"}).out, printed);
  Surroundings piped;
  piped.input = tiny_ / "raw.wav";
  const Outcome wav = monitor({"--format", "wav"}, piped);
  EXPECT_EQ(wav.out, printed);
  EXPECT_THAT(wav.err, HasSubstr("nothing lost"));
  expect_refusal(monitor({"--format", "wav", "--sample-rate-hz", "24000"}, piped), "monitor", 65,
                 {"standard input", "12000 Hz", "--sample-rate-hz is 24000"});
  expect_refusal(monitor({"--input", "raw.f32", "--format", "wav"}), "monitor", 65,
                 {"raw.f32", "does not begin like WAV"});
}

TEST_F(Monitored, AnotherByteOrderIsNamed) {
  simulate("Normal", 3, 0, "raw.f32");
  write_bytes(tiny_ / "raw.f32be", swapped(bytes_of(tiny_ / "raw.f32")));
  const Outcome outcome = monitor({"--input", "raw.f32be"});
  EXPECT_EQ(outcome.status, 65);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              HasSubstr("monitor: raw.f32be: non-finite samples broke every window ("));
  EXPECT_THAT(outcome.err, HasSubstr("of 36000 samples); is it --format f32be?\n"));
}

TEST_F(Monitored, AGarbledLineIsAGap) {
  std::string text;
  for (int i = 0; i < 4000; ++i) text += i == 1500 ? "12.3.4\n" : fmt::format("{:+d}\n", i % 7);
  write_bytes(tiny_ / "raw.txt", text);
  const Outcome outcome = monitor({"--input", "raw.txt", "--format", "text", "--every-s", "0"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("raw.txt, line 1501: '12.3.4' is not a number; a line of "
                                     "--format text must hold one sample; such lines are gaps"));
  EXPECT_THAT(outcome.err, HasSubstr("3 windows in 0.3 s of signal until its end"));
  EXPECT_THAT(outcome.err, HasSubstr("lost: 1 line not a number"));
}

TEST_F(Monitored, AStreamThatCannotFitIsRefused) {
  simulate("Normal", 1, 0, "raw.f32");
  const Arguments given{"--input", "raw.f32"};
  expect_refusal(monitor(with(given, "--sample-rate-hz", "8000")), "monitor", 65,
                 {"raw.f32", "8000 Hz", "12000 Hz"});
  expect_refusal(monitor(with(given, "--speed-rpm", "1200")), "monitor", 65,
                 {"raw.f32", "1200 rpm", "1797"});
  expect_refusal(monitor(with(given, "--healthy-share", "0.7")), "monitor", 2,
                 {"--healthy-share 0.7", "--faulty-share 0.5"});
  expect_refusal(monitor(with(given, "--input", "nowhere.f32")), "monitor", 66,
                 {"nowhere.f32", "No such file"});
  expect_refusal(monitor(with(given, "--input", ".")), "monitor", 66, {"is a folder"});
  expect_refusal(monitor({"--follow"}), "monitor", 2, {"--follow", "pipe"});
  expect_refusal(monitor(with(given, "--format", "mp3")), "monitor", 2, {"mp3", "f32"});
  write_bytes(tiny_ / "short.f32", std::string(1023 * 4, '\1'));
  expect_refusal(monitor({"--input", "short.f32"}), "monitor", 65,
                 {"short.f32", "1023 samples", "a window takes 0.0853 s"});
  write_bytes(tiny_ / "empty.f32", "");
  expect_refusal(monitor({"--input", "empty.f32"}), "monitor", 65, {"empty.f32", "0 samples"});
}

/// Errors of the stream begin with the stream's name.
TEST_F(Monitored, WhatIsWrongWithTheStreamNamesTheStream) {
  write_bytes(tiny_ / "raw.csv", "t,acc\n0,1\n");
  write_bytes(tiny_ / "empty.f32", "");
  EXPECT_THAT(monitor({"--input", "raw.csv", "--format", "text"}).err,
              StartsWith("monitor: raw.csv, line 1: 't,acc' is not a number; "));
  Surroundings piped;
  piped.input = tiny_ / "raw.csv";
  EXPECT_THAT(monitor({"--format", "text"}, piped).err,
              StartsWith("monitor: standard input, line 1: 't,acc' is not a number; "));
  EXPECT_THAT(monitor({"--speed-rpm", "1200"}, piped).err,
              StartsWith("monitor: standard input: was recorded at 1200 rpm"));
  piped.input = tiny_ / "empty.f32";
  EXPECT_THAT(monitor({}, piped).err, StartsWith("monitor: standard input: ended after 0 samples"));
}

TEST_F(Monitored, ADamagedClassifierIsRefused) {
  simulate("Normal", 1, 0, "raw.f32");
  const auto with_classifier = [&](const std::string& file) {
    return tiny_.run("monitor", with(arguments({"--input", "raw.f32"}), "--classifier", file));
  };
  expect_refusal(with_classifier("nowhere.h5"), "monitor", 66, {"nowhere.h5"});
  expect_refusal(with_classifier("records.h5"), "monitor", 65, {"records.h5", "'classifier'"});
  std::string bytes = bytes_of(tiny_ / "classifier.h5");
  write_bytes(tiny_ / "half.h5", bytes.substr(0, bytes.size() / 2));
  expect_refusal(with_classifier("half.h5"), "monitor", 65, {"half.h5"});
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_bytes(tiny_ / "flipped.h5", bytes);
  expect_refusal(with_classifier("flipped.h5"), "monitor", 65, {"flipped.h5"});
}

TEST_F(Monitored, AFullDiskIsAnError) {
  simulate("Normal", 10, 0, "raw.f32");
  Surroundings small_disk;
  small_disk.largest_file = 500;
  const Outcome outcome = monitor({"--input", "raw.f32"}, small_disk);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write to standard output"));
}

}  // namespace
}  // namespace piae::stages
