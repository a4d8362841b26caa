#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// A window set that one split made, with what says which split that was.
struct RoleSet {
  std::string file;
  std::string role;      ///< "A", "B", "C" or "D"
  std::string protocol;  ///< "random" or "blocked"
  std::int64_t seed = 0;
  std::string records_digest;  ///< of the records that were split
  WindowSet windows;
};

/// The split that windows come from. A model and the windows it makes carry that of the C they were
/// learned from, and the content digest of that C, so that no generator that has seen windows of
/// another split's C can be tried on this one's A or D.
struct Origin {
  std::int64_t split_seed = 0;
  std::string protocol;
  std::string records_digest;
  std::string known_digest;  ///< of C
};

/// As attributes of the root: split_seed, protocol, records_digest, known_digest.
void write(artefact::Writer& writer, const Origin& origin);
/// Of a model or of generated windows.
Origin read_origin(const artefact::Reader& reader);
/// Of what is learned from this C.
Origin origin_of_known(const artefact::Reader& known);

/// Throws artefact::Refusal when generated windows come from another split than D, or from another
/// C.
void require_same_split(const artefact::Reader& generated, const artefact::Reader& real);
void require_learned_from(const artefact::Reader& generated, const artefact::Reader& known);

/// Throws artefact::Refusal when a window set plays another role ("A" to "D", or "E").
void require_role(const artefact::Reader& reader, const std::string& role);

/// A must hold every class, B the healthy one, C, D and E every class with a defect, and none of
/// them any other. Throws artefact::Refusal naming the class.
void require_classes(const artefact::Reader& reader, const std::string& role,
                     const WindowSet& windows);

/// Reads a role of a split. Throws artefact::Refusal when an attribute is missing or the windows do
/// not say where they were cut.
RoleSet read_role_set(const artefact::Reader& reader);

/// Proves from what is stored that the sets are roles of one split and that no window plays two:
///   - protocol, seed, records_digest and window length are the same in all,
///   - no (record, first sample) has two roles,
///   - for "blocked", samples of different roles lie at least one window length apart.
/// Returns one line for each thing that is not so; nothing when all is good.
std::vector<std::string> check_roles(const std::vector<RoleSet>& sets);

/// Throws Error(bad_input) with the first of these lines.
void require_one_split(const std::vector<RoleSet>& sets);

}  // namespace piae::signal
