#pragma once

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "scoring/windows.hpp"
#include "signal/window_set.hpp"

namespace piae::testing_sets {

/// A folder that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "piae-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Normal, IR and OR.
inline signal::DatasetInfo three_classes(const std::string& name = "toy") {
  signal::DatasetInfo info;
  info.name = name;
  info.sample_rate_hz = 12000;
  info.shaft_speed_rpm = 1800;
  info.classes = {{"Normal", signal::Defect::none, 0},
                  {"IR", signal::Defect::inner, 0.2},
                  {"OR", signal::Defect::outer, 0.2}};
  return info;
}

/// Windows of normally distributed samples.
inline scoring::Windows noise(std::size_t count, std::size_t length, const std::string& name) {
  Stream stream(name);
  scoring::Windows windows(count, length);
  for (double& sample : windows.reshaped()) sample = stream.normal(0, 1);
  return windows;
}

inline void add(signal::WindowSet& set, int label, const std::vector<float>& window) {
  set.length = window.size();
  set.samples.insert(set.samples.end(), window.begin(), window.end());
  set.labels.push_back(label);
}

}  // namespace piae::testing_sets
