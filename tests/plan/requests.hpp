#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "plan/request.hpp"
#include "plan/small_run.hpp"

namespace piae::plan {

/// A request for a part of the small run.
class Requests : public testing::Test {
 protected:
  Requests() : experiment_(read_experiment(run_.pipeline.path())), request_(run_.request) {}

  /// Returns the error line of the request.
  [[nodiscard]] std::string refusal() const {
    try {
      (void)choose(experiment_, request_);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::usage);
      return error.what();
    }
    return "not refused";
  }

  SmallRun run_;
  Experiment experiment_;
  Request request_;
};

}  // namespace piae::plan
