#include "signal/roles.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/error.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

constexpr std::array<const char*, 5> role_letters{"A", "B", "C", "D", "E"};

/// One window on the time axis of its record.
struct Piece {
  std::int64_t first_sample;
  const RoleSet* set;
};
using Pieces = std::map<std::string, std::vector<Piece>>;  // by the record's name

/// Places where two roles are too close to each other in one record.
struct Conflict {
  std::size_t places = 0;
  std::int64_t first_sample = 0;  ///< of the later window at the first place
  std::int64_t distance = 0;      ///< samples between both windows there; negative if they overlap
};
/// Conflicts by record name and the two roles.
using Conflicts = std::map<std::tuple<std::string, Role, Role>, Conflict>;

void note_differences(const RoleSet& one, const RoleSet& other,
                      std::vector<std::string>& findings) {
  const auto differ = [&](const std::string& what, const std::string& a, const std::string& b) {
    if (a == b) return;
    findings.push_back(other.file + ": has " + what + " " + b + ", but " + one.file + " has " + a +
                       "; they do not belong to one split");
  };
  differ("protocol", to_string(one.protocol), to_string(other.protocol));
  differ("seed", std::to_string(one.seed), std::to_string(other.seed));
  differ("records_digest", one.records_digest, other.records_digest);
  differ("window length", std::to_string(one.windows.length), std::to_string(other.windows.length));
  if (one.windows.info.conditions != other.windows.info.conditions) {
    findings.push_back(other.file + ": has other conditions than " + one.file +
                       "; they do not belong to one split");
  }
}

/// Returns what is wrong with the conditions of a role's windows; empty if nothing is.
std::string condition_objection(Role role, const WindowSet& windows) {
  for (const std::int32_t index : windows.condition) {
    if (index == every_condition) continue;
    const Condition& condition = windows.info.conditions[static_cast<std::size_t>(index)];
    if (may_hold(role, condition)) continue;
    return "has windows of condition '" + condition.name + "', which role " + to_string(role) +
           " must not have";
  }
  return {};
}

Pieces pieces_in_time_order(const std::vector<RoleSet>& sets) {
  Pieces pieces;
  for (const RoleSet& set : sets) {
    for (std::size_t i = 0; i < set.windows.size(); ++i) {
      const auto record = static_cast<std::size_t>(set.windows.record[i]);
      pieces[set.windows.record_names[record]].push_back({set.windows.first_sample[i], &set});
    }
  }
  for (auto& [record, of_record] : pieces) {
    std::ranges::stable_sort(of_record, {}, &Piece::first_sample);
  }
  return pieces;
}

/// Compares only neighbours in time order: all windows have the same length, so no other pair is
/// closer.
Conflicts conflicts_in(const Pieces& pieces, std::int64_t length, Protocol protocol) {
  Conflicts conflicts;
  for (const auto& [record, of_record] : pieces) {
    for (std::size_t i = 1; i < of_record.size(); ++i) {
      const Piece& before = of_record[i - 1];
      const Piece& after = of_record[i];
      const std::int64_t distance = after.first_sample - before.first_sample - length;
      const bool too_close =
          protocol == Protocol::blocked ? distance < length : distance == -length;
      if (before.set->role == after.set->role || !too_close) continue;
      Conflict& conflict = conflicts[{record, std::min(before.set->role, after.set->role),
                                      std::max(before.set->role, after.set->role)}];
      if (conflict.places++ == 0) {
        conflict.first_sample = after.first_sample;
        conflict.distance = distance;
      }
    }
  }
  return conflicts;
}

std::string line_of(const Conflicts::value_type& entry, std::int64_t length) {
  const auto& [key, conflict] = entry;
  const auto& [record, one, other] = key;
  const std::string who =
      "record " + record + ": roles " + to_string(one) + " and " + to_string(other);
  const std::string where = " at sample " + std::to_string(conflict.first_sample) + " (" +
                            std::to_string(conflict.places) + " places)";
  if (conflict.distance == -length) return who + " share a window" + where;
  return who + " lie " + std::to_string(conflict.distance) + " samples apart" + where +
         "; a blocked split keeps " + std::to_string(length);
}

}  // namespace

std::string to_string(Role role) { return role_letters[static_cast<std::size_t>(role)]; }

bool may_hold(Role role, const Condition& condition) {
  if (role == Role::known) return condition.known;
  return role == Role::healthy ? condition.healthy : condition.test;
}

Role read_role(const artefact::Reader& reader) {
  const std::string text = reader.text("/", "role");
  for (std::size_t i = 0; i < role_letters.size(); ++i) {
    if (text == role_letters[i]) return static_cast<Role>(i);
  }
  reader.refuse("/", "has role " + text + "; it must be A, B, C, D or E");
}

std::string read_method(const artefact::Reader& reader) {
  std::string name = reader.text("/", "method");
  if (!ranges::is_plain_name(name)) {
    reader.refuse("/, attribute method", ranges::plain_name_rule);
  }
  return name;
}

void require_role(const artefact::Reader& reader, Role role) {
  const Role holds = read_role(reader);
  if (holds == role) return;
  reader.refuse("/", "has role " + to_string(holds) + ", but must have role " + to_string(role));
}

void write(artefact::Writer& writer, const Origin& origin) {
  writer.attribute("/", "split_seed", origin.split_seed);
  writer.attribute("/", "protocol", to_string(origin.protocol));
  writer.attribute("/", "records_digest", origin.records_digest);
  writer.attribute("/", "known_digest", origin.known_digest);
}

Origin read_origin(const artefact::Reader& reader) {
  return {.split_seed = reader.integer("/", "split_seed", ranges::seed),
          .protocol = read_protocol(reader),
          .records_digest = reader.text("/", "records_digest"),
          .known_digest = reader.text("/", "known_digest")};
}

Origin origin_of_known(const artefact::Reader& known) {
  return {.split_seed = known.integer("/", "seed", ranges::seed),
          .protocol = read_protocol(known),
          .records_digest = known.text("/", "records_digest"),
          .known_digest = known.digest()};
}

void require_same_split(const artefact::Reader& generated, const artefact::Reader& hidden) {
  const Origin origin = read_origin(generated);
  if (origin.split_seed == hidden.integer("/", "seed") &&
      origin.protocol == read_protocol(hidden) &&
      origin.records_digest == hidden.text("/", "records_digest")) {
    return;
  }
  generated.refuse("/", "was learned from C of another split (seed " +
                            std::to_string(origin.split_seed) + ", " + to_string(origin.protocol) +
                            ") than " + hidden.path().string() +
                            "; train and generate with this split's C");
}

void require_learned_from(const artefact::Reader& generated, const artefact::Reader& known) {
  if (read_origin(generated).known_digest == known.digest()) return;
  generated.refuse("/", "was learned from other known windows than " + known.path().string() +
                            ", which may be test windows here; train and generate with this C");
}

void require_belonging(const artefact::Reader& reader, Role role, const WindowSet& windows) {
  if (role == Role::known && windows.size() == 0) return;
  for (const Label label : windows.info.labels()) {
    const ClassInfo& c = windows.info.class_of(label);
    const bool healthy = c.defect == Defect::none;
    const bool wanted = role == Role::test || healthy == (role == Role::healthy);
    const bool present = windows.count_of(label) > 0;
    if (wanted && !present) reader.refuse("/labels", "has no window of class " + c.name);
    if (!wanted && present) {
      reader.refuse("/labels", "has windows of class " + c.name + ", which role " +
                                   to_string(role) + " must not have");
    }
  }
  const std::string objection = condition_objection(role, windows);
  if (!objection.empty()) reader.refuse("/condition", objection);
}

RoleSet read_role_set(const artefact::Reader& reader) {
  RoleSet set;
  set.file = reader.path().string();
  set.role = read_role(reader);
  set.protocol = read_protocol(reader);
  set.seed = reader.integer("/", "seed", ranges::seed);
  set.records_digest = reader.text("/", "records_digest");
  set.windows = read_window_set(reader);
  if (set.windows.record.size() != set.windows.size()) {
    reader.refuse("/record", "is missing: the places of the windows in the records are unknown");
  }
  return set;
}

std::vector<std::string> check_roles(const std::vector<RoleSet>& sets) {
  std::vector<std::string> findings;
  for (const RoleSet& set : sets) note_differences(sets.front(), set, findings);
  // Roles of different splits may share windows, so the checks below would mean nothing.
  if (!findings.empty() || sets.empty()) return findings;
  for (const RoleSet& set : sets) {
    const std::string objection = condition_objection(set.role, set.windows);
    if (!objection.empty()) findings.push_back(set.file + ": " + objection);
  }
  const auto length = static_cast<std::int64_t>(sets.front().windows.length);
  const Protocol protocol = sets.front().protocol;
  for (const auto& entry : conflicts_in(pieces_in_time_order(sets), length, protocol)) {
    findings.push_back(line_of(entry, length));
  }
  return findings;
}

void require_one_split(const std::vector<RoleSet>& sets) {
  const std::vector<std::string> findings = check_roles(sets);
  if (!findings.empty()) throw Error(Exit::bad_input, findings.front());
}

WindowSet read_of_one_split(const artefact::Reader& other, Role role,
                            const artefact::Reader& known) {
  require_role(other, role);
  const std::vector<RoleSet> roles{read_role_set(known), read_role_set(other)};
  require_one_split(roles);
  require_belonging(other, role, roles.back().windows);
  return roles.back().windows;
}

}  // namespace piae::signal
