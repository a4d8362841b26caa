#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "plan/disk.hpp"
#include "plan/plan.hpp"

namespace piae::plan {

/// Options of a plan.
struct PlanOptions {
  std::filesystem::path pipeline = "pipeline";  ///< folder with protocol.toml and datasets/
  Stretch stretch = Stretch::grid;
  bool with_missing = false;  ///< tables from the existing cells, see plan_with_missing()
  bool looks = false;         ///< nothing is written, not even the journal
  std::string only =
      {};  ///< a file with the names of the requested files, one a line; may be empty
};

/// The plan of a run on the disk.
class Planned {
 public:
  /// Throws as Plan does, and Error(bad_input) for a run in the layout from before 0.1.0.
  Planned(const Request& request, const PlanOptions& options);

  [[nodiscard]] Plan& plan() { return *plan_; }
  [[nodiscard]] const PlanOptions& options() const { return options_; }
  /// Plans another stretch of the same request. Files already read are not read again.
  void go_to(Stretch stretch);
  /// Writes what was learned about the files into the journal of the run.
  void save() { disk_->save(); }
  [[nodiscard]] bool has(const std::string& step) const;
  /// True if the step with this name is to be run.
  bool is_due(const std::string& step);
  /// Records in the journal how a step made its files. Records nothing if an input has changed
  /// since the step started.
  void note(const std::string& step);

 private:
  StepId step_named(const std::string& name);
  void make_plan(Choice choice);

  Experiment experiment_;
  PlanOptions options_;
  std::unique_ptr<RealDisk> disk_;
  std::unique_ptr<Plan> plan_;
};

/// Start of a step and the present time, seconds since 1970.
struct Times {
  double started_s = 0;
  double now_s = 0;
};

/// True if a file that changed at `changed_s` may have been read before that change. A time in the
/// future comes from a clock that was set back.
bool lies_in(const Times& times, double changed_s);

/// Returns the request for the single step with this log name: its data set and seed only.
Request narrowed(Request request, const std::string& step);

/// Returns a plan that contains this step. The plan covers only its data set and seed if possible,
/// which is fast; else the whole request. Throws as Planned does.
std::unique_ptr<Planned> planned_for(const Request& request, const PlanOptions& options,
                                     const std::string& step);

}  // namespace piae::plan
