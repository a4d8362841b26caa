#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// What `make sweep` tries of one method: settings such as "batch=1", one at a time.
struct Sweep {
  std::string method;
  std::string classifier;           ///< by which it is judged
  std::vector<std::string> points;  ///< in the order of the protocol
  /// Those points that the method has without the sweep. "5e-4" and "0.0005" are the same.
  std::vector<std::string> centre;
};

/// [sweep], which is of the paper's method and of its classifier, and then each [sweep.METHOD], in
/// the order of the catalogue. One without points is left out.
std::vector<Sweep> sweeps(const toml::table& protocol);

/// The methods that may have a table in [sweep], whose own values are of the paper's method. A
/// ceiling is no method.
std::vector<std::string> others_that_are_swept();

/// Refuses, as read_protocol() does, a sweep with a point that is no option of its method, or none
/// that it takes, with a classifier that there is not, without points, and with anything else.
void require_sweeps(const std::filesystem::path& file, const toml::table& protocol);

}  // namespace piae::settings
