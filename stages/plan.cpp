// Prints which steps of a run are due, and why: for make, other programs and people.

#include <iostream>

#include "cli/checks.hpp"
#include "cli/stage.hpp"
#include "plan/goals.hpp"
#include "plan/planned.hpp"
#include "plan/printed.hpp"
#include "plan/request_options.hpp"

using namespace piae;

namespace {

constexpr int not_due = 3;  // exit code of --is-due; 1 would be the same as a failure of plan

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage("plan",
                   "Prints the steps of a run that are due, and why. A step is due if a file "
                   "that it makes is missing or damaged, if the settings that made it differ "
                   "from those of pipeline/, or if an input has changed.",
                   "plan --run try --datasets cwru --goals all");
  plan::RequestOptions requested;
  plan::PlanOptions options;
  plan::JobOptions jobs;
  plan::Format format = plan::Format::why;
  std::string due;
  std::string noted;
  bool quietly = false;
  bool whole = false;
  bind(stage.options(), requested);
  bind(stage.options(), options);
  stage.options().choose(
      "--format", format,
      {{"why", plan::Format::why},
       {"make", plan::Format::make},
       {"summary", plan::Format::summary},
       {"missing", plan::Format::missing},
       {"jobs", plan::Format::jobs},
       {"costs", plan::Format::costs}},
      "why: a line for each step; make: a makefile; summary: numbers of steps; missing: files "
      "that tables lack; jobs: lists for a cluster; costs: durations of steps, for jobs/costs.csv");
  stage.options().flag("--whole", whole,
                       "Plan the whole run, from its grid to its pages (formats why and summary)");
  stage.options().flag("--quietly", quietly, "Hide the commands of the makefile");
  stage.output_file("--jobs-folder", jobs.folder, "Folder for the lists of jobs").required(false);
  stage.options().add("--cores", jobs.cores, "Cores of a job").check(cli::whole_number(1, 100000));
  stage.options()
      .add("--minutes", jobs.minutes, "Minutes that a job takes")
      .check(cli::positive_number());
  stage.options().add("--is-due", due, "Exit with 0 if this step is due, with 3 if it is not");
  stage.options().add("--note", noted,
                      "Record that this step has made its files with the present settings");

  int result = 0;
  const int exit = stage.run(argc, argv, [&] {
    const plan::Request request = requested.request();
    if (!due.empty()) {
      result = planned_for(request, options, due)->is_due(due) ? 0 : not_due;
      return;
    }
    if (!noted.empty()) {
      const auto planned = planned_for(request, options, noted);
      planned->note(noted);
      return planned->save();
    }
    plan::Planned planned(request, options);
    if (options.stretch == plan::Stretch::grid) {  // the first stretch: print notices once
      for (const std::string& notice : planned.plan().choice().notices) std::cerr << notice << '\n';
    }
    if (whole) {
      std::cout << printed_whole(planned, format);
      return;
    }
    if (format == plan::Format::jobs) {
      plan::require_one_that([](const plan::Goal& goal) { return goal.is_submitted; },
                             request.goals);
    }
    std::cout << (format == plan::Format::make ? next_makefile(planned, quietly)
                                               : printed(planned.plan(), format, jobs));
    planned.save();
  });
  return exit == 0 ? result : exit;
}
