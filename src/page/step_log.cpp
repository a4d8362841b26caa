#include "page/step_log.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <tuple>

#include "artefact/file.hpp"
#include "base/numbers.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// What stands in a line between two texts; empty where the line is another.
std::optional<std::string_view> between(std::string_view line, std::string_view before,
                                        std::string_view after) {
  if (!line.starts_with(before)) return std::nullopt;
  line.remove_prefix(before.size());
  const std::size_t end = after.empty() ? line.size() : line.find(after);
  if (end == std::string_view::npos) return std::nullopt;
  return line.substr(0, end);
}

std::optional<double> number_between(std::string_view line, std::string_view before,
                                     std::string_view after) {
  const auto text = between(line, before, after);
  return text ? number_in<double>(*text) : std::nullopt;
}

StepEnd end_of(int exit_code) {
  constexpr int after_checkpoint = 75;
  constexpr int signals[] = {129, 130, 131, 138, 143};  // hung up, Ctrl-C, Ctrl-\, USR1, terminated
  if (exit_code == 0) return StepEnd::done;
  const bool stopped =
      exit_code == after_checkpoint || std::ranges::find(signals, exit_code) != std::end(signals);
  return stopped ? StepEnd::interrupted : StepEnd::failed;
}

void read_line(const std::string& line, StepLog& log) {
  if (const auto begun = number_between(line, "step: begun at ", "")) log.begun_s = begun;
  // Its place in a queue is no part of a step.
  if (const auto waited = number_between(line, "step: waited ", " s"); waited && log.begun_s) {
    *log.begun_s += *waited;
  }
  if (const auto processor = number_between(line, "step: used ", " s ")) {
    log.processor_s = processor;
    const std::string_view memory = " and ";
    const std::size_t at = line.find(memory);
    if (at != std::string::npos) log.memory_mb = number_between(line.substr(at), memory, " MB");
  }
  if (const auto code = between(line, "step: exit ", " after ")) {
    log.end = end_of(number_in<int>(*code).value_or(1));
    const std::string before = "step: exit " + std::string(*code) + " after ";
    log.elapsed_s = number_between(line, before, " s").value_or(0);
  }
  const std::string name = log.stage + ": ";
  if (line.starts_with(name + "going on from ")) {  // nets/trainee.cpp
    log.went_on = true;
    return;
  }
  if (log.reason.empty() && line.starts_with(name)) log.reason = line.substr(name.size());
}

}  // namespace

StepLog read_step_log(const fs::path& file) {
  const Bytes bytes = artefact::read_file(file);
  std::istringstream lines(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  StepLog log;
  log.file = file;
  log.stage = file.stem().string();
  for (std::string line; std::getline(lines, line);) read_line(line, log);
  if (log.end != StepEnd::failed) log.reason.clear();
  return log;
}

std::vector<StepLog> read_step_logs(const fs::path& folder) {
  std::vector<StepLog> logs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".log") continue;
    StepLog log = read_step_log(entry.path());
    if (!log.begun_s) continue;
    log.file = entry.path().lexically_relative(folder);
    logs.push_back(std::move(log));
  }
  std::ranges::sort(logs, {}, [](const StepLog& log) { return std::tie(*log.begun_s, log.file); });
  return logs;
}

}  // namespace piae::page
