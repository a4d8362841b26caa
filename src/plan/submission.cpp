#include "plan/submission.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "plan/words.hpp"
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

}  // namespace

Submission read_submission(std::istream& lines) {
  Submission submission;
  for (std::string line; std::getline(lines, line);) {
    Words fields = fields_of(line, '\t');
    for (std::string& field : fields) field = one_line(field);
    fields.resize(4);
    if (fields[0] == "submission") submission.folder = fields[1];
    if (fields[0] == "queue") submission.queue.push_back({fields[1], fields[2], fields[3]});
    if (fields[0] == "ended") submission.ended.push_back({fields[1], fields[2]});
  }
  if (submission.folder.empty()) return submission;
  std::vector<std::string> choice = lines_of(submission.folder / "choice");
  for (std::string& word : choice) word = one_line(word);
  if (choice.empty()) return submission;
  submission.goal = choice.front();
  submission.variables.assign(choice.begin() + 1, choice.end());
  return submission;
}

void take_submission(const Submission& submission, Request& request, bool any_goal_given) {
  if (submission.folder.empty()) return;
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

}  // namespace piae::plan
