#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "plan/costs.hpp"
#include "plan/plan.hpp"
#include "plan/planned.hpp"

namespace piae::plan {

/// The ways to print a plan.
enum class Format { make, why, summary, missing, jobs, costs };

/// How the steps are divided among jobs of a cluster, and the folder that gets their lists.
struct JobOptions {
  std::filesystem::path folder;
  std::size_t cores = 4;
  double minutes = 15;
};

/// The steps that are to be run as a makefile: a rule for each, of its name, the steps that it
/// waits for, and its command. Names are no files to make, so what is due is run whatever its times
/// are. Empty where nothing is to be run. `quietly` hides the commands, as make's @ does.
std::string makefile_of(Plan& plan, bool quietly);

/// Lists the steps to be run and the reason, for people: a line for each step, or for many with the
/// same reason; empty where there is none.
std::string why_of(Plan& plan);

/// How much there is to be run: steps, processor time, memory; empty where nothing is.
std::string summary_of(Plan& plan, const Costs& costs);

/// A line that names the steps to be run of which no cost is known; empty where there is none.
std::string guessed_costs_of(Plan& plan, const Costs& costs);

/// The files that are missing of those that tables are made of, the first hundred of them; empty
/// where none is.
std::string missing_of(Plan& plan);

/// Gives the makefile of the first stretch, from the one asked for on, in which something is to be
/// done, and above it a line with its name and that of the stretch behind it: "# numbers pictures".
/// Where nothing is to be done, gives "# shown" and the tables that the goals end with. Files that
/// are asked for alone belong to one stretch. Unless the plan only looks, the settings that its
/// steps read are written.
std::string next_makefile(Planned& planned, bool quietly);

/// Prints a plan in a format other than make.
std::string printed(Plan& plan, Format format, const JobOptions& jobs);

/// Prints the first stretch of a run in which something is to be done, and names those behind it:
/// their steps follow from the files that there will be. Throws Error(usage) for formats other than
/// why and summary.
std::string printed_whole(Planned& planned, Format format);

}  // namespace piae::plan
