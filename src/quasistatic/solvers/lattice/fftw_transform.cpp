#include "quasistatic/solvers/lattice/fftw_transform.hpp"

#include <algorithm>
#include <type_traits>

#include <fftw3.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

using Complex = std::complex<double>;

struct DestroyPlan {
  void operator()(fftw_plan plan) const noexcept { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

Plan made_plan(fftw_plan plan) {
  if (plan == nullptr) {
    throw NumericalError(
        "quasi-static solver: FFTW has no plan for the transforms of this box; the memory may be short, or the box has "
        "no nodes between its walls");
  }
  return Plan(plan);
}

fftw_complex* as_fftw(Complex* values) noexcept {
  return reinterpret_cast<fftw_complex*>(values);
}

/// Memory for plans for so many values; an estimate does not access the values.
Waves memory_of(int length, int apart, int rows) {
  const auto extent = static_cast<std::size_t>(std::max(length, 1)) * static_cast<std::size_t>(apart);
  return allocate_waves(extent + static_cast<std::size_t>(rows));
}

class FftwWaves final : public WaveTransform {
 public:
  FftwWaves(WaveDirection direction, const WaveRows& rows) {
    const auto before = memory_of(rows.length, rows.apart, rows.rows);
    const auto after = memory_of(rows.length, rows.apart_after, rows.rows);
    const auto to = rows.is_in_place ? before.get() : after.get();
    const int sign = direction == WaveDirection::forward ? FFTW_FORWARD : FFTW_BACKWARD;
    plan_ = made_plan(fftw_plan_many_dft(1, &rows.length, rows.rows, as_fftw(before.get()), nullptr, rows.apart, 1,
                                         as_fftw(to), nullptr, rows.apart_after, 1, sign, FFTW_ESTIMATE));
  }
  void apply(Complex* values, Complex* waves) const override {
    fftw_execute_dft(plan_.get(), as_fftw(values), as_fftw(waves));
  }

 private:
  Plan plan_;
};

class FftwReal final : public RealTransform {
 public:
  explicit FftwReal(const RealRows& rows) {
    const auto memory = memory_of(rows.rows, rows.width, rows.rows);
    auto* waves = as_fftw(memory.get());
    auto* values = reinterpret_cast<double*>(memory.get());
    const int width = rows.width, waves_apart = rows.width / 2;
    forward_ = made_plan(fftw_plan_many_dft_r2c(1, &rows.length, rows.rows, values, nullptr, 1, width, waves, nullptr,
                                                1, waves_apart, FFTW_ESTIMATE));
    backward_ = made_plan(fftw_plan_many_dft_c2r(1, &rows.length, rows.rows, waves, nullptr, 1, waves_apart, values,
                                                 nullptr, 1, width, FFTW_ESTIMATE));
  }
  void apply(double* values) const override {
    fftw_execute_dft_r2c(forward_.get(), values, reinterpret_cast<fftw_complex*>(values));
  }
  void apply_back(double* values) const override {
    fftw_execute_dft_c2r(backward_.get(), reinterpret_cast<fftw_complex*>(values), values);
  }

 private:
  Plan forward_, backward_;
};

}  // namespace

std::unique_ptr<WaveTransform> wave_transform_of_fftw(WaveDirection direction, const WaveRows& rows) {
  return std::make_unique<FftwWaves>(direction, rows);
}

std::unique_ptr<RealTransform> real_transform_of_fftw(const RealRows& rows) {
  return std::make_unique<FftwReal>(rows);
}

}  // namespace breccia::quasistatic
