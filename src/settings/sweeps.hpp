#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// Sweep of one method: settings such as "batch=1", tried one at a time.
struct Sweep {
  std::string method;
  std::string classifier;           ///< that judges it
  std::vector<std::string> points;  ///< in the order of the protocol
  /// Points equal to the method's own settings. "5e-4" and "0.0005" are equal.
  std::vector<std::string> centre;
};

/// Returns [sweep], for the paper's method and classifier, then each [sweep.METHOD], in the order
/// of the catalogue. Leaves out tables without points.
std::vector<Sweep> sweeps(const toml::table& protocol);

/// Returns the methods that may have a table in [sweep]: all except ceilings and the paper's
/// method, whose points are in [sweep] itself.
std::vector<std::string> others_that_are_swept();

/// Refuses, as read_protocol() does, a sweep without points, with a point that is not a valid
/// option of its method, with an unknown classifier, or with any other key.
void require_sweeps(const std::filesystem::path& file, const toml::table& protocol);

}  // namespace piae::settings
