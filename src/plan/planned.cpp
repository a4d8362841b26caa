#include "plan/planned.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "plan/words.hpp"
#include "run/layout.hpp"
#include "run/step_log.hpp"
#include "text/lines.hpp"

namespace piae::plan {

bool lies_in(const Times& times, double changed_s) {
  return changed_s > times.started_s && changed_s <= times.now_s;
}

namespace {

/// Returns the present time. A log just written shows the file system's clock, which may be ahead
/// of ours.
double now_s(const std::string& log) {
  const auto written = artefact::stat_of(log);
  const std::chrono::duration<double> ours = std::chrono::system_clock::now().time_since_epoch();
  return written ? std::max(ours.count(), static_cast<double>(written->changed) * 1e-9)
                 : ours.count();
}

/// True if a file was written after a step started.
bool is_newer(const std::string& file, const Times& times) {
  const auto stat = artefact::stat_of(file);
  return stat && lies_in(times, static_cast<double>(stat->changed) * 1e-9);
}

/// True if the step cannot have read these settings: their file differs, or was written later.
bool has_read_others(const Settings* settings, const Times& times) {
  if (settings == nullptr) return false;
  if (!artefact::stat_of(settings->file) || is_newer(settings->file, times)) return true;
  return sha256_of_file(settings->file) != Sha256().update(settings->text).finish_hex();
}

/// True if an input or a setting of the step has changed since the step started.
bool changed_since(const Step& step, double started_s) {
  const Times times{.started_s = started_s, .now_s = now_s(log_of(step))};
  if (has_read_others(step.settings.get(), times)) return true;
  for (const Input& input : step.inputs) {
    for (const std::string& file : input.files) {
      if (is_newer(file, times)) return true;
    }
  }
  return false;
}

/// Refuses cells in the folder layout from before 0.1.0. A run with a journal is newer, so its
/// files are not checked.
void refuse_old_layout(const Choice& choice) {
  if (artefact::stat_of(choice.folder() + "/.journal")) return;
  for (const Part& part : choice.parts) run::Layout(choice.folder(), part.dataset.name);
}

}  // namespace

Planned::Planned(const Request& request, const PlanOptions& options)
    : experiment_(read_experiment(options.pipeline)), options_(options) {
  Choice choice = choose(experiment_, request);
  if (options.stretch == Stretch::grid) refuse_old_layout(choice);
  disk_ = std::make_unique<RealDisk>(std::vector{choice.folder_of(signal::Protocol::random),
                                                 choice.folder_of(signal::Protocol::blocked)},
                                     !options.looks);
  make_plan(std::move(choice));
}

void Planned::make_plan(Choice choice) {
  const bool with_missing = options_.with_missing && options_.stretch == Stretch::grid;
  plan_ = with_missing
              ? plan_with_missing(experiment_, std::move(choice), *disk_)
              : std::make_unique<Plan>(experiment_, std::move(choice), options_.stretch, *disk_);
  if (!options_.only.empty()) plan_->keep_only(text::read_lines(options_.only));
  if (options_.looks) plan_->keep_pages();
}

void Planned::go_to(Stretch stretch) {
  if (stretch == options_.stretch) return;
  options_.stretch = stretch;
  make_plan(plan_->choice());
}

bool Planned::has(const std::string& step) const {
  return plan_->graph().step_named(step).has_value();
}

StepId Planned::step_named(const std::string& name) {
  const auto found = plan_->graph().step_named(name);
  if (!found) throw Error(Exit::usage, "there is no step " + name + "; `plan` lists the steps");
  return *found;
}

bool Planned::is_due(const std::string& step) {
  const StepId id = step_named(step);
  plan_->judge().read_ahead({id});
  return plan_->judge().of(id).state != State::current;
}

void Planned::note(const std::string& name) {
  const StepId id = step_named(name);
  const Step& step = plan_->graph().at(id);
  std::error_code none;
  if (std::filesystem::is_regular_file(log_of(step), none)) {
    const run::StepLog log = run::read_step_log(log_of(step));
    if (log.started_s && changed_since(step, *log.started_s)) return;
  }
  disk_->note(name, plan_->judge().made_now(id));
}

Request narrowed(Request request, const std::string& step) {
  // results/RUN/DATASET/seedK/...
  const Words parts = fields_of(step, '/');
  if (parts.size() < 4) return request;
  if (parts[3] == "contrast@rates") return request;  // compares two data sets
  request.datasets = parts[2];
  const std::string& seed = parts[3];
  if (seed.starts_with("seed")) request.seeds = seed.substr(4);
  return request;
}

std::unique_ptr<Planned> planned_for(const Request& request, const PlanOptions& options,
                                     const std::string& step) {
  try {
    auto planned = std::make_unique<Planned>(narrowed(request, step), options);
    if (planned->has(step)) return planned;
  } catch (const Error& error) {
    if (error.exit() != Exit::usage) throw;  // another goal needs several data sets
  }
  return std::make_unique<Planned>(request, options);
}

}  // namespace piae::plan
