#include "plan/job_log.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <regex>

#include "base/numbers.hpp"
#include "base/one_line.hpp"

namespace piae::plan {

namespace {

double number_of(const std::string& text) { return number_in<double>(text).value_or(0); }

/// Reads a line of jobs/job.sbatch: the start or the end of a life.
void read_life(const std::string& line, JobLog& log) {
  // Jobs that were submitted before an update write "begun".
  static const std::regex started("job: life (?:started|begun) at (\\d+) on .*, (\\d+) cores");
  static const std::regex ended("job: life ended at (\\d+), used ([\\d.]+) s, status (\\d+): (.*)");
  std::smatch found;
  if (std::regex_match(line, found, started)) {
    JobLife& life = log.lives.emplace_back();
    life.start_s = number_of(found[1]);
    life.cores = static_cast<int>(number_of(found[2]));
    log.why = "killed";
  } else if (std::regex_match(line, found, ended)) {
    if (!log.lives.empty()) {
      log.lives.back().end_s = number_of(found[1]);
      log.lives.back().used_s = number_of(found[2]);
    }
    log.why = found[3] == "0" ? "" : one_line(found[4].str());
  }
}

/// Reads Slurm's message about a job that it ends.
void read_words_of_slurm(const std::string& line, JobLog& log) {
  static const std::regex memory("oom.kill|out of memory|exceeded (job )?memory limit",
                                 std::regex::icase);
  static const std::regex cancelled("CANCELLED AT .* \\*\\*\\*");
  const std::string out_of_memory = "out of memory";
  if (std::regex_search(line, memory)) log.why = out_of_memory;
  if (line.find("DUE TO TIME LIMIT") != std::string::npos && log.why != out_of_memory) {
    log.why = "out of time";
  }
  if (line.find("DUE TO NODE FAILURE") != std::string::npos) log.why = "its node failed";
  if (log.why == "killed" && std::regex_search(line, cancelled)) log.why = "cancelled";
}

/// Returns the seconds between `start_s` and the end of the last life in which no job ran.
double idle_seconds(std::vector<JobLife> lives, double start_s) {
  std::ranges::sort(lives, {}, &JobLife::start_s);
  double idle_s = 0;
  for (const JobLife& life : lives) {
    idle_s += std::max(0.0, life.start_s - start_s);
    start_s = std::max(start_s, *life.end_s);
  }
  return idle_s;
}

std::string duration_label(double seconds) {
  return seconds < 120 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

}  // namespace

JobLog read_job_log(const std::string& job, const std::vector<std::string>& lines) {
  JobLog log{.job = job};
  for (const std::string& line : lines) {
    read_life(line, log);
    read_words_of_slurm(line, log);
  }
  return log;
}

std::string spent_by(const std::vector<JobLog>& jobs, double submitted_s, double now_s,
                     std::size_t steps) {
  constexpr double hour_s = 3600;
  std::vector<JobLife> lives;
  std::size_t started = 0;
  for (const JobLog& job : jobs) {
    started += job.lives.size();
    std::ranges::copy_if(job.lives, std::back_inserter(lives),
                         [](const JobLife& life) { return life.end_s.has_value(); });
    if (job.job == "tables" && !job.lives.empty() && !job.lives.back().end_s) {
      lives.push_back(job.lives.back());
      lives.back().end_s = now_s;
    }
  }
  double used_s = 0;
  double allocated_s = 0;
  for (const JobLife& life : lives) {
    used_s += life.used_s;
    allocated_s += (*life.end_s - life.start_s) * life.cores;
  }
  std::string text = fmt::format(
      "spent: {} steps in {} jobs; {:.2f} core-hours used of {:.2f} allocated ({:.0f} %); {} from "
      "submission to end, of which {} in the queue alone\n",
      steps, jobs.size(), used_s / hour_s, allocated_s / hour_s,
      allocated_s > 0 ? 100 * used_s / allocated_s : 0, duration_label(now_s - submitted_s),
      duration_label(idle_seconds(lives, submitted_s)));
  if (started > jobs.size()) {
    text += fmt::format("spent: {} jobs began again (out of time, or a node was lost)\n",
                        started - jobs.size());
  }
  if (const std::size_t killed = started - lives.size(); killed > 0) {
    text += fmt::format("spent: {} lives were killed, whose time is not counted\n", killed);
  }
  return text;
}

}  // namespace piae::plan
