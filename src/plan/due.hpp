#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "plan/disk.hpp"
#include "plan/step.hpp"

namespace piae::plan {

/// State of a step.
enum class State {
  current,  ///< its files exist and are as they would be made now
  due,      ///< to be run
  waits,    ///< needs a step that is to be run; stays current if that step's output does not change
};

struct Verdict {
  State state = State::current;
  std::string why = {};  ///< "setting epochs is 100, was 200", "missing"; empty for a current step
  /// True if the only problem is that files were removed: results made from them stay valid.
  bool only_missing = false;
};

/// Decides which steps are to be run, and why. A step is due if
///   - one of its files is missing, cannot be read, or was changed by another program,
///   - its options differ from those that made the files,
///   - the contents of an input differ from those that it was made from.
/// File times do not count.
class Judge {
 public:
  Judge(const Graph& graph, Disk& disk) : graph_(graph), disk_(disk) {}

  const Verdict& of(StepId id);

  /// Announces the steps that of() will be called for, so that their files are read together.
  void read_ahead(const std::vector<StepId>& ids);

  /// Returns how a step is made now, for the journal, if its outputs do not record it.
  artefact::DoneStep made_now(StepId id);

 private:
  Verdict judge(StepId id);
  std::string what_is_missing(const Step& step);
  std::string what_differs(StepId id);
  std::string in_artefacts(const Step& step);
  std::string in_record(const Step& step);
  std::string in_options(const Step& step, const artefact::Made& made);
  std::string in_inputs(const Step& step, const artefact::Made& made);
  std::string in_input(const Step& step, const Input& input, const artefact::Made& made);
  /// Names the changed key of a description, if the former text still exists; else `otherwise`.
  std::string in_description(const Step& step, const Input& input, const artefact::Made& made,
                             const std::string& otherwise);
  /// Returns the present digest of an input; an empty text if it cannot be known yet.
  std::string digest_now(const Step& step, const Input& input);
  /// True if the step `needed`, on which `step` depends, may still change its outputs. A step that
  /// the run only holds is not remade, so a requested step takes its outputs as they are.
  bool waits_for(const Step& step, StepId needed);
  bool is_settled(StepId id);

  const Graph& graph_;
  Disk& disk_;
  std::map<StepId, Verdict> verdicts_;
  std::map<std::tuple<const std::string*, const Settings*, std::string>, std::string> compared_;
};

/// Compares two values of an option, as numbers if both are numbers.
bool same_value(const std::string& left, const std::string& right);

}  // namespace piae::plan
