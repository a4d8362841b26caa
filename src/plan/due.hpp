#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "plan/disk.hpp"
#include "plan/step.hpp"

namespace piae::plan {

/// Says if a step is to be run.
enum class State {
  current,  ///< what it makes is there, made as it would be made now
  due,      ///< it is to be run
  waits,  ///< a step that it waits for is to be run; if that gives the same again, this one is not
};

struct Verdict {
  State state = State::current;
  std::string why = {};  ///< empty where it is current: "setting epochs is 100, was 200", "missing"
  /// True if nothing is wrong except that files were removed: results made from them stay
  /// true.
  bool only_missing = false;
};

/// Decides which steps are to be run, and why. A step is due when
///   - a file that it makes is missing, cannot be read, or was changed by somebody else,
///   - the options that made it differ from those that it would be made with now,
///   - an input has other contents than those that it was made from.
/// Times of files decide nothing.
class Judge {
 public:
  Judge(const Graph& graph, Disk& disk) : graph_(graph), disk_(disk) {}

  const Verdict& of(StepId id);

  /// Says for which steps of() will be asked, so that their files are read together.
  void read_ahead(const std::vector<StepId>& ids);

  /// How a step whose outputs do not say so is made now: for the journal.
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
  /// Names the key of a description that has changed, where its former text is still there.
  std::string in_description(const Step& step, const Input& input, const artefact::Made& made,
                             const std::string& otherwise);
  /// The digest of an input as it lies there now; empty where that cannot be known yet.
  std::string digest_now(const Step& step, const Input& input);
  /// True if a step that `step` needs may still change its outputs. One that the run only holds is
  /// not made, so what is asked for takes it as it is.
  bool waits_for(const Step& step, StepId needed);
  bool is_settled(StepId id);

  const Graph& graph_;
  Disk& disk_;
  std::map<StepId, Verdict> verdicts_;
  std::map<std::tuple<const std::string*, const Settings*, std::string>, std::string> compared_;
};

/// The name of a step in the journal.
std::string name_of(const Step& step);

/// Compares two values of an option, as numbers where they are numbers.
bool same_value(const std::string& left, const std::string& right);

}  // namespace piae::plan
