#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "plan/disk.hpp"
#include "plan/plan.hpp"

namespace piae::plan {

/// How a plan is to be made.
struct PlanOptions {
  std::filesystem::path pipeline = "pipeline";  ///< folder with protocol.toml and datasets/
  Stretch stretch = Stretch::grid;
  bool with_holes = false;  ///< tables of what there is, see plan_with_holes()
  bool looks = false;       ///< nothing is written, not even the journal
  std::string only =
      {};  ///< a file that names the files which are asked for, a line each; may be empty
};

/// A plan of a run on the disk.
class Planned {
 public:
  /// Throws as Plan does, and Error(bad_input) for a run whose cells lie as before 0.1.0.
  Planned(const Request& request, const PlanOptions& options);

  [[nodiscard]] Plan& plan() { return *plan_; }
  [[nodiscard]] const PlanOptions& options() const { return options_; }
  /// Plans another stretch of the same request, with what is known of the files already.
  void go_to(Stretch stretch);
  /// Writes what was learned of the files into the run's journal.
  void save() { disk_->save(); }
  [[nodiscard]] bool has(const std::string& step) const;
  /// True if the step of this name is to be run.
  bool is_due(const std::string& step);
  /// Notes in the journal how a step has made its files. It is not noted where what it read has
  /// changed since it began.
  void note(const std::string& step);

 private:
  StepId step_named(const std::string& name);
  void make_plan(Choice choice);

  Experiment experiment_;
  PlanOptions options_;
  std::unique_ptr<RealDisk> disk_;
  std::unique_ptr<Plan> plan_;
};

/// When a step started, and the time now, in seconds since 1970.
struct Times {
  double started_s = 0;
  double now_s = 0;
};

/// True if a file that changed at that time may have been read before it did. A time to come is of
/// a clock that has been set back since.
bool lies_in(const Times& times, double changed_s);

/// The request for one step alone, whose log has this name: of its data set and seed.
Request narrowed(Request request, const std::string& step);

/// A plan in which this step stands: of its data set and seed alone where that can be planned,
/// which is fast; else of all that is asked for. Throws as Planned does.
std::unique_ptr<Planned> planned_for(const Request& request, const PlanOptions& options,
                                     const std::string& step);

}  // namespace piae::plan
