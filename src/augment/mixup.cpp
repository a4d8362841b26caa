#include "augment/mixup.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <complex>

#include "augment/stored_model.hpp"
#include "base/error.hpp"
#include "base/label.hpp"
#include "signal/made_windows.hpp"
#include "spectra/fft.hpp"

namespace piae::augment {

namespace {

/// Stream::beta() allows no smaller shape; above 100 lambda is 0.5 to 4 %.
constexpr Range alpha_range{.low = 0.05, .high = 100};

using Spectrum = std::vector<std::complex<double>>;

Spectrum spectrum_of_window(Window window) {
  Spectrum spectrum(window.size() / 2 + 1);
  spectra::fft(std::vector<double>(window.begin(), window.end()), spectrum);
  return spectrum;
}

/// Returns the shift s at which the sum over t of reference(t) window(t + s) is largest.
std::size_t lag_behind(Window reference, Window window) {
  Spectrum product = spectrum_of_window(window);
  const Spectrum other = spectrum_of_window(reference);
  for (std::size_t i = 0; i < product.size(); ++i) product[i] *= std::conj(other[i]);
  std::vector<double> correlation(window.size());
  spectra::inverse_fft(product, correlation);
  return static_cast<std::size_t>(std::ranges::max_element(correlation) - correlation.begin());
}

double root_sum_square(Window window) {
  const auto length = static_cast<Eigen::Index>(window.size());
  return Eigen::Map<const Eigen::VectorXf>(window.data(), length).cast<double>().norm();
}

/// Returns a fault class with less than two known windows; null if there is none.
const signal::ClassInfo* lone_class(const signal::WindowSet& known) {
  for (const Label label : known.info.fault_labels()) {
    if (known.count_of(label) < 2) return &known.info.class_of(label);
  }
  return nullptr;
}

}  // namespace

std::vector<float> aligned_to(Window reference, Window window) {
  std::vector<float> aligned(window.begin(), window.end());
  const std::size_t lag = lag_behind(reference, window);
  std::rotate(aligned.begin(), aligned.begin() + static_cast<std::ptrdiff_t>(lag), aligned.end());
  const double gain = root_sum_square(reference) / root_sum_square(window);
  for (float& sample : aligned) sample = static_cast<float>(gain * static_cast<double>(sample));
  return aligned;
}

cli::StoredOptions Mixup::table() {
  cli::StoredOptions table;
  table.in("/mixup");
  table.add("alpha", options_.alpha, alpha_range,
            "both shapes of the Beta distribution of the first window's weight");
  return table;
}

void Mixup::bind(const cli::Options& command) { table().bind(command); }

void Mixup::train(const signal::WindowSet& known, const Stream& /*stream*/,
                  const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                  artefact::Writer& model) {
  if (const signal::ClassInfo* const lone = lone_class(known)) {
    throw Error(Exit::bad_input, "class " + lone->name +
                                     " has 1 known window, but mixup needs 2; split with "
                                     "--known-per-class 2 or more");
  }
  signal::write(model, known);
  table().write(model);
}

signal::WindowSet Mixup::generate(const artefact::Reader& model, std::size_t count,
                                  const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet known = read_learned(model, signal::Role::known);
  if (const signal::ClassInfo* const lone = lone_class(known)) {
    model.refuse("/labels", "has 1 window of class " + lone->name + ", but mixup needs 2");
  }
  table().read(model);
  const auto make = [&](Label label, std::size_t index, Stream& random) {
    const std::vector<std::size_t> own = known.indices_of(label);
    const std::size_t turn = index % own.size();
    const std::size_t other = random.below(own.size() - 1);
    const std::size_t first = own[turn];
    const std::size_t second = own[other < turn ? other : other + 1];
    const double weight = random.beta(options_.alpha, options_.alpha);
    const Window base = known.window(first);
    const Window partner = known.window(second);
    signal::MadeWindow made = partner_ == Partner::aligned
                                  ? interpolate(base, aligned_to(base, partner), 1 - weight)
                                  : interpolate(base, partner, 1 - weight);
    made.parents =
        weight < 0.5 ? signal::parents_of({second, first}) : signal::parents_of({first, second});
    return made;
  };
  return signal::make_windows(known.info, known.length, count, stream, make);
}

}  // namespace piae::augment
