#include "plan/due.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <tuple>

#include "base/numbers.hpp"
#include "base/sha256.hpp"
#include "plan/changed_description.hpp"
#include "plan/words.hpp"
#include "signal/record_files.hpp"

namespace piae::plan {

namespace {

using Values = std::map<std::string, std::string>;

const std::string a_recording = "recording ";  // role of an input, followed by its name

/// Parses lines such as: epochs = "200"
Values parse_options(std::string_view text) {
  Values values;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = line.find(" = \"");
    if (equals == std::string_view::npos || !line.ends_with('"')) continue;
    const std::size_t begin = equals + 4;
    if (begin >= line.size()) continue;
    values[std::string(line.substr(0, equals))] = line.substr(begin, line.size() - 1 - begin);
  }
  return values;
}

Values wanted_by(const Step& step) {
  Values wanted;
  if (step.settings) {
    wanted = step.settings->defaults;
    for (const auto& [option, value] : step.settings->values) wanted[option] = value;
  }
  for (const auto& [option, value] : step.options) wanted[option] = value;
  return wanted;
}

/// Returns a value as people write it: 0.005 for 0.0050000000000000001.
std::string shown(const std::string& value) {
  const auto number = number_in<double>(value);
  const std::string shortest = number ? fmt::format("{}", *number) : value;
  return shortest.size() < value.size() ? shortest : value;
}

/// Returns why a setting makes a step due. An empty text stands for a setting that is not set.
std::string changed_setting(const std::string& option, const std::string& value,
                            const std::string& was) {
  if (option == "leave-out") return "other cells are left out, because they are stale";
  if (value.empty()) return fmt::format("setting {} is not set, was {}", option, shown(was));
  if (was.empty()) return fmt::format("setting {} is {}, was not set", option, shown(value));
  return fmt::format("setting {} is {}, was {}", option, shown(value), shown(was));
}

std::string default_of(const Step& step, const std::string& option) {
  if (!step.settings) return {};
  const auto found = step.settings->defaults.find(option);
  return found == step.settings->defaults.end() ? std::string() : found->second;
}

std::string options_text(const Values& values) {
  std::string text;
  for (const auto& [option, value] : values) text += fmt::format("{} = \"{}\"\n", option, value);
  return text;
}

/// Combines the digests of files in one role into their number and one digest.
std::string digest_of_all(const std::vector<std::pair<std::string, std::string>>& files) {
  Sha256 sum;
  for (const auto& [name, digest] : files) sum.update(below_run(name) + ' ' + digest + '\n');
  return fmt::format("{}-{}", files.size(), artefact::short_digest(sum.finish_hex()));
}

std::size_t count_in(const std::string& digest) {
  return number_in<std::size_t>(digest.substr(0, digest.find('-'))).value_or(0);
}

std::string what_changed(const Input& input, const std::string& was, const std::string& is) {
  if (input.files.size() > 1 || !input.is_option) {
    if (input.role.starts_with(a_recording)) return input.role + " has changed";
    const std::size_t before = count_in(was);
    const std::size_t now = count_in(is);
    if (before != now) return fmt::format("number of {} is {}, was {}", input.role, now, before);
    return input.role + " have changed";
  }
  return file_name(input.files.front()) + " has changed";
}

/// True if a recording is gone while others that match its pattern exist. Raw recordings may be
/// deleted, but only together: a record of fewer files is another record.
bool is_gone(const std::string& role, const Step& step) {
  if (!step.description) return false;
  const std::string name = role.substr(a_recording.size());
  return std::ranges::any_of(step.description->recordings, [&](const std::string& pattern) {
    if (!signal::is_pattern(pattern) || !signal::matches(pattern, name)) return false;
    return std::ranges::any_of(step.inputs, [&](const Input& input) {
      return input.role.starts_with(a_recording) &&
             signal::matches(pattern, input.role.substr(a_recording.size()));
    });
  });
}

/// Returns the artefacts that a step reads and no step makes, such as the network for all machines.
Words artefacts_from_elsewhere(const Graph& graph, const Step& step) {
  Words files;
  for (const Input& input : step.inputs) {
    std::ranges::copy_if(input.files, std::back_inserter(files), [&](const std::string& file) {
      return file.ends_with(".h5") && !graph.maker_of(file);
    });
  }
  return files;
}

}  // namespace

bool same_value(const std::string& left, const std::string& right) {
  if (left == right) return true;
  const auto a = number_in<double>(left);
  const auto b = number_in<double>(right);
  return a && b && *a == *b;
}

const Verdict& Judge::of(StepId id) {
  if (const auto found = verdicts_.find(id); found != verdicts_.end()) return found->second;
  for (const StepId needed : graph_.needs(id)) of(needed);
  return verdicts_[id] = judge(id);
}

void Judge::read_ahead(const std::vector<StepId>& ids) {
  std::vector<bool> is_needed(graph_.steps().size());
  for (const StepId id : ids) is_needed[id] = true;
  std::vector<std::string> files;
  for (StepId id = is_needed.size(); id-- > 0;) {
    if (!is_needed[id] || verdicts_.contains(id)) continue;
    for (const StepId needed : graph_.needs(id)) is_needed[needed] = true;
    append(files, graph_.at(id).outputs);
    append(files, artefacts_from_elsewhere(graph_, graph_.at(id)));
  }
  disk_.read_ahead(files);
}

Verdict Judge::judge(StepId id) {
  const std::string missing = what_is_missing(graph_.at(id));
  if (!missing.empty()) return {State::due, missing, true};
  if (graph_.at(id).is_always_due)
    return {State::due, "it shows the present state of the run", false};
  const std::string why = what_differs(id);
  if (!why.empty()) return {State::due, why, false};
  Verdict verdict;
  for (const StepId needed : graph_.needs(id)) {
    const Verdict& before = of(needed);
    if (!waits_for(graph_.at(id), needed)) continue;
    const bool is_first = verdict.state == State::current;
    if (is_first) verdict = {State::waits, "after " + name_of(graph_.at(needed)), true};
    verdict.only_missing = verdict.only_missing && before.only_missing;
  }
  return verdict;
}

std::string Judge::what_is_missing(const Step& step) {
  std::size_t missing = 0;
  std::string first;
  for (const std::string& output : step.outputs) {
    if (disk_.find(output) != nullptr) continue;
    if (missing++ == 0) first = file_name(output);
  }
  if (missing == 0) return {};
  return missing == step.outputs.size() ? "missing" : first + " is missing";
}

std::string Judge::what_differs(StepId id) {
  const Step& step = graph_.at(id);
  return step.is_artefact ? in_artefacts(step) : in_record(step);
}

std::string Judge::in_artefacts(const Step& step) {
  for (const std::string& output : step.outputs) {
    const File& file = *disk_.find(output);
    if (!file.made) return file.problem.empty() ? file_name(output) + " is damaged" : file.problem;
    if (file.belongs_in != file_name(output)) {
      return file_name(output) + " holds what belongs in " + file.belongs_in;
    }
    for (const std::string& why : {in_options(step, *file.made), in_inputs(step, *file.made)}) {
      if (!why.empty()) return why;
    }
  }
  return {};
}

std::string Judge::in_record(const Step& step) {
  const artefact::DoneStep* const done = disk_.done(name_of(step));
  if (done == nullptr) return "the journal does not record how it was made";
  const Values was = parse_options(*done->made.options);
  const Values wanted = wanted_by(step);
  for (const auto& [option, value] : wanted) {
    const auto before = was.find(option);
    if (before == was.end()) return changed_setting(option, value, "");
    if (!same_value(before->second, value)) return changed_setting(option, value, before->second);
  }
  for (const auto& [option, value] : was) {
    if (!wanted.contains(option)) return changed_setting(option, "", value);
  }
  for (const auto& [output, digest] : done->outputs) {
    const File* const file = disk_.find(output);
    if (file == nullptr) return file_name(output) + " is missing";
    if (file->digest != digest) return file_name(output) + " differs from what the journal records";
  }
  return in_inputs(step, done->made);
}

std::string Judge::in_options(const Step& step, const artefact::Made& made) {
  std::string own;
  for (const auto& [option, value] : step.options) own += fmt::format("{}={}\n", option, value);
  const auto key = std::tuple(made.options.get(), step.settings.get(), own);
  if (const auto found = compared_.find(key); found != compared_.end()) return found->second;
  const Values was = parse_options(*made.options);
  std::string why;
  for (const auto& [option, value] : wanted_by(step)) {
    const auto before = was.find(option);
    // An option that the program did not have then had its default value.
    const std::string old = before == was.end() ? default_of(step, option) : before->second;
    if (same_value(old, value)) continue;
    why = changed_setting(option, value, old);
    break;
  }
  return compared_[key] = why;
}

std::string Judge::in_inputs(const Step& step, const artefact::Made& made) {
  std::set<std::string> roles;
  for (const Input& input : step.inputs) {
    roles.insert(input.role);
    std::string why = in_input(step, input, made);
    if (!why.empty() && input.role == "description") why = in_description(step, input, made, why);
    if (!why.empty()) return why;
  }
  for (const artefact::MadeFrom& from : made.inputs) {
    if (roles.contains(from.role)) continue;
    if (!from.role.starts_with(a_recording))
      return "it was made with --" + from.role + ", which it no longer reads";
    if (is_gone(from.role, step)) return from.role + " is gone";
  }
  return {};
}

std::string Judge::in_input(const Step& step, const Input& input, const artefact::Made& made) {
  const auto was = std::ranges::find(made.inputs, input.role, &artefact::MadeFrom::role);
  if (was == made.inputs.end()) {
    return input.may_be_unrecorded ? "" : "it was made without " + input.role;
  }
  const std::string now = digest_now(step, input);
  return now.empty() || now == was->digest ? "" : what_changed(input, was->digest, now);
}

std::string Judge::in_description(const Step& step, const Input& input, const artefact::Made& made,
                                  const std::string& otherwise) {
  const auto made_from = std::ranges::find(made.inputs, input.role, &artefact::MadeFrom::role);
  if (made_from == made.inputs.end() || !step.description) return otherwise;
  const std::string& file = input.files.front();
  const std::string was = disk_.text_of(file);
  const bool is_what_made_it =
      artefact::short_digest(Sha256().update(was).finish_hex()) == made_from->digest;
  const std::string change = is_what_made_it ? changed_key(was, step.description->text) : "";
  return change.empty() ? otherwise : file_name(file) + ": " + change;
}

bool Judge::waits_for(const Step& step, StepId needed) {
  return !is_settled(needed) && (step.is_held || !graph_.at(needed).is_held);
}

bool Judge::is_settled(StepId id) {
  const Verdict& verdict = of(id);
  return verdict.state == State::current || (graph_.at(id).is_held && verdict.only_missing);
}

std::string Judge::digest_now(const Step& step, const Input& input) {
  if (input.digest) return *input.digest;
  if (input.is_option || input.role.starts_with(a_recording)) {
    const std::string& name = input.files.front();
    const auto maker = graph_.maker_of(name);
    if (maker && waits_for(step, *maker)) return {};
    const File* const file = disk_.find(name);
    return file == nullptr ? std::string() : file->digest;
  }
  std::vector<std::pair<std::string, std::string>> all;
  for (const std::string& name : input.files) {
    const auto maker = graph_.maker_of(name);
    if (maker && waits_for(step, *maker)) return {};
    const File* const file = disk_.find(name);
    if (file != nullptr) all.emplace_back(name, file->digest);
  }
  std::ranges::sort(all);
  return digest_of_all(all);
}

artefact::DoneStep Judge::made_now(StepId id) {
  const Step& step = graph_.at(id);
  artefact::DoneStep done;
  done.made.options = std::make_shared<const std::string>(options_text(wanted_by(step)));
  for (const Input& input : step.inputs)
    done.made.inputs.push_back({input.role, digest_now(step, input)});
  std::vector<std::string> outputs = step.outputs;
  if (!step.tables_folder.empty()) {
    for (const std::string& name : disk_.files_below(step.tables_folder)) {
      if (name.ends_with(".csv")) outputs.push_back(step.tables_folder + '/' + name);
    }
  }
  for (const std::string& output : outputs) {
    const File* const file = disk_.find(output);
    if (file != nullptr) done.outputs.push_back({output, file->digest});
  }
  return done;
}

}  // namespace piae::plan
