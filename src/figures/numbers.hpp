#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace piae::figures {

/// The numbers behind a figure, as its CSV file has them: one line a point, with words that say
/// what the point belongs to.
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

/// A number with six significant digits, which is more than a picture can show.
std::string digits(double number);
/// With four, where there are many points.
std::string few_digits(double number);

}  // namespace piae::figures
