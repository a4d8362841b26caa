#pragma once

#include "artefact/reader.hpp"
#include "classification/sources.hpp"
#include "cli/stage.hpp"
#include "diagnosis/kept_classifier.hpp"

namespace piae::classification {

/// Fits the network of `teach` to the machine of the sources, by the healthy records that
/// Sources::healthy names. Its classes are healthy, inner, ball and outer. A window has 4096
/// samples, or more where the shaft would turn less than 2.3 times, as no simulated machine does
/// (machines/machine.hpp); reference windows overlap by three quarters. Throws Error(usage) without
/// healthy records or for a lone file, and as read() and diagnosis::fit_any_bearing() do.
diagnosis::KeptClassifier fit_to_machine(cli::Stage& stage, const artefact::Reader& network,
                                         const Sources& sources);

}  // namespace piae::classification
