#include "signal/sources.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "base/error.hpp"

namespace piae::signal {

namespace {

bool is_for(const DatasetInfo& info, const Source& source, Role role) {
  if (source.condition == every_condition) return true;
  const Condition& condition = info.conditions[static_cast<std::size_t>(source.condition)];
  return may_hold(role, condition);
}

std::vector<Share> shares_of(bool healthy, const Counts& counts) {
  const std::size_t rest = counts.all - counts.test;
  if (healthy) return {{Role::test, counts.test}, {Role::healthy, rest}};
  const Share test{Role::test, counts.test};
  const Share hidden{Role::hidden, rest - counts.known};
  // If nothing is known, C gets neither a block of time nor a gap next to it.
  if (counts.known == 0) return {test, hidden};
  return {test, {Role::known, counts.known}, hidden};
}

/// Returns one source for each condition of the class. In a data set with conditions, records of
/// every condition give one source for each speed. Sorted by condition and speed.
std::vector<Source> empty_sources(const DatasetInfo& info, Label label,
                                  std::span<const RecordPlace> records) {
  std::map<std::pair<std::int32_t, double>, Source> sources;
  std::size_t of_every = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].label != label) continue;
    const bool by_speed = records[i].condition == every_condition && !info.conditions.empty();
    const double speed_rpm = by_speed ? records[i].shaft_speed_rpm : 0;
    const auto [place, is_new] = sources.try_emplace({records[i].condition, speed_rpm});
    if (is_new && by_speed) ++of_every;
    place->second.records.push_back(i);
  }
  std::vector<Source> list;
  for (auto& [place, source] : sources) {
    source.condition = place.first;
    if (place.first == every_condition && of_every > 1) source.shaft_speed_rpm = place.second;
    list.push_back(std::move(source));
  }
  return list;
}

/// Distributes a role's windows over its sources.
void share_out(const Share& share, const std::vector<Source*>& sources, const Stream& stream) {
  std::vector<std::size_t> counts(sources.size(), share.count / sources.size());
  const std::size_t rest = share.count % sources.size();
  if (rest > 0) {
    Stream who_gives_more = stream.child("role " + to_string(share.role));
    const auto order = who_gives_more.permutation(sources.size());
    for (std::size_t i = 0; i < rest; ++i) ++counts[order[i]];
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (counts[i] > 0) sources[i]->shares.push_back({share.role, counts[i]});
  }
}

}  // namespace

std::size_t Source::windows() const {
  return std::accumulate(shares.begin(), shares.end(), std::size_t{0},
                         [](std::size_t sum, const Share& share) { return sum + share.count; });
}

std::size_t Source::count_of(Role role) const {
  const auto found = std::ranges::find(shares, role, &Share::role);
  return found == shares.end() ? 0 : found->count;
}

std::string speed_label(double speed_rpm) { return fmt::format("{:g} rpm", speed_rpm); }

std::string name_of(const DatasetInfo& info, Label label, const Source& source) {
  std::string name = "data set " + info.name + ", class " + info.class_of(label).name;
  if (source.condition != every_condition) {
    name += ", condition " + info.conditions[static_cast<std::size_t>(source.condition)].name;
  }
  return source.shaft_speed_rpm ? name + ", " + speed_label(*source.shaft_speed_rpm) : name;
}

std::vector<Source> sources_of(const DatasetInfo& info, Label label,
                               std::span<const RecordPlace> records, const Counts& counts,
                               const Stream& stream) {
  std::vector<Source> sources = empty_sources(info, label, records);
  for (const Share& share : shares_of(label == info.healthy_label(), counts)) {
    std::vector<Source*> givers;
    for (Source& source : sources) {
      if (is_for(info, source, share.role)) givers.push_back(&source);
    }
    if (givers.empty()) {
      throw Error(Exit::bad_input, "data set " + info.name + ", class " +
                                       info.class_of(label).name + ": has no record for role " +
                                       to_string(share.role));
    }
    share_out(share, givers, stream);
  }
  std::erase_if(sources, [](const Source& source) { return source.shares.empty(); });
  return sources;
}

}  // namespace piae::signal
