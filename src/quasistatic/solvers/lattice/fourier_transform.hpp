#pragma once

#include <complex>
#include <cstddef>
#include <memory>

namespace breccia::quasistatic {

/// Memory for waves, aligned for the transforms.
struct FreeWaves {
  void operator()(std::complex<double>* waves) const noexcept;
};
using Waves = std::unique_ptr<std::complex<double>, FreeWaves>;

/// Allocates memory for so many waves. Throws std::bad_alloc.
[[nodiscard]] Waves allocate_waves(std::size_t count);

/// The sign of the exponent of a transform: minus forward, plus backward.
enum class WaveDirection { forward, backward };

/// Rows of complex values side by side: the value j of row r is r + apart * j places behind the first value.
struct WaveRows {
  int length;  ///< values of a row
  int rows;
  int apart;         ///< distance of values of a row before the transform
  int apart_after;   ///< distance of values of a row after the transform
  bool is_in_place;  ///< whether the waves replace the values; the distances must then be equal
};

/// Fourier transforms of rows of complex values, without a factor. Threads may share one transform.
class WaveTransform {
 public:
  WaveTransform() = default;
  virtual ~WaveTransform() = default;
  WaveTransform(const WaveTransform&) = delete;
  WaveTransform& operator=(const WaveTransform&) = delete;
  WaveTransform(WaveTransform&&) = delete;
  WaveTransform& operator=(WaveTransform&&) = delete;

  virtual void apply(std::complex<double>* values, std::complex<double>* waves) const = 0;
};

/// Rows of real values, one behind the other.
struct RealRows {
  int length;  ///< values of a row
  int rows;
  int width;  ///< distance of rows: an even number, larger than the length
};

/// Fourier transforms of rows of real values in place, without a factor. A row has the waves, pairs of numbers, up to
/// half its length; the other waves are their conjugates. Threads may share one transform.
class RealTransform {
 public:
  RealTransform() = default;
  virtual ~RealTransform() = default;
  RealTransform(const RealTransform&) = delete;
  RealTransform& operator=(const RealTransform&) = delete;
  RealTransform(RealTransform&&) = delete;
  RealTransform& operator=(RealTransform&&) = delete;

  virtual void apply(double* values) const = 0;       ///< forward, from values to waves
  virtual void apply_back(double* values) const = 0;  ///< backward, from waves to values
};

/// Transforms by FFTW, or by Eigen where Breccia is built without FFTW (BRECCIA_FFTW). The functions throw
/// NumericalError where memory is short, or there are no values to transform.
[[nodiscard]] std::unique_ptr<WaveTransform> wave_transform(WaveDirection direction, const WaveRows& rows);
[[nodiscard]] std::unique_ptr<RealTransform> real_transform(const RealRows& rows);

}  // namespace breccia::quasistatic
