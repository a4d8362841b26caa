// Shows the progress of a run.

#include "plan/status.hpp"

#include <fstream>
#include <iostream>
#include <sstream>

#include "cli/stage.hpp"
#include "plan/goals.hpp"
#include "plan/request_options.hpp"
#include "plan/submission.hpp"

using namespace piae;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  cli::Stage stage(
      "status",
      "Shows how far a run is: the cells of every data set and method that are done, running, "
      "failed and missing; an estimate of the time left; the steps that run and those that failed. "
      "What settings of before have made counts as missing. Reads only; a run may go on meanwhile.",
      "status --run try --datasets cwru --goals all");
  plan::RequestOptions requested;
  fs::path pipeline = "pipeline";
  fs::path queue;
  fs::path submission_folder;
  bind(stage.options(), requested);
  stage.input_file("--pipeline", pipeline, "Folder with protocol.toml and datasets/")
      .required(false);
  stage.input_file("--queue", queue, "What jobs/queue.sh says of the run's jobs").required(false);
  stage.input_file("--spent", submission_folder, "Say only what the jobs of this submission spent")
      .required(false);

  return stage.run(argc, argv, [&] {
    if (!submission_folder.empty()) {
      std::cout << plan::spent_by_submission(submission_folder);
      return;
    }
    std::istringstream nothing;
    std::ifstream lines(queue);
    const plan::Submission submission =
        plan::read_submission(queue.empty() ? static_cast<std::istream&>(nothing) : lines);
    plan::Request request = requested.request();
    take_submission(submission, request, !requested.goals.empty());
    plan::require_one_that([](const plan::Goal& goal) { return !goal.counts.empty(); },
                           request.goals);
    plan::PlanOptions look{.pipeline = pipeline, .looks = true};
    plan::Planned planned(request, look);
    plan::Plan& plan = planned.plan();
    plan::RealLogs logs;
    const auto states = step_states(plan, logs, ended_jobs(submission));
    std::cout << status_table(plan, states, logs) << listed_steps(plan, states)
              << listed_jobs(submission);
  });
}
