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

/// What a set of windows is for (paper, Table 2). Files and messages name a role by its letter.
enum class Role {
  test,      ///< A: of every class; what the classifier is tried on
  healthy,   ///< B: of the healthy class; what the classifier learns from
  known,     ///< C: of every fault class, or none; what generators and the classifier learn from
  hidden,    ///< D: of every fault class; what generated windows are compared with
  generated  ///< E: of every fault class; made by a generator
};

/// The roles that a split deals out. Generated windows are of no split.
inline constexpr std::array<Role, 4> split_roles{Role::test, Role::healthy, Role::known,
                                                 Role::hidden};

/// "A" to "E".
std::string to_string(Role role);

/// The attribute `role` of a window set. Throws artefact::Refusal for a word that is none.
Role read_role(const artefact::Reader& reader);

/// The name of the method to which an artefact is owed: of a model, of what it has made, and of
/// what was measured with that. Throws artefact::Refusal for what is no plain name (ranges.hpp).
std::string read_method(const artefact::Reader& reader);

/// Throws artefact::Refusal when a window set has another role.
void require_role(const artefact::Reader& reader, Role role);

/// Whether windows of a condition may have a role: A, D and E a tested one, B one for healthy
/// windows, C a known one.
bool may_hold(Role role, const Condition& condition);

/// A must hold every class, B the healthy one, C, D and E every class with a defect, and none of
/// them any other, nor windows of a condition that may_hold() denies them. C alone may hold no
/// window at all: no fault is known then. Throws artefact::Refusal naming the class or the
/// condition.
void require_belonging(const artefact::Reader& reader, Role role, const WindowSet& windows);

/// The windows of one role of a split, and which split that was.
struct RoleSet {
  std::string file;  ///< where they were read, for messages
  Role role = Role::test;
  Protocol protocol = Protocol::random;
  std::int64_t seed = 0;
  std::string records_digest;  ///< content digest of the recordings that were split
  WindowSet windows;
};

/// Throws artefact::Refusal when an attribute is missing, or when the windows do not say where they
/// were cut.
RoleSet read_role_set(const artefact::Reader& reader);

/// Proves from what is stored that the sets are roles of one split and that no window has two:
///   - protocol, seed, records_digest, window length and conditions are the same in all,
///   - no window is of a condition that its role may not hold,
///   - no (record, first sample) has two roles,
///   - under Protocol::blocked, samples of different roles lie at least one window length apart.
/// Returns one line for each thing that is not so; nothing when all is good.
std::vector<std::string> check_roles(const std::vector<RoleSet>& sets);

/// Throws Error(bad_input) with the first line of check_roles(), where there is one.
void require_one_split(const std::vector<RoleSet>& sets);

/// Reads the windows of a role. Throws artefact::Refusal where they are not of the split of the
/// known windows, which is proved by where each window was cut.
WindowSet read_of_one_split(const artefact::Reader& other, Role role,
                            const artefact::Reader& known);

/// Which known windows (C) a model was trained on. The model and the windows that it makes both
/// carry this. A generator that has seen the C of another split may have seen windows that are A or
/// D in this one, so what it makes must not be tried here.
struct Origin {
  std::int64_t split_seed = 0;
  Protocol protocol = Protocol::random;
  std::string records_digest;  ///< content digest of the recordings that were split
  std::string known_digest;    ///< content digest of C
};

/// Written as attributes of the root: split_seed, protocol, records_digest, known_digest.
void write(artefact::Writer& writer, const Origin& origin);
/// Reads the origin of a model or of generated windows.
Origin read_origin(const artefact::Reader& reader);
/// The origin of whatever will be trained on this C.
Origin origin_of_known(const artefact::Reader& known);

/// Throws artefact::Refusal when the generated windows come from another split than these hidden
/// windows (D).
void require_same_split(const artefact::Reader& generated, const artefact::Reader& hidden);
/// Throws artefact::Refusal when the generated windows were learned from another C than this one.
void require_learned_from(const artefact::Reader& generated, const artefact::Reader& known);

}  // namespace piae::signal
