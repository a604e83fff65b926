#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"

namespace breccia::quasistatic {

/// Rows of values at the nodes of an axis, two rows to a complex number.
struct PairedRows {
  double* first;         ///< first value of the first row
  std::size_t apart;     ///< distance of values of a row
  std::size_t partner;   ///< distance of the two rows of a pair
  std::size_t pairs;     ///< number of pairs
  std::size_t distance;  ///< distance of pairs
  bool is_last_alone;    ///< whether the last pair has only one row
};

/// Sine or cosine transforms of the values at the nodes of an axis between walls, defined like FFTW's kinds RODFT00 and
/// REDFT00: 2 sum_j x_j sin(pi j k / n), and x_0 + (-1)^k x_n + 2 sum_j x_j cos(pi j k / n) with j from 1 to n - 1.
/// They are their own inverses apart from a factor 2n.
///
/// Each is a Fourier transform of n complex values after and before some sums (Press, Teukolsky, Vetterling and
/// Flannery 2007, section 12.4). FFTW has no transform that is as fast, because the sums cost some digits, which a
/// preconditioner does not need.
class WallTransform {
 public:
  enum class Kind { sine, cosine };

  /// The transform of rows of `cells` cells, `pairs` pairs of rows at a time.
  WallTransform(Kind kind, int cells, std::size_t pairs);

  /// The memory that a transform needs, for one thread.
  [[nodiscard]] Waves make_waves() const { return allocate_waves(count_ * pairs_); }

  /// Transforms rows in place.
  void apply(const PairedRows& rows, std::complex<double>* waves) const;

 private:
  using Complex = std::complex<double>;

  void fold(const PairedRows& rows, Complex* waves, Complex* first_odd) const;
  void unfold(const PairedRows& rows, const Complex* waves, Complex* odd) const;

  Kind kind_;
  std::size_t cells_, pairs_, count_;
  std::vector<double> sines_, cosines_;  ///< sines and cosines of pi j / n
  std::unique_ptr<WaveTransform> transform_;
};

}  // namespace breccia::quasistatic
