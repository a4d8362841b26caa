#pragma once

#include <complex>
#include <memory>
#include <vector>

namespace piae::scoring {

/// Discrete Fourier transforms of any length, in double precision, by Eigen (kissfft), whose
/// headers take seconds to compile, so that one file alone includes them. What is known of a length
/// is kept for the next transform. Inverse transforms divide by the length.
class Fourier {
 public:
  Fourier();
  ~Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;

  /// All bins of a signal, also those of negative frequencies.
  void forward(std::vector<std::complex<double>>& bins, const std::vector<double>& samples);
  void forward(std::vector<std::complex<double>>& bins,
               const std::vector<std::complex<double>>& samples);
  void inverse(std::vector<double>& samples, const std::vector<std::complex<double>>& bins);
  void inverse(std::vector<std::complex<double>>& samples,
               const std::vector<std::complex<double>>& bins);

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace piae::scoring
