#include "text/csv.hpp"

#include <cmath>
#include <sstream>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/one_line.hpp"

namespace piae::text {

namespace {

std::string quoted_if_needed(const std::string& field) {
  if (field.find_first_of(",\"\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

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

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    line += (i > 0 ? "," : "") + quoted_if_needed(fields[i]);
  }
  return line + '\n';
}

void CsvLine::refuse(const std::string& what) const {
  throw Error(Exit::bad_input, one_line(place + ": " + what));
}

std::optional<double> CsvLine::number(std::size_t i) const {
  const std::optional<double> value = number_in<double>(fields[i]);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::vector<CsvLine> read_csv(const std::filesystem::path& path) {
  const Bytes bytes = artefact::read_file(path);
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  std::vector<CsvLine> lines;
  std::size_t number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (text.ends_with('\r')) text.pop_back();
    if (text.empty() || text.starts_with('#')) continue;
    lines.push_back({path.string() + ", line " + std::to_string(number), split_fields(text)});
    if (lines.back().fields.size() != lines.front().fields.size()) {
      lines.back().refuse("has " + std::to_string(lines.back().fields.size()) +
                          " fields, but the header has " +
                          std::to_string(lines.front().fields.size()));
    }
  }
  if (lines.size() < 2) throw Error(Exit::bad_input, path.string() + ": holds no table");
  return lines;
}

}  // namespace piae::text
