#include "plan/cluster_jobs.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "text/file.hpp"

namespace piae::plan {

namespace {

/// The steps of one method and one seed.
struct Unit {
  std::string name;
  std::string run;
  double seconds = 0;
  double megabytes = 0;
  bool needs_gpu = false;
  std::vector<std::string> files = {};

  void take(const Cost& cost) {
    seconds += cost.seconds;
    megabytes = std::max(megabytes, cost.megabytes);
  }
};

/// A job that is being filled.
struct Load {
  double seconds = 0;
  double longest = 0;  ///< of the longest unit, s
  std::size_t steps = 0;
  std::vector<std::string> files = {};
};

constexpr std::size_t most_jobs = 500;  // below Slurm's default MaxArraySize of 1001

/// Returns twice the measured time plus five minutes, for slower processors, rounded up to five
/// minutes.
double minutes_for(double seconds) { return 5 * std::ceil((2 * seconds + 300) / 300); }

/// Returns the memory of `many` programs, plus 300 MB for make, the shells and the file buffers.
double megabytes_for(std::size_t many, double most) {
  return 100 * std::ceil((static_cast<double>(many) * most + 300) / 100);
}

bool requests_gpu(const Step& step) {
  if (!step.settings) return false;
  const auto device = step.settings->values.find("device");
  return device != step.settings->values.end() && device->second == "cuda";
}

std::string run_of(const Step& step) {
  const std::size_t run = step.folder.find('/', std::string("results/").size());
  return step.folder.substr(0, run);
}

std::size_t jobs_for(double seconds, std::size_t units, std::size_t cores, double minutes) {
  const auto wanted =
      static_cast<std::size_t>(std::ceil(seconds / (static_cast<double>(cores) * minutes * 60)));
  return std::max<std::size_t>(1, std::min({wanted, units, most_jobs}));
}

/// Distributes the units of one run, longest first: each goes to the job with the least work.
std::vector<Load> fill(const std::vector<const Unit*>& units, std::size_t cores, double minutes) {
  double seconds = 0;
  for (const Unit* unit : units) seconds += unit->seconds;
  std::vector<Load> loads(jobs_for(seconds, units.size(), cores, minutes));
  for (const Unit* unit : units) {
    Load& least = *std::ranges::min_element(loads, {}, &Load::seconds);
    least.seconds += unit->seconds;
    least.longest = std::max(least.longest, unit->seconds);
    least.steps += unit->files.size();
    least.files.insert(least.files.end(), unit->files.begin(), unit->files.end());
  }
  return loads;
}

/// Divides units among jobs of one kind, separately for each run.
JobKind kind_of(const std::string& name, std::vector<const Unit*> units, std::size_t cores,
                double minutes) {
  std::ranges::sort(units, [](const Unit* left, const Unit* right) {
    return std::tuple(-left->seconds, left->name) < std::tuple(-right->seconds, right->name);
  });
  std::map<std::string, std::vector<const Unit*>> by_run;
  double megabytes = 0;
  for (const Unit* unit : units) {
    by_run[unit->run].push_back(unit);
    megabytes = std::max(megabytes, unit->megabytes);
  }
  JobKind kind{.name = name};
  std::vector<Load> loads;
  for (const auto& [run, of_run] : by_run) {
    for (Load& load : fill(of_run, cores, minutes)) loads.push_back(std::move(load));
  }
  std::size_t most_steps = 0;
  for (const Load& load : loads) most_steps = std::max(most_steps, load.steps);
  kind.cores = std::min(most_steps, cores);
  double longest = 0;
  for (Load& load : loads) {
    longest = std::max({longest, load.seconds / static_cast<double>(kind.cores), load.longest});
    kind.steps += load.steps;
    kind.seconds += load.seconds;
    kind.files.push_back(std::move(load.files));
  }
  kind.minutes = minutes_for(longest);
  kind.megabytes = megabytes_for(kind.cores, megabytes);
  return kind;
}

/// Makes a single job for a unit, with `further_s` seconds for work that step costs do not cover.
JobKind one_job(const Unit& unit, std::size_t steps, std::size_t cores, double further_s) {
  return {.name = unit.name,
          .cores = cores,
          .minutes = minutes_for(unit.seconds + further_s),
          .megabytes = megabytes_for(cores, unit.megabytes),
          .steps = steps,
          .seconds = unit.seconds,
          .files = {unit.files}};
}

}  // namespace

std::vector<JobKind> divide(Plan& plan, const Costs& costs, std::size_t cores, double minutes) {
  Unit records{.name = "records", .run = {}};
  Unit tables{.name = "tables", .run = {}, .megabytes = 500};
  std::size_t tables_steps = 0;
  std::vector<Unit> units;
  std::map<std::string, std::size_t> index;
  for (const StepId id : plan.to_run()) {
    const Step& step = plan.graph().at(id);
    const Cost cost = costs.of(step).cost;
    if (!step.is_artefact) {
      tables.take(cost);
      ++tables_steps;
    } else if (step.place.unit.empty()) {
      records.take(cost);
      records.files.push_back(step.outputs.front());
    } else {
      const std::string name = fmt::format("{}/{}/seed{}/{}", run_of(step), step.place.dataset,
                                           *step.place.seed, step.place.unit);
      const auto [found, is_new] = index.emplace(name, units.size());
      if (is_new) units.push_back({.name = name, .run = run_of(step)});
      Unit& unit = units[found->second];
      unit.take(cost);
      unit.needs_gpu = unit.needs_gpu || requests_gpu(step);
      unit.files.push_back(step.outputs.front());
    }
  }
  std::vector<JobKind> kinds;
  if (!records.files.empty()) {
    const std::size_t steps = records.files.size();
    kinds.push_back(one_job(records, steps, std::min(steps, cores), 0));
  }
  for (const bool on_gpu : {false, true}) {
    std::vector<const Unit*> of_kind;
    for (const Unit& unit : units) {
      if (unit.needs_gpu == on_gpu) of_kind.push_back(&unit);
    }
    if (!of_kind.empty()) {
      kinds.push_back(kind_of(on_gpu ? "cells-gpu" : "cells", of_kind, cores, minutes));
    }
  }
  kinds.push_back(one_job(tables, tables_steps, 1, 300));
  return kinds;
}

std::string table_of(const std::vector<JobKind>& kinds) {
  const auto hours = [](double minutes) {
    const auto whole = static_cast<std::int64_t>(minutes);
    return fmt::format("{}:{:02} h", whole / 60, whole % 60);
  };
  std::string text = fmt::format("{:<10} {:>6} {:>6} {:>10} {:>10} {:>7} {:>11}\n", "job", "number",
                                 "cores", "time each", "memory", "steps", "core-hours");
  std::size_t jobs = 0;
  std::size_t steps = 0;
  double seconds = 0;
  double requested_hours = 0;
  for (const JobKind& kind : kinds) {
    text += fmt::format("{:<10} {:>6} {:>6} {:>10} {:>10} {:>7} {:>11.2f}\n", kind.name,
                        kind.files.size(), kind.cores, hours(kind.minutes),
                        fmt::format("{:.1f} GB", kind.megabytes / 1000), kind.steps,
                        kind.seconds / 3600);
    jobs += kind.files.size();
    steps += kind.steps;
    seconds += kind.seconds;
    requested_hours += static_cast<double>(kind.files.size() * kind.cores) * kind.minutes / 60;
  }
  text += fmt::format("{:<10} {:>6} {:>6} {:>10} {:>10} {:>7} {:>11.2f}\n", "all", jobs, "", "", "",
                      steps, seconds / 3600);
  return text + fmt::format("{} submissions, which request at most {:.1f} core-hours\n",
                            kinds.size(), requested_hours);
}

void write_jobs(const std::vector<JobKind>& kinds, const std::filesystem::path& folder) {
  std::vector<text::File> files;
  std::string lines;
  for (const JobKind& kind : kinds) {
    lines += fmt::format("{}\t{}\t{}\t{:.0f}\t{:.0f}\n", kind.name, kind.files.size(), kind.cores,
                         kind.minutes, kind.megabytes);
    if (kind.name == "tables") continue;
    for (std::size_t i = 0; i < kind.files.size(); ++i) {
      std::string list;
      for (const std::string& file : kind.files[i]) list += file + '\n';
      const std::string name =
          kind.name == "records" ? kind.name : fmt::format("{}.{}", kind.name, i);
      files.push_back({folder / name, list});
    }
  }
  files.push_back({folder / "jobs", lines});
  text::save_all(files);
}

}  // namespace piae::plan
