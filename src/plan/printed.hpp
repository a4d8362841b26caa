#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "plan/costs.hpp"
#include "plan/plan.hpp"
#include "plan/planned.hpp"

namespace piae::plan {

/// Output formats of a plan.
enum class Format { make, why, summary, missing, jobs, costs };

/// Division of the steps among jobs of a cluster, and the folder for their lists.
struct JobOptions {
  std::filesystem::path folder;
  std::size_t cores = 4;
  double minutes = 15;
};

/// Returns the steps to be run as a makefile: one rule a step, with its name, the steps that it
/// needs and its command. Rule names are not files, so file times do not count. Returns an empty
/// text if nothing is to be run. `quietly` hides the commands, as make's @ does.
std::string makefile_of(Plan& plan, bool quietly);

/// Lists the steps to be run with the reason, for people: one line a step, or one line for many
/// steps with the same reason. Returns an empty text if nothing is to be run.
std::string why_of(Plan& plan);

/// Returns the amount of work: steps, processor time, memory; empty if nothing is to be run.
std::string summary_of(Plan& plan, const Costs& costs);

/// Returns a line that names the steps to be run with unknown cost; empty if there are none.
std::string guessed_costs_of(Plan& plan, const Costs& costs);

/// Lists the missing files behind the tables, at most the first hundred; empty if none is missing.
std::string missing_of(Plan& plan);

/// Returns the makefile of the first stretch, from the requested one on, that has steps to run. The
/// first line names this stretch and the next one: "# numbers pictures". If nothing is to be run,
/// returns "# shown" and the tables of the goals. Requested files belong to one stretch only.
/// Writes the settings files of the steps, except in a plan that only looks.
std::string next_makefile(Planned& planned, bool quietly);

/// Prints a plan in a format other than make.
std::string printed(Plan& plan, Format format, const JobOptions& jobs);

/// Prints the first stretch of a run that has steps to run, and names the later stretches: their
/// steps depend on files that do not exist yet. Throws Error(usage) for formats other than why and
/// summary.
std::string printed_whole(Planned& planned, Format format);

}  // namespace piae::plan
