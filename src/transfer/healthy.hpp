#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/window_set.hpp"

namespace piae::transfer {

/// Spectrum of the healthy machine in a tested condition.
struct HealthySpectrum {
  std::int32_t condition = signal::every_condition;
  Eigen::ArrayXd log_amplitude;  ///< of impacts/response.hpp, with the mean 0
};

/// Spectra of healthy windows B, one for each tested condition that they have.
std::vector<HealthySpectrum> healthy_spectra(const signal::WindowSet& healthy);

/// The spectrum of a condition; null if there is none.
const HealthySpectrum* find_spectrum(const std::vector<HealthySpectrum>& spectra,
                                     std::int32_t condition);

/// In the artefact: /healthy/condition int32 [m] and /healthy/log_amplitude float64 [m, bins].
void write(artefact::Writer& writer, const std::vector<HealthySpectrum>& spectra);
/// Empty if the model has none. Throws artefact::Refusal for another number of bins, and for
/// conditions that no data set has.
std::vector<HealthySpectrum> read_healthy_spectra(const artefact::Reader& reader,
                                                  const signal::WindowSet& known);

}  // namespace piae::transfer
