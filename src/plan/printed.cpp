#include "plan/printed.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.hpp"
#include "plan/cluster_jobs.hpp"
#include "plan/settings_files.hpp"
#include "plan/words.hpp"
#include "readings/ranking.hpp"
#include "text/lines.hpp"

namespace piae::plan {

namespace {

/// Returns the name of a step for make: its first file, or its log.
std::string target_of(const Step& step) {
  return step.outputs.empty() ? name_of(step) : step.outputs.front();
}

bool is_plain(const std::string& word) {
  return !word.empty() && word.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                              "0123456789_-+=./,:@%^") == std::string::npos;
}

/// Quotes a word for the shell. Names with a quote or a dollar sign are refused earlier.
std::string quoted(const std::string& word) { return is_plain(word) ? word : '\'' + word + '\''; }

std::string shell_line(const Words& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

/// Returns the command that draws a table, or several tables joined (TableSteps::add_picture()).
std::string drawing(const Step& step) {
  const Words& tables = step.inputs.front().files;
  const std::string csv = std::filesystem::path(step.outputs.front()).replace_extension(".csv");
  Words words{"pipeline/figures/draw.sh", csv};
  if (tables != Words{csv}) append(words, tables);
  return shell_line(words);
}

/// Returns the lines of a rule's recipe, without the leading tab.
Words recipe_of(const Step& step, State state) {
  const std::string note = "$(BIN)/plan --note " + name_of(step);
  Words words = command_of(step);
  if (step.stage == "draw") return {drawing(step), note};
  if (step.stage == "report") {
    words.erase(std::ranges::find(words, "--"), words.end());
    return {"$(BIN)/" + shell_line(words)};
  }
  std::string line;
  if (step.log != step.stage) line += "STEP_LOG=" + step.log + ' ';
  if (state == State::waits) line += "ONLY_IF_DUE=yes ";
  line += "pipeline/step.sh " + step.folder + ' ' + shell_line(words);
  return step.is_artefact ? Words{line} : Words{line, note};
}

std::string counted(const std::map<std::string, std::size_t>& counts) {
  Words words;
  for (const auto& [name, count] : counts) words.push_back(fmt::format("{} {}", count, name));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Ranks the interpretations of all comparable data sets, if that is the goal; else returns an
/// empty text.
std::string ranked_readings(const Plan& plan) {
  std::vector<std::filesystem::path> tables;
  if (!plan.choice().has_goal("readings")) return {};
  for (const Part& part : plan.choice().parts) {
    const auto table =
        std::filesystem::path(plan.choice().folder()) / part.dataset.name / "readings.csv";
    if (std::filesystem::exists(table)) tables.push_back(table);
  }
  return readings::ranking(tables);
}

/// Returns the text of the tables that the goals end with, if they exist.
std::string shown_of(const Plan& plan) {
  std::string all;
  for (const std::string& table : plan.shown()) {
    if (!std::filesystem::exists(table)) continue;
    for (const std::string& line : text::read_lines(table)) all += line + '\n';
  }
  const auto add_folders = [&](const char* what, const char* below) {
    all += what;
    for (const Part& part : plan.choice().parts) {
      all += fmt::format(" {}/{}/{}", plan.choice().folder(), part.dataset.name, below);
    }
    all += '\n';
  };
  if (plan.choice().has_goal("all")) add_folders("tables and artefacts:", "");
  if (plan.choice().has_goal("figures")) add_folders("figures:", "figures/");
  return all;
}

}  // namespace

std::string makefile_of(Plan& plan, bool quietly) {
  const std::vector<StepId> ids = plan.to_run();
  if (ids.empty()) return {};
  const std::set<StepId> runs(ids.begin(), ids.end());
  std::string names;
  std::string rules;
  for (const StepId id : ids) {
    const Step& step = plan.graph().at(id);
    const std::string target = target_of(step);
    names += ' ' + target;
    rules += target + ':';
    for (const StepId needed : plan.graph().needs(id)) {
      if (runs.contains(needed)) rules += ' ' + target_of(plan.graph().at(needed));
    }
    rules += '\n';
    for (const std::string& line : recipe_of(step, plan.judge().of(id).state)) {
      rules += (quietly ? "\t@" : "\t") + line + '\n';
    }
  }
  return "# Steps of a run that are due. Written by build/bin/plan for one call of make.\n"
         ".PHONY: steps" +
         names + "\nsteps:" + names + '\n' + rules;
}

std::string why_of(Plan& plan) {
  struct Reason {
    Words steps;
    std::string why;
  };
  std::vector<Reason> reasons;
  std::map<std::string, std::size_t> index;
  std::map<std::string, std::size_t> waiting;
  for (const StepId id : plan.to_run()) {
    const Step& step = plan.graph().at(id);
    const Verdict& verdict = plan.judge().of(id);
    if (verdict.state == State::waits) {
      ++waiting[step.log];
      continue;
    }
    const std::string key = step.place.dataset + '\t' + step.log + '\t' + verdict.why;
    const auto [found, is_new] = index.emplace(key, reasons.size());
    if (is_new) reasons.push_back({.steps = {}, .why = verdict.why});
    reasons[found->second].steps.push_back(below_run(step.folder) + ' ' + step.log);
  }
  constexpr std::size_t few = 3;
  std::string text;
  for (const auto& [steps, why] : reasons) {
    if (steps.size() > few) {
      text += fmt::format("{} and {} more: {}\n", steps.front(), steps.size() - 1, why);
      continue;
    }
    for (const std::string& step : steps) text += fmt::format("{}: {}\n", step, why);
  }
  if (!waiting.empty()) {
    text += fmt::format("then, if the steps above change their inputs: {}\n", counted(waiting));
  }
  return text;
}

std::string guessed_costs_of(Plan& plan, const Costs& costs) {
  std::set<std::string> guessed;
  for (const StepId id : plan.to_run()) {
    const Step& step = plan.graph().at(id);
    if (!costs.of(step).is_guess) continue;
    guessed.insert(step.stage + (step.place.method.empty() ? "" : " ") + step.place.method);
  }
  if (guessed.empty()) return {};
  return fmt::format("no cost is known for: {}; the largest known one is used\n",
                     fmt::join(guessed, ", "));
}

std::string summary_of(Plan& plan, const Costs& costs) {
  std::map<std::string, std::size_t> counts;
  double seconds = 0;
  double megabytes = 0;
  const std::vector<StepId> ids = plan.to_run();
  for (const StepId id : ids) {
    const Step& step = plan.graph().at(id);
    ++counts[step.stage];
    const Costs::Estimate estimate = costs.of(step);
    seconds += estimate.cost.seconds;
    megabytes = std::max(megabytes, estimate.cost.megabytes);
  }
  if (ids.empty()) return {};
  std::string text = fmt::format(
      "{} steps: {}\n{} of processor time and at most {:.0f} MB of memory a step, estimated from "
      "earlier runs (jobs/costs.csv)\n",
      ids.size(), counted(counts), duration(seconds), megabytes);
  return text + guessed_costs_of(plan, costs);
}

std::string missing_of(Plan& plan) {
  constexpr std::size_t most = 100;
  Words files;
  for (const StepId id : plan.missing()) {
    const Step& step = plan.graph().at(id);
    if (step.stage != "split" && step.stage != "generate") files.push_back(step.outputs.front());
  }
  if (files.empty()) return {};
  std::string text = fmt::format("missing: {} files that the tables need\n", files.size());
  for (std::size_t i = 0; i < std::min(files.size(), most); ++i) text += "  " + files[i] + '\n';
  if (files.size() > most) text += "  ... (the first 100)\n";
  return text;
}

std::string next_makefile(Planned& planned, bool quietly) {
  const PlanOptions options = planned.options();
  for (const auto* stretch = std::ranges::find(stretches, options.stretch);
       *stretch != Stretch::shown; ++stretch) {
    if (!has_steps_in(*stretch, planned.plan().choice())) continue;
    planned.go_to(*stretch);
    if (!options.looks) write_settings(planned.plan());
    const std::string steps = makefile_of(planned.plan(), quietly);
    if (steps.empty() && !options.only.empty()) return {};
    if (steps.empty()) continue;
    return fmt::format("# {} {}\n{}", to_string(*stretch), to_string(stretch[1]), steps);
  }
  planned.go_to(Stretch::grid);
  return "# shown\n" + shown_of(planned.plan()) + ranked_readings(planned.plan());
}

std::string printed(Plan& plan, Format format, const JobOptions& jobs) {
  const auto costs = [] { return Costs::read("jobs/costs.csv"); };
  switch (format) {
    case Format::summary:
      return summary_of(plan, costs());
    case Format::missing:
      return missing_of(plan);
    case Format::costs: {
      RealLogs logs;
      return measured_costs(plan, logs);
    }
    case Format::jobs: {
      const auto kinds = divide(plan, costs(), jobs.cores, jobs.minutes);
      write_jobs(kinds, jobs.folder);
      return table_of(kinds) + guessed_costs_of(plan, costs());
    }
    default:
      return why_of(plan);
  }
}

std::string printed_whole(Planned& planned, Format format) {
  if (format != Format::why && format != Format::summary) {
    throw Error(Exit::usage, "--whole works only with --format why or summary (see plan --help)");
  }
  std::string text;
  std::string later;
  for (const Stretch stretch : stretches) {
    if (!has_steps_in(stretch, planned.plan().choice())) continue;
    if (!text.empty()) {
      later += (later.empty() ? "" : ", ") + std::string(to_string(stretch));
      continue;
    }
    planned.go_to(stretch);
    text = printed(planned.plan(), format, {});
  }
  if (text.empty()) return "nothing to do\n";
  return later.empty() ? text : text + "then, from these results: " + later + '\n';
}

}  // namespace piae::plan
