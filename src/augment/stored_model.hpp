#pragma once

#include <cstddef>
#include <memory>

#include "artefact/reader.hpp"
#include "augment/method.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

/// The method that made a model. Throws artefact::Refusal for a name that no method has.
std::unique_ptr<Method> method_of(const artefact::Reader& model);

/// What method.generate() makes of the model. Throws artefact::Refusal also for curves and the like
/// that no training has, and where it makes samples that are not finite, as it does of weights that
/// no training leaves.
signal::WindowSet generate_with(Method& method, const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const Compute& compute);

/// The windows that a model stores because its method needs no more: C or, of a ceiling, D. Throws
/// artefact::Refusal where a class has none that should, or has some that should not; Error where
/// there are no known windows and the method learns from those.
signal::WindowSet read_learned(const artefact::Reader& model, signal::Role role);

/// Reads all that a stage would read of a model, by what the stages read it with, and makes a
/// window of each class with it. Throws Error for what they would refuse. Of a method that only
/// LibTorch can compute, the weights are not looked at.
void require_usable(const artefact::Reader& model);

}  // namespace piae::augment
