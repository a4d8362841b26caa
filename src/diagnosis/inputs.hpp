#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "signal/protocol.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// What a diagnosis is made of: roles A, B and C of one split, and where the ratio needs them the
/// generated windows E.
struct Inputs {
  signal::WindowSet test;                      ///< A
  signal::WindowSet normal;                    ///< B
  signal::WindowSet known;                     ///< C
  std::optional<signal::WindowSet> generated;  ///< E
  std::string method = "none";                 ///< that generated E
  signal::Protocol protocol = signal::Protocol::random;  ///< of the split
};

/// `generated` is null where there is no E. Throws Error(bad_input) when a file has another role
/// than its option asks for, when A, B and C are not of one split or share a window
/// (signal/roles.hpp), and when E was made for another repeat (seed) or protocol: a window of A may
/// then have been known to its generator.
Inputs read_inputs(const artefact::Reader& test, const artefact::Reader& normal,
                   const artefact::Reader& known, const artefact::Reader* generated);

}  // namespace piae::diagnosis
