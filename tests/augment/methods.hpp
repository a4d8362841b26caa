#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "augment/method.hpp"
#include "command_line.hpp"
#include "twin/known_windows.hpp"

namespace piae::augment {

/// The method with its options as the command line of `train` would set them.
inline std::unique_ptr<Method> method_with(const std::string& name, const std::string& options) {
  std::unique_ptr<Method> method = make_method(name);
  cli::parse(options, [&](const cli::Options& command) { method->bind(command); });
  return method;
}

inline std::filesystem::path scratch_file(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string prefix = std::string(test->test_suite_name()) + "." + test->name() + ".";
  for (char& c : prefix) c = c == '/' ? '_' : c;
  return std::filesystem::path(testing::TempDir()) / (prefix + name);
}

/// One that does not stand there yet.
inline nets::Checkpoint checkpoint_at(const std::string& name) {
  nets::Checkpoint checkpoint;
  checkpoint.path = scratch_file(name);
  std::filesystem::remove(checkpoint.path);
  checkpoint.interrupted = [] { return false; };
  return checkpoint;
}

/// Trains on the known windows and returns the stored model.
inline std::filesystem::path train(const std::string& method, const std::string& options,
                                   const signal::WindowSet& known,
                                   const nets::Checkpoint& checkpoint, const std::string& name) {
  artefact::Writer writer("model");
  method_with(method, options)->train(known, Stream("train"), {}, checkpoint, writer);
  std::filesystem::path path = scratch_file(name);
  writer.save(path, {});
  return path;
}

inline signal::WindowSet generate(const std::string& method, const std::filesystem::path& model,
                                  std::size_t count) {
  return make_method(method)->generate(artefact::Reader(model, "model"), count, Stream("generate"),
                                       {});
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

}  // namespace piae::augment
