#include "trend/trend_point.hpp"

#include <gtest/gtest.h>

#include "trend/healthy_hours.hpp"

namespace piae::trend {
namespace {

TrendPoint risen() {
  TrendPoint point{.time_s = 17300.1, .windows = 3, .evidence = 1};
  point.alarm = monitor::AlarmState::raised;
  point.cause = "12.5-25 Hz";
  point.rises = {.level_db = 2.305, .watched_db = Eigen::ArrayXd::Zero(7), .novelty = 0.984};
  point.rises->watched_db[1] = 9.04;
  return point;
}

TEST(TrendPoint, IsALineOfJson) {
  EXPECT_EQ(json_line(risen(), noise_meter().names()),
            "{\"time_s\": 17300.100, \"windows\": 3, \"level_db\": 2.31, \"rise_db\": 9.04, "
            "\"feature\": \"12.5-25 Hz\", \"line_db\": null, \"line\": null, \"novelty\": 0.98, "
            "\"evidence\": 1.0000, \"alarm\": \"raised\", \"cause\": \"12.5-25 Hz\"}\n");
}

TEST(TrendPoint, NamesTheHighestLine) {
  TrendPoint point = risen();
  point.rises->watched_db.conservativeResize(10);
  point.rises->watched_db.tail(3) = Eigen::ArrayXd::LinSpaced(3, 1, 2);
  std::vector<std::string> names = noise_meter().names();
  for (const std::string name : {"inner line", "roller line", "outer line"}) names.push_back(name);
  EXPECT_NE(json_line(point, names).find("\"line_db\": 2.00, \"line\": \"outer\""),
            std::string::npos);
}

TEST(TrendPoint, IsNullWithoutASignal) {
  TrendPoint point = risen();
  point.rises.reset();
  point.cause = "";
  EXPECT_NE(
      json_line(point, noise_meter().names())
          .find("\"level_db\": null, \"rise_db\": null, \"feature\": null, \"line_db\": null, "
                "\"line\": null, \"novelty\": null, \"evidence\""),
      std::string::npos);
}

}  // namespace
}  // namespace piae::trend
