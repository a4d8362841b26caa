#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "artefact/reader.hpp"
#include "cli/stage.hpp"
#include "signal/protocol.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Windows that a diagnosis needs: the roles A, B and C of one split and, if the ratio needs them,
/// generated windows E.
struct Inputs {
  signal::WindowSet test;                                ///< A
  signal::WindowSet normal;                              ///< B
  signal::WindowSet known;                               ///< C
  std::optional<signal::WindowSet> generated;            ///< E
  std::optional<signal::WindowSet> unlabelled = {};      ///< D, for a classifier that adapts
  std::string method = "none";                           ///< the method that generated E
  signal::Protocol protocol = signal::Protocol::random;  ///< protocol of the split
};

/// Reads the windows; `generated` is null without E, `unlabelled` without D. Throws
/// Error(bad_input) if a file has another role than its option requires, or if A to D are not of
/// one split or share a window (signal/roles.hpp). Throws also if E was learned from other known
/// windows than C: its generator may then have seen test windows of A.
Inputs read_inputs(const artefact::Reader& test, const artefact::Reader& normal,
                   const artefact::Reader& known, const artefact::Reader* generated,
                   const artefact::Reader* unlabelled = nullptr);

/// Files of these windows.
struct InputFiles {
  std::filesystem::path test;
  std::filesystem::path normal;
  std::filesystem::path known;
  std::filesystem::path generated;   ///< empty without E
  std::filesystem::path unlabelled;  ///< empty without D
};

void bind(cli::Stage& stage, InputFiles& files);
/// Throws as above, and for a file that is not a set of windows.
Inputs read_inputs(cli::Stage& stage, const InputFiles& files);

}  // namespace piae::diagnosis
