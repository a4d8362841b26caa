#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace piae::signal {

/// A folder of its own for a test, removed afterwards.
class Folder {
 public:
  Folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "." + test->name();
    for (char& c : name) c = c == '/' ? '-' : c;
    path_ = std::filesystem::path(testing::TempDir()) / (name + "." + std::to_string(getpid()));
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

 private:
  std::filesystem::path path_;
};

/// The error that an action throws; none where it throws none.
inline std::optional<Error> error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

}  // namespace piae::signal

/// The action throws an Error with this exit code and, in one line, this text.
#define EXPECT_ERROR(action, code, text)                                                  \
  do {                                                                                    \
    const auto error = ::piae::signal::error_of([&] { (void)(action); });                 \
    ASSERT_TRUE(error.has_value()) << "no error";                                         \
    EXPECT_EQ(error->exit(), code) << error->what();                                      \
    EXPECT_NE(std::string(error->what()).find(text), std::string::npos) << error->what(); \
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what(); \
  } while (false)
