#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "augment/catalogue.hpp"
#include "support/checkpoints.hpp"
#include "support/command_line.hpp"
#include "support/folder.hpp"
#include "support/known_windows.hpp"

namespace piae::augment {

/// Returns the method with options set as on the command line of `train`.
inline std::unique_ptr<Method> method_with(const std::string& name, const std::string& options) {
  std::unique_ptr<Method> method = make_method(name);
  cli::parse(options, [&](const cli::Options& command) { method->bind(command); });
  return method;
}

/// Returns the windows as healthy ones, at a shaft speed that gives impacts of each defect within
/// 64 samples.
inline signal::WindowSet as_healthy(signal::WindowSet windows) {
  windows.info.shaft_speed_rpm = 3600;
  windows.labels.assign(windows.size(), windows.info.healthy_label());
  return windows;
}

/// Trains on the known windows and returns the stored model. Methods that require healthy windows
/// get the same windows as healthy ones.
inline std::filesystem::path train(const std::string& method, const std::string& options,
                                   const signal::WindowSet& known,
                                   const nets::Checkpoint& checkpoint, const std::string& name) {
  artefact::Writer writer("model");
  const std::unique_ptr<Method> learner = method_with(method, options);
  if (find_entry(method)->healthy == Healthy::required) learner->use_healthy(as_healthy(known));
  learner->train(known, Stream("train"), {}, checkpoint, writer);
  std::filesystem::path path = scratch_file(name);
  writer.save(path, {});
  return path;
}

inline signal::WindowSet generate(const std::string& method, const std::filesystem::path& model,
                                  std::size_t count) {
  return make_method(method)->generate(artefact::Reader(model, "model"), count, Stream("generate"),
                                       {});
}

}  // namespace piae::augment
