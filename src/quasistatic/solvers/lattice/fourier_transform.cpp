#include "quasistatic/solvers/lattice/fourier_transform.hpp"

#include <cstdlib>
#include <new>

#ifdef BRECCIA_HAS_FFTW
#include "quasistatic/solvers/lattice/fftw_transform.hpp"
#else
#include "quasistatic/solvers/lattice/eigen_transform.hpp"
#endif

namespace breccia::quasistatic {

void FreeWaves::operator()(std::complex<double>* waves) const noexcept {
  std::free(waves);
}

Waves allocate_waves(std::size_t count) {
  constexpr std::size_t alignment = 64;
  const std::size_t bytes = count * sizeof(std::complex<double>);
  Waves waves(static_cast<std::complex<double>*>(std::aligned_alloc(alignment, (bytes / alignment + 1) * alignment)));
  if (waves == nullptr) throw std::bad_alloc();
  return waves;
}

#ifdef BRECCIA_HAS_FFTW
std::unique_ptr<WaveTransform> wave_transform(WaveDirection direction, const WaveRows& rows) {
  return wave_transform_of_fftw(direction, rows);
}

std::unique_ptr<RealTransform> real_transform(const RealRows& rows) {
  return real_transform_of_fftw(rows);
}
#else
std::unique_ptr<WaveTransform> wave_transform(WaveDirection direction, const WaveRows& rows) {
  return wave_transform_of_eigen(direction, rows);
}

std::unique_ptr<RealTransform> real_transform(const RealRows& rows) {
  return real_transform_of_eigen(rows);
}
#endif

}  // namespace breccia::quasistatic
