#include "run/step_log.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <tuple>

#include "artefact/file.hpp"
#include "base/numbers.hpp"
#include "base/one_line.hpp"

namespace piae::run {

namespace fs = std::filesystem;

namespace {

/// Returns the text of a line between two texts; empty if the line does not match.
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

/// Returns the program of a command, which may follow a launcher: "srun --mem=2G build/bin/train
/// --config ...".
std::string program_of(const std::string& command) {
  std::string program;
  std::istringstream words(command);
  for (std::string word; words >> word;) {
    const std::size_t slash = word.rfind('/');
    const bool is_path = slash != std::string::npos && !word.starts_with('-');
    if (is_path) return word.substr(slash + 1);
    if (program.empty()) program = word;
  }
  return program;
}

/// Reads a line that a program wrote, after its name.
void read_line_of(const std::string& program, const std::string& line, StepLog& log) {
  if (line.starts_with(program + "  ")) log.last_progress = one_line(line);
  const std::string name = program + ": ";
  if (line.starts_with(name + "going on from ")) {  // nets/trainee.cpp
    log.went_on = true;
  } else if (log.reason.empty() && line.starts_with(name)) {
    log.reason = one_line(line.substr(name.size()));
  }
}

void read_line(const std::string& line, const std::string& program, StepLog& log) {
  // Older logs have "begun".
  for (const std::string_view start : {"step: started at ", "step: begun at "}) {
    if (const auto started = number_between(line, start, "")) log.started_s = started;
  }
  // Waiting in a queue does not count as run time.
  if (const auto waited = number_between(line, "step: waited ", " s"); waited && log.started_s) {
    *log.started_s += *waited;
  }
  if (const auto processor = number_between(line, "step: used ", " s ")) {
    log.processor_s = processor;
    const std::string_view memory = " and ";
    const std::size_t at = line.find(memory);
    if (at != std::string::npos) log.memory_mb = number_between(line.substr(at), memory, " MB");
  }
  if (const auto code = between(line, "step: exit ", " after ")) {
    log.exit_code = number_in<int>(*code).value_or(1);
    log.end = end_of(log.exit_code);
    const std::string before = "step: exit " + std::string(*code) + " after ";
    log.elapsed_s = number_between(line, before, " s").value_or(0);
  }
  read_line_of(program, line, log);
}

}  // namespace

StepLog read_step_log(const fs::path& file) {
  const Bytes bytes = artefact::read_file(file);
  std::istringstream lines(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  StepLog log;
  log.file = file;
  log.stage = file.stem().string();
  std::string program;
  for (std::string line; std::getline(lines, line);) {
    if (program.empty()) program = program_of(line);
    read_line(line, program, log);
    if (program != log.stage) read_line_of(log.stage, line, log);
  }
  if (log.end != StepEnd::failed) log.reason.clear();
  return log;
}

std::vector<StepLog> read_step_logs(const fs::path& folder) {
  std::vector<StepLog> logs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".log") continue;
    StepLog log = read_step_log(entry.path());
    if (!log.started_s) continue;
    log.file = entry.path().lexically_relative(folder);
    logs.push_back(std::move(log));
  }
  std::ranges::sort(logs, {},
                    [](const StepLog& log) { return std::tie(*log.started_s, log.file); });
  return logs;
}

}  // namespace piae::run
