#pragma once

#include <cstddef>
#include <memory>

#include "artefact/reader.hpp"
#include "augment/method.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

/// Returns the method that made a model. Throws artefact::Refusal for an unknown name.
std::unique_ptr<Method> method_of(const artefact::Reader& model);

/// Returns the windows of method.generate(). Throws artefact::Refusal if the curves and other
/// records of the training are impossible, or the samples are not finite, as weights no training
/// leaves would make them.
signal::WindowSet generate_with(Method& method, const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const Compute& compute);

/// Reads the windows that a model stores, C or, for a ceiling, D. Throws artefact::Refusal if a
/// class lacks windows or has windows it should not have; Error if no window is known and
/// the method learns from them.
signal::WindowSet read_learned(const artefact::Reader& model, signal::Role role);

/// Reads all that any stage reads from a model, with the same functions, and makes a window of each
/// class. Throws Error if a stage would refuse the model. Weights that only LibTorch can use are
/// not checked.
void require_usable(const artefact::Reader& model);

}  // namespace piae::augment
