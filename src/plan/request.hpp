#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "plan/parts.hpp"
#include "signal/protocol.hpp"

namespace piae::plan {

/// A request to make, as typed. Lists that are not given follow from the goals.
struct Request {
  std::vector<std::string> goals = {"all"};  ///< names of goals, or files of a run
  std::string run = "paper";                 ///< folder under results/
  std::optional<std::string> datasets = std::nullopt;
  std::optional<std::string> methods = std::nullopt;
  std::optional<std::string> ratios = std::nullopt;
  std::optional<std::string> classifiers = std::nullopt;
  std::optional<std::string> seeds = std::nullopt;
  signal::Protocol protocol = signal::Protocol::random;
  std::string data_dir = "data";       ///< folder of the recordings
  std::vector<std::string> held = {};  ///< data sets of which the run holds cells
};

/// A checked request without open choices.
struct Choice {
  std::vector<std::string> goals;  ///< names
  std::vector<std::string> files;  ///< requested files of the grid
  /// Pictures to be drawn, if they are requested as files; else all.
  std::optional<std::vector<std::string>> only_pictures = std::nullopt;
  std::string run;
  signal::Protocol protocol = signal::Protocol::random;
  std::string data_dir;
  std::vector<Part> parts;
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> classifiers;
  std::vector<std::int64_t> seeds;
  bool ratios_given = false;
  bool classifiers_given = false;
  std::int64_t lowest_seed = 0;  ///< features are kept for this seed
  /// True if a run is only viewed: then only the cells that `given` names are mandatory.
  bool only_looks = false;
  std::vector<std::string>
      given;  ///< --methods, --ratios, ... as given, for a run that is only viewed
  /// True if tables are made from the existing cells although others are missing.
  bool with_missing = false;
  /// Lines that name what is left out, and why, for people (parts.hpp).
  std::vector<std::string> notices;

  [[nodiscard]] bool has_goal(const std::string& name) const;
  /// Returns the folder of the run, such as results/try or results/try-blocked.
  [[nodiscard]] std::string folder() const { return folder_of(protocol); }
  [[nodiscard]] std::string folder_of(signal::Protocol of) const;
};

/// Checks a request and completes it. Throws Error(usage), with the name of the variable, such as
/// METHODS, for a word that is unknown, missing or repeated; for an impossible name of a run; and
/// for goals without cells.
Choice choose(const Experiment& experiment, const Request& request);

}  // namespace piae::plan
