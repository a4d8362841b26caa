#include "monitor/judge.hpp"

#include <algorithm>
#include <cmath>

namespace piae::monitor {

namespace {

template <class T>
std::size_t place_of_most(const std::vector<T>& values) {
  return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
}

}  // namespace

Judge::Judge(const signal::DatasetInfo& info, Alarm alarm, double every_s)
    : info_(info),
      healthy_(info.healthy_label()),
      alarm_(alarm),
      every_s_(every_s),
      next_s_(every_s),
      since_probabilities_(info.classes.size(), 0),
      causes_(info.classes.size() + 1, 0) {}

std::optional<Decision> Judge::add(const Finding& finding) {
  const bool silent = finding.classes.empty();
  ++windows_;
  ++since_;
  end_s_ = finding.end_s;
  silent_windows_ += silent ? 1 : 0;
  unknown_windows_ += finding.unknown ? 1 : 0;
  since_unknown_ += finding.unknown || silent ? 1 : 0;
  for (std::size_t c = 0; c < finding.classes.size(); ++c) {
    since_probabilities_[c] += finding.classes[c];
  }
  remember_cause(finding);
  const double looks_faulty =
      silent || finding.unknown ? 1 : 1 - static_cast<double>(finding.classes[index_of(healthy_)]);
  const AlarmState alarm = alarm_.add(std::clamp(looks_faulty, 0.0, 1.0));
  alarms_ += alarm == AlarmState::raised ? 1 : 0;

  const bool changed = alarm == AlarmState::raised || alarm == AlarmState::cleared;
  if (!changed && end_s_ < next_s_) return std::nullopt;
  return decide();
}

void Judge::remember_cause(const Finding& finding) {
  const double memory = 1 - 1 / std::max(1.0, alarm_.windows_to_alarm(1));
  for (double& cause : causes_) cause *= memory;
  if (finding.unknown || finding.classes.empty()) {
    causes_.back() += 1;
    return;
  }
  for (const Label label : info_.fault_labels()) {
    causes_[index_of(label)] += finding.classes[index_of(label)];
  }
}

std::string Judge::cause() const {
  const AlarmState alarm = alarm_.state();
  if (alarm != AlarmState::raised && alarm != AlarmState::on) return {};
  const std::size_t most = place_of_most(causes_);
  return most < info_.classes.size() ? info_.classes[most].name : "unknown";
}

Decision Judge::decide() {
  Decision decision;
  decision.time_s = end_s_;
  decision.windows = since_;
  decision.unknown = 2 * since_unknown_ > since_;
  decision.evidence = alarm_.evidence();
  decision.alarm = alarm_.state();
  decision.cause = cause();
  const std::size_t most = place_of_most(since_probabilities_);
  if (since_probabilities_[most] > 0) {
    decision.label = static_cast<Label>(most);
    decision.probability = since_probabilities_[most] / static_cast<double>(since_);
  }
  since_ = 0;
  since_unknown_ = 0;
  std::ranges::fill(since_probabilities_, 0.0);
  if (every_s_ > 0) next_s_ = every_s_ * (std::floor(end_s_ / every_s_) + 1);
  return decision;
}

std::optional<Decision> Judge::finish() {
  if (since_ == 0) return std::nullopt;
  return decide();
}

}  // namespace piae::monitor
