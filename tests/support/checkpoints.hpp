#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "nets/trainee.hpp"

namespace piae {

/// Returns a file name that only the running test uses; the file need not exist.
inline std::filesystem::path scratch_file(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string prefix = std::string(test->test_suite_name()) + "." + test->name() + ".";
  for (char& c : prefix) c = c == '/' ? '_' : c;
  return std::filesystem::path(testing::TempDir()) / (prefix + name);
}

/// Returns a checkpoint without a file and without interruption.
inline nets::Checkpoint checkpoint_at(const std::string& name) {
  nets::Checkpoint checkpoint;
  checkpoint.path = scratch_file(name);
  std::filesystem::remove(checkpoint.path);
  checkpoint.interrupted = [] { return false; };
  return checkpoint;
}

}  // namespace piae
