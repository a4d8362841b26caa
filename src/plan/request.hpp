#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "plan/parts.hpp"
#include "signal/protocol.hpp"

namespace piae::plan {

/// A request to make, as it was typed. A list that is not given is chosen by the goals.
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
  std::vector<std::string> held = {};  ///< the data sets of which the run holds anything
};

/// A request with every open choice made and checked.
struct Choice {
  std::vector<std::string> goals;  ///< names
  std::vector<std::string> files;  ///< files of the grid that are asked for
  /// The pictures to be drawn, where they are asked for by their files; else all.
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
  std::int64_t lowest_seed = 0;  ///< the one of which features are kept
  /// True if a run is only looked at: nothing is asked for but what `given` names.
  bool only_looks = false;
  std::vector<std::string> given;  ///< --methods, --ratios, ... as they were given, for such a look
  /// True if tables are made from the cells that exist, although others are missing.
  bool with_holes = false;
  /// Notices of what is left out, and why: a line for each data set, for people.
  std::vector<std::string> notices;

  [[nodiscard]] bool has_goal(const std::string& name) const;
  /// The run's folder, such as results/try or results/try-blocked.
  [[nodiscard]] std::string folder() const { return folder_of(protocol); }
  [[nodiscard]] std::string folder_of(signal::Protocol of) const;
};

/// Throws Error(usage) with the name of the variable, such as METHODS, for a word that is unknown,
/// missing or there twice, for a run that cannot have this name, and for goals that have no cells
/// with what is asked for.
Choice choose(const Experiment& experiment, const Request& request);

}  // namespace piae::plan
