#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/protocol.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// Use of a set of windows (paper, Table 2). Files and messages name a role by its letter.
enum class Role {
  test,      ///< A: every class; tests the classifier
  healthy,   ///< B: healthy class; trains the classifier
  known,     ///< C: every fault class, or empty; trains generators and the classifier
  hidden,    ///< D: every fault class; real windows to compare E with
  generated  ///< E: every fault class; made by a generator
};

/// Roles that a split assigns. Generated windows do not belong to a split.
inline constexpr std::array<Role, 4> split_roles{Role::test, Role::healthy, Role::known,
                                                 Role::hidden};

/// Returns "A" to "E".
std::string to_string(Role role);

/// Reads the attribute `role` of a window set. Throws artefact::Refusal for an unknown role.
Role read_role(const artefact::Reader& reader);

/// Reads the method of a model, of generated windows, or of measurements of them. Throws
/// artefact::Refusal for an invalid name (ranges.hpp).
std::string read_method(const artefact::Reader& reader);

/// Throws artefact::Refusal if a window set has another role.
void require_role(const artefact::Reader& reader, Role role);

/// True if a role may hold windows of a condition: A, D and E need a tested one, B one for healthy
/// windows, C a known one.
bool may_hold(Role role, const Condition& condition);

/// Throws artefact::Refusal, naming the class or the condition, if a role holds wrong windows. A
/// must hold every class, B only the healthy one, C, D and E exactly the classes with a defect.
/// Only C may be empty: then no fault is known. Conditions must satisfy may_hold().
void require_belonging(const artefact::Reader& reader, Role role, const WindowSet& windows);

/// The windows of one role, and the split that they come from.
struct RoleSet {
  std::string file;  ///< source of the windows, for messages
  Role role = Role::test;
  Protocol protocol = Protocol::random;
  std::int64_t seed = 0;
  std::string records_digest;  ///< content digest of the recordings that were split
  WindowSet windows;
};

/// Reads a role. Throws artefact::Refusal if an attribute or the windows' places are missing.
RoleSet read_role_set(const artefact::Reader& reader);

/// Checks from stored data that the sets are roles of one split and that no window has two roles:
///   - protocol, seed, records_digest, window length and conditions are the same in all,
///   - no window has a condition that its role may not hold,
///   - no (record, first sample) has two roles,
///   - under Protocol::blocked, samples of different roles lie at least one window length apart.
/// Returns one line for each violation; empty without violations.
std::vector<std::string> check_roles(const std::vector<RoleSet>& sets);

/// Throws Error(bad_input) with the first line of check_roles(), if any.
void require_one_split(const std::vector<RoleSet>& sets);

/// Reads the windows of a role. Throws artefact::Refusal if it is another role, and
/// Error(bad_input) if the places of the windows show another split than that of the known windows.
WindowSet read_of_one_split(const artefact::Reader& other, Role role,
                            const artefact::Reader& known);

/// The known windows (C) of a model and of the windows that it generates. A generator trained on
/// the C of another split may have used windows that are A or D here. Its windows must not be
/// tested here.
struct Origin {
  std::int64_t split_seed = 0;
  Protocol protocol = Protocol::random;
  std::string records_digest;  ///< content digest of the recordings that were split
  std::string known_digest;    ///< content digest of C
};

/// Writes attributes of the root: split_seed, protocol, records_digest, known_digest.
void write(artefact::Writer& writer, const Origin& origin);
/// Reads the origin of a model or of generated windows.
Origin read_origin(const artefact::Reader& reader);
/// Returns the origin of models trained on this C.
Origin origin_of_known(const artefact::Reader& known);

/// Throws artefact::Refusal if the generated windows come from another split than these hidden
/// windows (D).
void require_same_split(const artefact::Reader& generated, const artefact::Reader& hidden);
/// Throws artefact::Refusal if the generated windows were learned from another C.
void require_learned_from(const artefact::Reader& generated, const artefact::Reader& known);

}  // namespace piae::signal
