#include "scoring/fourier.hpp"

#include <unsupported/Eigen/FFT>

namespace piae::scoring {

struct Fourier::Plans {
  Eigen::FFT<double> fft;
};

Fourier::Fourier() : plans_(std::make_unique<Plans>()) {}
Fourier::~Fourier() = default;

void Fourier::forward(std::vector<std::complex<double>>& bins, const std::vector<double>& samples) {
  plans_->fft.fwd(bins, samples);
}

void Fourier::forward(std::vector<std::complex<double>>& bins,
                      const std::vector<std::complex<double>>& samples) {
  plans_->fft.fwd(bins, samples);
}

void Fourier::inverse(std::vector<double>& samples, const std::vector<std::complex<double>>& bins) {
  plans_->fft.inv(samples, bins);
}

void Fourier::inverse(std::vector<std::complex<double>>& samples,
                      const std::vector<std::complex<double>>& bins) {
  plans_->fft.inv(samples, bins);
}

}  // namespace piae::scoring
