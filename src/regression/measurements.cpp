#include "regression/measurements.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "base/error.hpp"
#include "signal/ranges.hpp"
#include "text/csv.hpp"
#include "text/lines.hpp"

namespace piae::regression {

namespace {

namespace fs = std::filesystem;

const std::string version_mark = "# built from: ";
const std::string settings_mark = "# computed with: ";
const std::vector<std::string> columns{"method",   "classifier", "ratio",
                                       "quantity", "seed",       "value"};

void read_comments(const fs::path& path, Measurements& measurements) {
  for (const std::string& line : text::read_lines(path)) {
    if (!line.starts_with('#')) break;
    if (line.starts_with(version_mark)) {
      measurements.versions.insert(line.substr(version_mark.size()));
    }
    if (line.starts_with(settings_mark)) {
      measurements.settings.insert(line.substr(settings_mark.size()));
    }
  }
  if (measurements.versions.empty() || measurements.settings.empty()) {
    throw Error(Exit::bad_input, path.string() + ": lacks the first lines '" + version_mark +
                                     "...' and '" + settings_mark +
                                     "...'; store it again with `make reference`");
  }
}

Measured measured(const text::CsvLine& line) {
  const auto seed = line.number(4);
  const auto value = line.number(5);
  constexpr double most = 1e15;  // above this, a double cannot hold every whole number
  if (!seed || *seed < 0 || *seed > most || std::trunc(*seed) != *seed) {
    line.refuse("'" + line.fields[4] + "' is not a seed");
  }
  if (!value) line.refuse("'" + line.fields[5] + "' is not a number");
  return {.method = line.fields[0],
          .classifier = line.fields[1],
          .ratio = line.fields[2],
          .quantity = line.fields[3],
          .seed = static_cast<std::int64_t>(*seed),
          .value = *value};
}

}  // namespace

fs::path reference_file(const fs::path& folder, signal::Protocol protocol,
                        const std::string& dataset) {
  return folder / to_string(protocol) / (dataset + ".csv");
}

std::vector<std::string> reference_datasets(const fs::path& folder, signal::Protocol protocol) {
  std::vector<std::string> names;
  const fs::path below = folder / to_string(protocol);
  if (!fs::is_directory(below)) return names;
  for (const auto& entry : fs::directory_iterator(below)) {
    const std::string name = entry.path().stem().string();
    // Tables of several data sets are in the same folder. A data set cannot have such a name.
    if (entry.path().extension() == ".csv" && signal::ranges::is_plain_name(name)) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

std::string reference_csv(const Measurements& measurements) {
  std::string text = fmt::format(
      "# {}, protocol {}: what `make check` compares runs with; made by "
      "`make reference`\n",
      measurements.dataset, to_string(measurements.protocol));
  for (const std::string& version : measurements.versions) text += version_mark + version + '\n';
  for (const std::string& setting : measurements.settings) text += settings_mark + setting + '\n';
  text += text::csv_line(columns);
  for (const Measured& each : measurements.values) {
    text += text::csv_line({each.method, each.classifier, each.ratio, each.quantity,
                            std::to_string(each.seed), fmt::format("{}", each.value)});
  }
  return text;
}

Measurements read_reference(const fs::path& folder, signal::Protocol protocol,
                            const std::string& dataset) {
  const fs::path path = reference_file(folder, protocol, dataset);
  if (!fs::exists(path)) {
    throw Error(Exit::input_missing, path.string() + ": there is no reference for " + dataset +
                                         "; store one from a good run with `make reference "
                                         "RUN=...`");
  }
  const std::vector<text::CsvLine> lines = text::read_csv(path);
  if (lines.front().fields != columns) lines.front().refuse("is not the header of a reference");
  Measurements measurements{.dataset = dataset, .protocol = protocol};
  read_comments(path, measurements);
  std::set<std::tuple<std::string, std::string, std::string, std::string, std::int64_t>> seen;
  for (const text::CsvLine& line : std::span(lines).subspan(1)) {
    const Measured& each = measurements.values.emplace_back(measured(line));
    if (!seen.emplace(each.method, each.classifier, each.ratio, each.quantity, each.seed).second) {
      line.refuse("repeats an earlier line");
    }
  }
  return measurements;
}

}  // namespace piae::regression
