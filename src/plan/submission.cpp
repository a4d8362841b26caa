#include "plan/submission.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "plan/job_log.hpp"
#include "plan/words.hpp"
#include "run/step_log.hpp"
#include "text/lines.hpp"

namespace piae::plan {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> lines_of(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return {};
  try {
    return text::read_lines(file);
  } catch (const Error&) {
    return {};
  }
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<JobLog> job_logs_in(const fs::path& folder) {
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".log") files.insert(entry.path());
  }
  std::vector<JobLog> logs;
  logs.reserve(files.size());
  for (const fs::path& file : files) {
    logs.push_back(read_job_log(file.stem().string(), lines_of(file)));
  }
  return logs;
}

/// Returns the jobs that failed and are not in the queue again.
std::vector<Submission::Ended> ended_of(const Submission& submission) {
  const auto queued = [&](const std::string& kind) {
    return std::ranges::count(submission.queue, kind, &Submission::Queued::kind) > 0;
  };
  const bool queue_is_known = !queued("?");
  std::vector<Submission::Ended> ended;
  for (const JobLog& log : job_logs_in(submission.folder)) {
    if (log.why.empty() || queued(log.job)) continue;
    if (log.why != "killed" || queue_is_known) ended.push_back({log.job, log.why});
  }
  return ended;
}

/// Returns the folder of the run that was submitted and those of other runs that its lists name:
/// results/try and results/try-blocked.
std::set<fs::path> runs_of(const fs::path& submission) {
  const fs::path named = (submission / "").parent_path();  // without a slash at its end
  const fs::path run = named.parent_path().parent_path();
  const fs::path results = run.parent_path();
  std::set<fs::path> runs{run};
  for (const fs::directory_entry& list : fs::directory_iterator(submission)) {
    const std::string name = list.path().filename().string();
    if (name != "records" && !name.starts_with("cells")) continue;
    if (list.path().extension() == ".log") continue;
    for (const std::string& file : lines_of(list.path())) {
      const Words parts = fields_of(file, '/');  // results/RUN/DATASET/...
      if (parts.size() > 2 && parts[0] == results.filename()) runs.insert(results / parts[1]);
    }
  }
  std::erase_if(runs, [](const fs::path& folder) { return !fs::is_directory(folder); });
  return runs;
}

double seconds_since_1970(std::chrono::system_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

}  // namespace

Submission read_submission(std::istream& lines) {
  Submission submission;
  for (std::string line; std::getline(lines, line);) {
    Words fields = fields_of(line, '\t');
    for (std::string& field : fields) field = one_line(field);
    fields.resize(4);
    if (fields[0] == "submission") submission.folder = fields[1];
    if (fields[0] == "queue") submission.queue.push_back({fields[1], fields[2], fields[3]});
  }
  if (!fs::is_directory(submission.folder)) return submission;
  submission.ended = ended_of(submission);
  std::vector<std::string> choice = lines_of(submission.folder / "choice");
  for (std::string& word : choice) word = one_line(word);
  if (choice.empty()) return submission;
  submission.goal = choice.front();
  submission.variables.assign(choice.begin() + 1, choice.end());
  return submission;
}

void take_submission(const Submission& submission, Request& request, bool any_goal_given) {
  if (submission.folder.empty()) return;
  if (submission.goal.empty() && !any_goal_given) {
    throw Error(Exit::bad_input, (submission.folder / "choice").string() +
                                     ": is missing or empty; remove the folder, or name a goal "
                                     "(`make status all`)");
  }
  if (!any_goal_given) request.goals = {submission.goal};
  if (request.goals != std::vector<std::string>{submission.goal}) return;
  const auto take = [&](const std::string& name, std::optional<std::string>& value) {
    for (const std::string& word : submission.variables) {
      if (!value && word.starts_with(name + '=')) value = word.substr(name.size() + 1);
    }
  };
  take("DATASETS", request.datasets);
  take("METHODS", request.methods);
  take("RATIOS", request.ratios);
  take("CLASSIFIERS", request.classifiers);
  take("SEEDS", request.seeds);
}

EndedJobs ended_jobs(const Submission& submission) {
  EndedJobs jobs;
  for (const Submission::Ended& ended : submission.ended) {
    if (ended.job == "tables") jobs.of_tables = ended.why;
    for (const std::string& file : lines_of(submission.folder / ended.job)) {
      jobs.by_file.emplace(file, ended.why);
    }
  }
  return jobs;
}

std::string listed_jobs(const Submission& submission) {
  std::string text;
  std::vector<std::string> states;
  std::map<std::string, std::size_t> counts;
  for (const Submission::Queued& job : submission.queue) {
    const std::string kind = job.kind.substr(0, job.kind.find('.'));
    std::string state = lower(job.state);
    if (state == "pending" && job.reason != "None") state += " (" + job.reason + ")";
    const std::string line = job.kind == "?" ? job.reason : fmt::format("{}\t{}", kind, state);
    if (counts[line]++ == 0) states.push_back(line);
  }
  for (const std::string& state : states) {
    const std::size_t tab = state.find('\t');
    text += tab == std::string::npos ? fmt::format("  {}\n", state)
                                     : fmt::format("  {}: {} {}\n", state.substr(0, tab),
                                                   counts[state], state.substr(tab + 1));
  }
  for (const Submission::Ended& ended : submission.ended) {
    text += fmt::format("  {}: {} (log: {}/{}.log)\n", ended.job, ended.why,
                        submission.folder.string(), ended.job);
  }
  if (!text.empty()) text = "\njobs\n" + text;
  for (const std::string& line : lines_of(submission.folder / "tables.log")) {
    if (line.starts_with("spent: ")) text += one_line(line) + '\n';
  }
  return text;
}

std::string spent_by_submission(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "choice")) {
    throw Error(Exit::input_missing, folder.string() +
                                         ": is not the folder of a submission; name " +
                                         "one such as results/try/.jobs/20261127T120000");
  }
  const double submitted_s =
      seconds_since_1970(std::chrono::file_clock::to_sys(fs::last_write_time(folder / "choice")));
  std::size_t steps = 0;
  for (const fs::path& run : runs_of(folder)) {
    steps += static_cast<std::size_t>(
        std::ranges::count_if(run::read_step_logs(run), [&](const run::StepLog& log) {
          return *log.started_s > submitted_s && log.end == run::StepEnd::done;
        }));
  }
  return spent_by(job_logs_in(folder), submitted_s,
                  seconds_since_1970(std::chrono::system_clock::now()), steps);
}

}  // namespace piae::plan
