#include "scoring/planned_fft.hpp"

namespace piae::scoring {

Eigen::FFT<double>& planned_fft() {
  using Fft = Eigen::FFT<double>;
  thread_local Fft fft(Fft::impl_type(), Fft::HalfSpectrum);
  return fft;
}

}  // namespace piae::scoring
