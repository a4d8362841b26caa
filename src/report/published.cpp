#include "report/published.hpp"

#include <array>
#include <charconv>
#include <functional>
#include <span>
#include <sstream>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "report/grid.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

namespace {

namespace fs = std::filesystem;

/// The paper's "Model n" by the names of the grid: the full model, without the physics, without the
/// auto-encoder, with a convolutional one, with a recurrent one.
constexpr std::array<std::pair<const char*, const char*>, 5> models{{{"model1", "piae-dt"},
                                                                     {"model2", "ae"},
                                                                     {"model3", "physics"},
                                                                     {"model4", "piae-dt-cnn"},
                                                                     {"model5", "piae-dt-rnn"}}};

/// A line of a CSV file, which knows where it stands.
struct Line {
  std::string place;  // "table6-7-baseline.csv, line 3"
  std::vector<std::string> fields;

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(Exit::bad_input, place + ": " + what);
  }
  [[nodiscard]] double percent(std::size_t i) const {
    const std::string& field = fields[i];
    double value = -1;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    const bool whole = error == std::errc() && end == field.data() + field.size();
    if (!whole || !(value >= 0 && value <= 100)) refuse("'" + field + "' is not a percentage");
    return value;
  }
};

std::vector<std::string> split_fields(const std::string& text) {
  std::vector<std::string> fields{""};
  for (const char c : text) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

/// All lines but comments and empty ones; the first is the header, and no line is shorter or
/// longer.
std::vector<Line> read_lines(const fs::path& path) {
  const std::vector<std::byte> bytes = artefact::read_file(path);
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  std::vector<Line> lines;
  std::size_t number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (text.ends_with('\r')) text.pop_back();
    if (text.empty() || text.starts_with('#')) continue;
    lines.push_back({path.string() + ", line " + std::to_string(number), split_fields(text)});
    if (lines.back().fields.size() != lines.front().fields.size()) {
      lines.back().refuse("has " + std::to_string(lines.back().fields.size()) +
                          " fields, the header has " + std::to_string(lines.front().fields.size()));
    }
  }
  if (lines.size() < 2) throw Error(Exit::bad_input, path.string() + ": holds no table");
  return lines;
}

void require_header(const Line& header, std::size_t i, const std::string& word) {
  if (i >= header.fields.size() || header.fields[i] != word) {
    header.refuse("field " + std::to_string(i + 1) + " of the header must be '" + word + "'");
  }
}

void require_ratio(const Line& header, const std::string& name) {
  try {
    scoring::find_ratio(name);
  } catch (const Error& error) {
    header.refuse(error.what());
  }
}

std::string method_of_model(const Line& line) {
  for (const auto& [model, method] : models) {
    if (line.fields[1] == model) return method;
  }
  line.refuse("unknown model '" + line.fields[1] + "'; known are model1 to model5");
}

using Percents = std::map<std::tuple<std::string, std::string, std::string>, double>;

void add(Percents& percents, const Line& line, const std::string& method, const std::string& ratio,
         double percent) {
  const auto [place, is_new] = percents.try_emplace({line.fields[0], method, ratio}, percent);
  if (!is_new && place->second != percent) {
    line.refuse("contradicts another figure for " + method + " at " + ratio);
  }
}

/// A table with a method in each row, and a ratio in each column from the third.
void read_by_ratio(const fs::path& path, const std::string& second_column,
                   const std::function<std::string(const Line&)>& method_of, Percents& percents) {
  const std::vector<Line> lines = read_lines(path);
  const Line& header = lines.front();
  require_header(header, 0, "dataset");
  require_header(header, 1, second_column);
  for (std::size_t i = 2; i < header.fields.size(); ++i) require_ratio(header, header.fields[i]);
  for (const Line& line : std::span(lines).subspan(1)) {
    for (std::size_t i = 2; i < line.fields.size(); ++i) {
      add(percents, line, method_of(line), header.fields[i], line.percent(i));
    }
  }
}

}  // namespace

Published::Published(const fs::path& folder) {
  const std::vector<Line> lines = read_lines(folder / "table6-7-baseline.csv");
  const std::size_t average = lines.front().fields.size() - 1;
  require_header(lines.front(), 0, "dataset");
  for (std::size_t i = 1; i < average; ++i) {
    require_header(lines.front(), i, "run" + std::to_string(i));
  }
  require_header(lines.front(), average, "average");
  for (const Line& line : std::span(lines).subspan(1)) {
    std::vector<double>& runs = baseline_runs_[line.fields[0]];
    if (!runs.empty()) line.refuse("names dataset " + line.fields[0] + " again");
    for (std::size_t i = 1; i < average; ++i) runs.push_back(line.percent(i));
    add(percents_, line, no_method, scoring::all_ratios().front().name, line.percent(average));
  }
  read_by_ratio(
      folder / "table8-9-methods.csv", "method", [](const Line& line) { return line.fields[1]; },
      percents_);
  read_by_ratio(folder / "table10-11-ablation.csv", "model", method_of_model, percents_);
}

std::optional<double> Published::percent(const std::string& dataset, const std::string& method,
                                         const std::string& ratio) const {
  const auto found = percents_.find({dataset, method, ratio});
  if (found == percents_.end()) return std::nullopt;
  return found->second;
}

std::vector<double> Published::baseline_runs(const std::string& dataset) const {
  const auto found = baseline_runs_.find(dataset);
  return found == baseline_runs_.end() ? std::vector<double>{} : found->second;
}

}  // namespace piae::report
