#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/compute.hpp"
#include "base/random.hpp"
#include "cli/options.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

/// Windows of a split that a method learns from.
enum class LearnsFrom {
  known,  ///< C: every method learns from these
  real,   ///< D, the real windows that generated ones replace; only a ceiling may use D
};

/// A way of making fault windows from the few known ones. To add a method, write a class and an
/// entry in catalogue.cpp; programs, grid and tables read the catalogue.
class Method {
 public:
  virtual ~Method() = default;

  [[nodiscard]] virtual LearnsFrom learns_from() const { return LearnsFrom::known; }

  /// True if LibTorch computes the method's networks on this back end and device. LibTorch starts
  /// slowly, so separate programs link it. Throws Error(usage) if back end and device do not match.
  /// The default is for methods without networks, which never need LibTorch.
  [[nodiscard]] virtual bool needs_libtorch(const Compute& compute) const;

  /// Takes healthy windows B of the split before train(), for methods that learn the machine's
  /// background from them. The default throws std::logic_error.
  virtual void use_healthy(const signal::WindowSet& healthy);

  /// Adds the method's own options to the program `train`.
  virtual void bind(const cli::Options& command) = 0;

  /// Learns from the known fault windows C (or those of learns_from()) and writes what generate()
  /// needs into the model. A long training must run in nets::run_epochs() with the checkpoint.
  virtual void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                     const nets::Checkpoint& checkpoint, artefact::Writer& model) = 0;

  /// Returns what the user should know about the last training, in brackets after a blank, for the
  /// line that `train` prints. The default is empty.
  [[nodiscard]] virtual std::string remark() const { return {}; }

  /// Makes `count` windows of each fault class, class by class. Window i of a class must not depend
  /// on `count`, so its random numbers must come from the stream's child "<class>/<i>".
  virtual signal::WindowSet generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& compute) = 0;

  /// Infers stiffness and damping of each window; the windows may be new to the model. Throws
  /// Error(usage) if the method cannot infer them.
  virtual std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                                       const signal::WindowSet& windows,
                                                       const Compute& compute);
};

}  // namespace piae::augment
