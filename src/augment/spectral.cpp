#include "augment/spectral.hpp"

#include <complex>
#include <numbers>

#include "augment/stored_model.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"
#include "spectra/fft.hpp"

namespace piae::augment {

std::vector<double> with_random_phases(Window window, Stream& random) {
  std::vector<double> samples(window.begin(), window.end());
  std::vector<std::complex<double>> spectrum(samples.size() / 2 + 1);
  spectra::fft(samples, spectrum);
  for (std::size_t i = 1; 2 * i < samples.size(); ++i) {
    spectrum[i] = std::polar(std::abs(spectrum[i]), random.uniform(0, 2 * std::numbers::pi));
  }
  spectra::inverse_fft(spectrum, samples);
  return samples;
}

cli::StoredOptions Spectral::table() {
  cli::StoredOptions table;
  impacts::add_to(table, equaliser_);
  return table;
}

void Spectral::bind(const cli::Options& command) { table().bind(command); }

void Spectral::train(const signal::WindowSet& known, const Stream& /*stream*/,
                     const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                     artefact::Writer& model) {
  signal::write(model, known);
  table().write(model);
}

signal::WindowSet Spectral::generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  table().read(model);
  const auto bins = static_cast<Eigen::Index>(known.length / 2 + 1);
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const std::vector<std::size_t> own = known.indices_of(label);
    const std::size_t parent = own[index % own.size()];
    std::vector<double> samples = with_random_phases(known.window(parent), random);
    impacts::equalise(samples, impacts::draw_gains(random, bins, equaliser_));
    signal::MadeWindow made(std::vector<float>(samples.begin(), samples.end()));
    made.parents = signal::parents_of({parent});
    return made;
  };
  return signal::make_windows(known.info, known.length, count, stream, make);
}

}  // namespace piae::augment
