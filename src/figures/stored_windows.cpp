#include "figures/stored_windows.hpp"

namespace piae::figures {

using signal::WindowSet;

WindowSet read_windows(const std::filesystem::path& file, signal::Role role) {
  const artefact::Reader reader(file, "windows");
  signal::require_role(reader, role);
  WindowSet windows = signal::read_window_set(reader);
  signal::require_belonging(reader, role, windows);
  return windows;
}

WindowSet read_windows_with(const WindowSet& real, const std::filesystem::path& file,
                            signal::Role role) {
  WindowSet windows = read_windows(file, role);
  if (windows.length != real.length || windows.info.classes.size() != real.info.classes.size() ||
      windows.info.conditions != real.info.conditions) {
    throw Error(Exit::bad_input, file.string() + ": is not of the data set of D.h5");
  }
  return windows;
}

std::optional<WindowSet> read_generated(const Source& source, const std::string& method,
                                        const WindowSet& real) {
  const std::int64_t seed = source.shown_seed();
  const auto file = source.layout().generated_windows(method, seed);
  if (!source.has(method, seed, file)) return std::nullopt;
  return read_windows_with(real, file, signal::Role::generated);
}

}  // namespace piae::figures
