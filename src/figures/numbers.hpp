#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace piae::figures {

/// Numbers of a figure, as in its CSV file: one line per point, with words that describe the point.
class Numbers {
 public:
  explicit Numbers(const std::vector<std::string>& header);

  /// Throws std::logic_error for a row that is not as long as the header.
  void row(const std::vector<std::string>& fields);
  [[nodiscard]] const std::string& csv() const { return csv_; }

 private:
  std::size_t columns_;
  std::string csv_;
};

/// Returns a number with six significant digits, more than a picture can show.
std::string digits(double number);
/// Returns four significant digits, for figures with many points.
std::string few_digits(double number);

}  // namespace piae::figures
