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

/// The windows of a split that a method may see.
enum class LearnsFrom {
  known,  ///< C. So do all methods
  real,   ///< D, the real windows that generated ones are to replace: of a ceiling, not a method
};

/// One way of making fault windows from the few that are known: an entry of the grid's METHODS.
/// A new one is a class of its own and an entry in catalogue.cpp; programs, grid and tables learn of
/// it there.
class Method {
 public:
  virtual ~Method() = default;

  [[nodiscard]] virtual LearnsFrom learns_from() const { return LearnsFrom::known; }

  /// Whether LibTorch computes its networks where this is asked for: LibTorch takes long to start,
  /// so it is linked to programs of its own. Throws Error(usage) for what cannot be, also of a
  /// method without networks, which this is for.
  [[nodiscard]] virtual bool needs_libtorch(const Compute& compute) const;

  /// Adds the options of `train` that are this method's own.
  virtual void bind(const cli::Options& command) = 0;

  /// Learns from the known fault windows C (or those of learns_from) and writes what `generate`
  /// needs into the model. Long training runs through nets::run_epochs with the checkpoint.
  virtual void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                     const nets::Checkpoint& checkpoint, artefact::Writer& model) = 0;

  /// `count` windows of each class with a defect, class by class. Window i of a class must not
  /// depend on `count`: its random numbers come from the stream's child "<class>/<i>".
  virtual signal::WindowSet generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& compute) = 0;

  /// Stiffness and damping of windows that the model has not seen, one for each. Throws
  /// Error(usage) where the method knows neither.
  virtual std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                                       const signal::WindowSet& windows,
                                                       const Compute& compute);
};

}  // namespace piae::augment
