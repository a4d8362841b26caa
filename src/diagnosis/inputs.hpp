#pragma once

#include <optional>
#include <string>

#include "artefact/reader.hpp"
#include "signal/protocol.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// The windows that a diagnosis needs: the roles A, B and C of one split and, where the ratio asks
/// for them, generated windows E.
struct Inputs {
  signal::WindowSet test;                                ///< A
  signal::WindowSet normal;                              ///< B
  signal::WindowSet known;                               ///< C
  std::optional<signal::WindowSet> generated;            ///< E
  std::string method = "none";                           ///< the method that generated E
  signal::Protocol protocol = signal::Protocol::random;  ///< that of the split
};

/// `generated` is null where there is no E. Throws Error(bad_input) when a file has another role
/// than its option asks for, when A, B and C are not of one split or share a window
/// (signal/roles.hpp), and when E was learned from other known windows than C: its generator may
/// then have seen windows that A tests with.
Inputs read_inputs(const artefact::Reader& test, const artefact::Reader& normal,
                   const artefact::Reader& known, const artefact::Reader* generated);

}  // namespace piae::diagnosis
