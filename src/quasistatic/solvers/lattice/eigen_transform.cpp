#include "quasistatic/solvers/lattice/eigen_transform.hpp"

#include <algorithm>
#include <vector>

#include <unsupported/Eigen/FFT>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

using Complex = std::complex<double>;

/// The workspace of a thread: the tables that Eigen keeps for each length, and a row with its values one after the
/// other.
struct Workspace {
  Eigen::FFT<double> fft{
      Eigen::default_fft_impl<double>(),
      static_cast<Eigen::FFT<double>::Flag>(Eigen::FFT<double>::Unscaled | Eigen::FFT<double>::HalfSpectrum)};
  std::vector<Complex> values, waves;
  std::vector<double> reals;
};

Workspace& workspace() {
  thread_local Workspace of_this_thread;
  return of_this_thread;
}

/// Eigen transforms no row of a single value, which is its own wave.
void transform(Workspace& of_thread, WaveDirection direction, int length) {
  if (length == 1) {
    of_thread.waves.front() = of_thread.values.front();
  } else if (direction == WaveDirection::forward) {
    of_thread.fft.fwd(of_thread.waves.data(), of_thread.values.data(), length);
  } else {
    of_thread.fft.inv(of_thread.waves.data(), of_thread.values.data(), length);
  }
}

void require_rows(int length, int rows) {
  if (length < 1 || rows < 1) {
    throw NumericalError("quasi-static solver: nothing to transform; the box has no nodes between its walls");
  }
}

class EigenWaves final : public WaveTransform {
 public:
  EigenWaves(WaveDirection direction, const WaveRows& rows) : direction_(direction), rows_(rows) {
    require_rows(rows.length, rows.rows);
  }
  void apply(Complex* values, Complex* waves) const override {
    auto& of_thread = workspace();
    const auto length = static_cast<std::size_t>(rows_.length);
    const auto apart = static_cast<std::size_t>(rows_.apart), apart_after = static_cast<std::size_t>(rows_.apart_after);
    of_thread.values.resize(length);
    of_thread.waves.resize(length);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows_.rows); ++row) {
      for (std::size_t j = 0; j < length; ++j) of_thread.values[j] = values[row + j * apart];
      transform(of_thread, direction_, rows_.length);
      for (std::size_t j = 0; j < length; ++j) waves[row + j * apart_after] = of_thread.waves[j];
    }
  }

 private:
  WaveDirection direction_;
  WaveRows rows_;
};

class EigenReal final : public RealTransform {
 public:
  explicit EigenReal(const RealRows& rows) : rows_(rows) { require_rows(rows.length, rows.rows); }
  void apply(double* values) const override {
    auto& of_thread = workspace();
    of_thread.waves.resize(static_cast<std::size_t>(half()));
    for_rows(values, [&](double* of_row, Complex* waves_of_row) {
      of_thread.reals.assign(of_row, of_row + rows_.length);
      if (rows_.length == 1) {
        of_thread.waves.front() = of_thread.reals.front();
      } else {
        of_thread.fft.fwd(of_thread.waves.data(), of_thread.reals.data(), rows_.length);
      }
      std::copy(of_thread.waves.begin(), of_thread.waves.end(), waves_of_row);
    });
  }
  void apply_back(double* values) const override {
    auto& of_thread = workspace();
    of_thread.reals.resize(static_cast<std::size_t>(rows_.length));
    for_rows(values, [&](double* of_row, const Complex* waves_of_row) {
      of_thread.waves.assign(waves_of_row, waves_of_row + half());
      if (rows_.length == 1) {
        of_thread.reals.front() = of_thread.waves.front().real();
      } else {
        of_thread.fft.inv(of_thread.reals.data(), of_thread.waves.data(), rows_.length);
      }
      std::copy(of_thread.reals.begin(), of_thread.reals.end(), of_row);
    });
  }

 private:
  [[nodiscard]] int half() const noexcept { return rows_.length / 2 + 1; }

  template <class Work>
  void for_rows(double* values, const Work& work) const {
    for (int r = 0; r < rows_.rows; ++r) {
      auto* row = values + static_cast<std::ptrdiff_t>(r) * rows_.width;
      work(row, reinterpret_cast<Complex*>(row));
    }
  }

  RealRows rows_;
};

}  // namespace

std::unique_ptr<WaveTransform> wave_transform_of_eigen(WaveDirection direction, const WaveRows& rows) {
  return std::make_unique<EigenWaves>(direction, rows);
}

std::unique_ptr<RealTransform> real_transform_of_eigen(const RealRows& rows) {
  return std::make_unique<EigenReal>(rows);
}

}  // namespace breccia::quasistatic
