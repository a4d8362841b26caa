#include "figures/numbers.hpp"

#include <spdlog/fmt/fmt.h>

#include <stdexcept>

#include "text/csv.hpp"

namespace piae::figures {

Numbers::Numbers(const std::vector<std::string>& header)
    : columns_(header.size()), csv_(text::csv_line(header)) {}

void Numbers::row(const std::vector<std::string>& fields) {
  if (fields.size() != columns_) throw std::logic_error("a row is not as long as the header");
  csv_ += text::csv_line(fields);
}

std::string digits(double number) { return fmt::format("{:.6g}", number); }
std::string few_digits(double number) { return fmt::format("{:.4g}", number); }

}  // namespace piae::figures
