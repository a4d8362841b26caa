#include "signal/roles.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/error.hpp"

namespace piae::signal {

namespace {

/// One window on the time axis of its record.
struct Piece {
  std::int64_t first_sample;
  const RoleSet* set;
};
using Pieces = std::map<std::string, std::vector<Piece>>;  // by the record's name

/// Places at which two roles come too close in one record.
struct Conflict {
  std::size_t places = 0;
  std::int64_t first_sample = 0;  ///< of the first place
  std::int64_t distance = 0;  ///< there: samples between the ranges, negative where they overlap
};
using Conflicts = std::map<std::tuple<std::string, std::string, std::string>, Conflict>;

void compare(const RoleSet& one, const RoleSet& other, std::vector<std::string>& findings) {
  const auto differ = [&](const std::string& what, const std::string& a, const std::string& b) {
    if (a == b) return;
    findings.push_back(other.file + ": has " + what + " " + b + ", but " + one.file + " has " + a +
                       "; they are not of one split");
  };
  differ("protocol", one.protocol, other.protocol);
  differ("seed", std::to_string(one.seed), std::to_string(other.seed));
  differ("records_digest", one.records_digest, other.records_digest);
  differ("window length", std::to_string(one.windows.length), std::to_string(other.windows.length));
}

Pieces in_time_order(const std::vector<RoleSet>& sets) {
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

/// Windows have equal lengths, so neighbours in time order come closest.
Conflicts conflicts_in(const Pieces& pieces, std::int64_t length, bool blocked) {
  Conflicts conflicts;
  for (const auto& [record, of_record] : pieces) {
    for (std::size_t i = 1; i < of_record.size(); ++i) {
      const Piece& before = of_record[i - 1];
      const Piece& after = of_record[i];
      const std::int64_t distance = after.first_sample - before.first_sample - length;
      const bool too_close = blocked ? distance < length : distance == -length;
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
  const std::string who = "record " + record + ": roles " + one + " and " + other;
  const std::string where = " at sample " + std::to_string(conflict.first_sample) + " (" +
                            std::to_string(conflict.places) + " places)";
  if (conflict.distance == -length) return who + " share a window" + where;
  return who + " lie " + std::to_string(conflict.distance) + " samples apart" + where +
         "; a blocked split keeps " + std::to_string(length);
}

}  // namespace

void write(artefact::Writer& writer, const Origin& origin) {
  writer.attribute("/", "split_seed", origin.split_seed);
  writer.attribute("/", "protocol", origin.protocol);
  writer.attribute("/", "records_digest", origin.records_digest);
  writer.attribute("/", "known_digest", origin.known_digest);
}

Origin read_origin(const artefact::Reader& reader) {
  return {reader.integer("/", "split_seed"), reader.text("/", "protocol"),
          reader.text("/", "records_digest"), reader.text("/", "known_digest")};
}

Origin origin_of_known(const artefact::Reader& known) {
  return {known.integer("/", "seed"), known.text("/", "protocol"),
          known.text("/", "records_digest"), known.digest()};
}

void require_same_split(const artefact::Reader& generated, const artefact::Reader& real) {
  const Origin origin = read_origin(generated);
  if (origin.split_seed == real.integer("/", "seed") &&
      origin.protocol == real.text("/", "protocol") &&
      origin.records_digest == real.text("/", "records_digest")) {
    return;
  }
  generated.refuse("/", "was learned from the C of another split (seed " +
                            std::to_string(origin.split_seed) + ", " + origin.protocol +
                            ") than that of " + real.path().string() +
                            "; train and generate with this split's C");
}

void require_learned_from(const artefact::Reader& generated, const artefact::Reader& known) {
  if (read_origin(generated).known_digest == known.digest()) return;
  generated.refuse("/", "was learned from other known windows than " + known.path().string() +
                            ", which may be test windows here; train and generate with this C");
}

void require_role(const artefact::Reader& reader, const std::string& role) {
  const std::string holds = reader.text("/", "role");
  if (holds != role) reader.refuse("/", "has role " + holds + ", needed is " + role);
}

void require_classes(const artefact::Reader& reader, const std::string& role,
                     const WindowSet& windows) {
  for (std::size_t label = 0; label < windows.info.classes.size(); ++label) {
    const ClassInfo& c = windows.info.classes[label];
    const bool healthy = c.defect == Defect::none;
    const bool wanted = role == "A" || healthy == (role == "B");
    const bool present = windows.count_of(static_cast<int>(label)) > 0;
    if (wanted && !present) reader.refuse("/labels", "has no window of class " + c.name);
    if (!wanted && present) {
      reader.refuse("/labels",
                    "has windows of class " + c.name + ", which role " + role + " must not have");
    }
  }
}

RoleSet read_role_set(const artefact::Reader& reader) {
  RoleSet set;
  set.file = reader.path().string();
  set.role = reader.text("/", "role");
  set.protocol = reader.text("/", "protocol");
  set.seed = reader.integer("/", "seed");
  set.records_digest = reader.text("/", "records_digest");
  set.windows = read_window_set(reader);
  if (set.windows.record.size() != set.windows.size()) {
    reader.refuse("/record", "is missing: the windows do not say where they were cut");
  }
  return set;
}

std::vector<std::string> check_roles(const std::vector<RoleSet>& sets) {
  std::vector<std::string> findings;
  for (const RoleSet& set : sets) compare(sets.front(), set, findings);
  if (!findings.empty() || sets.empty()) return findings;  // samples of different splits may meet
  const auto length = static_cast<std::int64_t>(sets.front().windows.length);
  const bool blocked = sets.front().protocol == "blocked";
  for (const auto& entry : conflicts_in(in_time_order(sets), length, blocked)) {
    findings.push_back(line_of(entry, length));
  }
  return findings;
}

void require_one_split(const std::vector<RoleSet>& sets) {
  const std::vector<std::string> findings = check_roles(sets);
  if (!findings.empty()) throw Error(Exit::bad_input, findings.front());
}

}  // namespace piae::signal
