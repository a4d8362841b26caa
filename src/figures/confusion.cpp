#include "figures/confusion.hpp"

#include <numeric>

#include "figures/most_windows.hpp"

namespace piae::figures {

namespace {

void add_matrix(Numbers& numbers, const MethodDiagnoses& method) {
  const scoring::Confusion confusion = method.confusion();
  const auto name_of = [&](std::size_t i) { return method.info().classes[i].name; };
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    std::int64_t windows = 0;
    for (std::size_t i = 0; i < confusion.classes; ++i) windows += confusion.at(truth, i);
    for (std::size_t predicted = 0; windows > 0 && predicted < confusion.classes; ++predicted) {
      const std::int64_t count = confusion.at(truth, predicted);
      std::vector<std::string> row = method.fields();
      row.insert(row.end(),
                 {name_of(truth), name_of(predicted), std::to_string(count),
                  digits(100.0 * static_cast<double>(count) / static_cast<double>(windows))});
      numbers.row(row);
    }
  }
}

}  // namespace

Numbers confusions(Source& source) {
  Numbers numbers({"method", "ceiling", "ratio", "truth", "predicted", "windows", "percent"});
  for (const MethodDiagnoses& method : diagnoses_with_most_windows(source)) {
    add_matrix(numbers, method);
  }
  return numbers;
}

}  // namespace piae::figures
