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
  Eigen::ArrayXd log_amplitude;  ///< by impacts/response.hpp, with the mean 0
};

/// Returns the spectra of healthy windows B, one for each tested condition that has such windows.
std::vector<HealthySpectrum> healthy_spectra(const signal::WindowSet& healthy);

/// Returns the spectrum of a condition; null if there is none.
const HealthySpectrum* find_spectrum(const std::vector<HealthySpectrum>& spectra,
                                     std::int32_t condition);

/// Writes /healthy/condition int32 [m] and /healthy/log_amplitude float64 [m, bins].
void write(artefact::Writer& writer, const std::vector<HealthySpectrum>& spectra);
/// Returns an empty vector if the model has no spectra. Throws artefact::Refusal if the number of
/// bins is wrong or a condition is not tested.
std::vector<HealthySpectrum> read_healthy_spectra(const artefact::Reader& reader,
                                                  const signal::WindowSet& known);

}  // namespace piae::transfer
