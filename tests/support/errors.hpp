#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace piae {

/// Returns the error that an action throws, if any.
inline std::optional<Error> error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

}  // namespace piae

/// Expects that the action throws an Error with this exit code and this text, in one line.
#define EXPECT_ERROR(action, code, text)                                                  \
  do {                                                                                    \
    const auto error = ::piae::error_of([&] { (void)(action); });                         \
    ASSERT_TRUE(error.has_value()) << "no error";                                         \
    EXPECT_EQ(error->exit(), code) << error->what();                                      \
    EXPECT_NE(std::string(error->what()).find(text), std::string::npos) << error->what(); \
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what(); \
  } while (false)
