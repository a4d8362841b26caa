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

/// Which windows of a split are learned from.
enum class LearnsFrom {
  known,  ///< C: every method learns from these
  real,   ///< D, the real windows that generated ones replace: only a ceiling may see these
};

/// One way of making fault windows from the few that are known. A new method is a class of its own
/// and an entry in catalogue.cpp; programs, grid and tables learn of it there.
class Method {
 public:
  virtual ~Method() = default;

  [[nodiscard]] virtual LearnsFrom learns_from() const { return LearnsFrom::known; }

  /// Whether LibTorch is to compute the method's networks when this back end and device are asked
  /// for. LibTorch takes long to start, so it is linked to programs of its own. Throws Error(usage)
  /// for a back end and a device that do not go together. What stands here is for methods without
  /// networks, which never need LibTorch.
  [[nodiscard]] virtual bool needs_libtorch(const Compute& compute) const;

  /// Takes healthy windows B of the split before train(), of a method that can learn of the
  /// machine's background from them. What stands here is for the others: std::logic_error.
  virtual void hear(const signal::WindowSet& healthy);

  /// Adds the options of the program `train` that are this method's own.
  virtual void bind(const cli::Options& command) = 0;

  /// Learns from the known fault windows C (or those that learns_from() says) and writes what
  /// generate() needs into the model. A long training must run through nets::run_epochs() with the
  /// checkpoint.
  virtual void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                     const nets::Checkpoint& checkpoint, artefact::Writer& model) = 0;

  /// Makes `count` windows of each class with a defect, class by class. Window i of a class must
  /// not depend on `count`, so its random numbers must come from the stream's child "<class>/<i>".
  virtual signal::WindowSet generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& compute) = 0;

  /// Infers stiffness and damping of each window; the model need not have seen these windows.
  /// Throws Error(usage) where the method can infer neither.
  virtual std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                                       const signal::WindowSet& windows,
                                                       const Compute& compute);
};

}  // namespace piae::augment
