#include <gtest/gtest.h>

#include "stages/tiny.hpp"

/// `simulate --stream`: an endless machine.
namespace piae::stages {
namespace {

Arguments machine(const std::string& class_name, const std::string& output) {
  return {"--description", "tiny.toml",      "--stream", class_name, "--duration-s",
          "2.5",           "--appears-at-s", "1",        "--output", output};
}

TEST(Machine, IsWrittenToAFileOrToStandardOutput) {
  const Tiny tiny;
  const Outcome to_file = tiny.run("simulate", machine("OR021", "raw.f32"));
  EXPECT_EQ(to_file.status, 0) << to_file.err;
  EXPECT_EQ(to_file.out, "");
  EXPECT_EQ(to_file.err, "simulate: 30000 samples of float32 at 12000 Hz: raw.f32\n");
  const std::string bytes = bytes_of(tiny / "raw.f32");
  EXPECT_EQ(bytes.size(), 30000 * sizeof(float));

  const Outcome piped = tiny.run("simulate", machine("OR021", "-"));
  EXPECT_EQ(piped.status, 0) << piped.err;
  EXPECT_TRUE(piped.out == bytes);
  const Outcome healthy = tiny.run("simulate", machine("Normal", "-"));
  EXPECT_TRUE(healthy.out.substr(0, 12000 * 4) == bytes.substr(0, 12000 * 4));
  EXPECT_TRUE(healthy.out != bytes);
}

TEST(Machine, ImpossibleOptionsAreRefused) {
  const Tiny tiny;
  expect_refusal(tiny.run("simulate", machine("OR007", "raw.f32")), "simulate", 2,
                 {"--stream OR007", "Normal, IR007, OR021"});
  expect_refusal(tiny.run("simulate", with(machine("OR021", "raw.f32"), "--appears-at-s", "3")),
                 "simulate", 2, {"--appears-at-s 3", "--duration-s"});
  expect_refusal(tiny.run("simulate", with(machine("OR021", "raw.f32"), "--drift-s", "0")),
                 "simulate", 2, {"--drift-s"});
  expect_refusal(tiny.run("simulate", machine("OR021", "nowhere/raw.f32")), "simulate", 1,
                 {"nowhere/raw.f32", "No such file"});
  expect_refusal(tiny.run("simulate", with(step_of("simulate").arguments, "--seed", "1")),
                 "simulate", 2, {"--seed", "--stream"});
  EXPECT_EQ(tiny.files(), std::set<std::string>{"tiny.toml"});
}

TEST(Machine, FullDiskIsAnError) {
  const Tiny tiny;
  Surroundings small_disk;
  small_disk.largest_file = 2000;
  expect_refusal(run(tiny.path(), "simulate", machine("OR021", "raw.f32"), small_disk), "simulate",
                 1, {"raw.f32", "File too large"});
}

}  // namespace
}  // namespace piae::stages
