#include "solvers/lattice/periodic_preconditioner.hpp"

#include <algorithm>
#include <numbers>

#include <omp.h>

namespace breccia::quasistatic {
namespace {

fftw_complex* as_complex(double* values) noexcept {
  return reinterpret_cast<fftw_complex*>(values);
}
fftw_complex* as_complex(std::complex<double>* values) noexcept {
  return reinterpret_cast<fftw_complex*>(values);
}

}  // namespace

PeriodicPreconditioner::PeriodicPreconditioner(const NodeLattice& lattice, int threads)
    : lattice_(lattice), exchange_(lattice), threads_(threads), waves_(lattice.arrays.row / 2) {
  const auto& nodes = lattice_.nodes;
  for (std::size_t axis = 0; axis < angles_.size(); ++axis) {
    angles_[axis] = half_angles(nodes[axis], 2.0 * std::numbers::pi / nodes[axis]);
  }
  NodalField field(lattice_);
  double* real = field.component(0);
  std::vector<Complex> depth(waves_ * static_cast<std::size_t>(nodes[2]));
  const int width = static_cast<int>(lattice_.arrays.row), waves = static_cast<int>(waves_);
  const int apart = static_cast<int>(exchange_.plane() / 2);
  along_first_ = made_plan(fftw_plan_many_dft_r2c(1, &nodes[0], nodes[1], real, nullptr, 1, width, as_complex(real),
                                                  nullptr, 1, waves, plan_flags));
  back_along_first_ = made_plan(fftw_plan_many_dft_c2r(1, &nodes[0], nodes[1], as_complex(real), nullptr, 1, waves,
                                                       real, nullptr, 1, width, plan_flags));
  const auto complex_plan = [&](const int& count, fftw_complex* in, int in_apart, fftw_complex* out, int out_apart,
                                int sign) {
    return made_plan(
        fftw_plan_many_dft(1, &count, waves, in, nullptr, in_apart, 1, out, nullptr, out_apart, 1, sign, plan_flags));
  };
  auto* in_place = as_complex(real);
  auto* compact = as_complex(depth.data());
  along_second_ = complex_plan(nodes[1], in_place, waves, in_place, waves, FFTW_FORWARD);
  back_along_second_ = complex_plan(nodes[1], in_place, waves, in_place, waves, FFTW_BACKWARD);
  along_third_ = complex_plan(nodes[2], in_place, apart, compact, waves, FFTW_FORWARD);
  back_along_third_ = complex_plan(nodes[2], compact, waves, in_place, apart, FFTW_BACKWARD);
  for (int thread = 0; thread < threads; ++thread) rows_of_waves_.push_back(allocate_waves(3 * depth.size()));
}

void PeriodicPreconditioner::apply(const Moduli& reference, const NodalField& forces, NodalField& displacement) {
  transform_planes(forces, displacement);
  exchange_.give_planes_for_rows(displacement);
  divide_by_symbol(reference, displacement);
  exchange_.give_rows_for_planes(displacement);
  transform_planes_back(displacement);
}

void PeriodicPreconditioner::transform_planes(const NodalField& forces, NodalField& waves) const {
  for_planes(lattice_, threads_, [&](std::size_t first) {
    double* values = waves.all().data() + first;
    std::copy_n(forces.all().data() + first, lattice_.arrays.plane, values);
    fftw_execute_dft_r2c(along_first_.get(), values, as_complex(values));
    fftw_execute_dft(along_second_.get(), as_complex(values), as_complex(values));
  });
}

void PeriodicPreconditioner::divide_by_symbol(const Moduli& reference, NodalField& waves) {
  const auto size = waves_ * static_cast<std::size_t>(lattice_.nodes[2]);
#pragma omp parallel num_threads(threads_)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    auto* depth = reinterpret_cast<Complex*>(rows_of_waves_[thread].get());
#pragma omp for
    for (int row = 0; row < exchange_.rows(); ++row) {
      for (std::size_t component = 0; component < 3; ++component) {
        fftw_execute_dft(along_third_.get(), as_complex(exchange_.row(waves, component, row)),
                         as_complex(depth + component * size));
      }
      divide_row(reference, exchange_.first_row() + row, depth);
      for (std::size_t component = 0; component < 3; ++component) {
        fftw_execute_dft(back_along_third_.get(), as_complex(depth + component * size),
                         as_complex(exchange_.row(waves, component, row)));
      }
    }
  }
}

/// Divides the waves of one row along the second axis by the symbol.
void PeriodicPreconditioner::divide_row(const Moduli& reference, int second, Complex* waves) const {
  const auto& nodes = lattice_.nodes;
  const auto size = waves_ * static_cast<std::size_t>(nodes[2]);
  const double ratio = reference.bulk / reference.shear;
  const double scale = 1.0 / (reference.shear * nodes[0] * nodes[1] * nodes[2]);
  const auto& y = angles_[1][static_cast<std::size_t>(second)];
  Complex *u = waves, *v = waves + size, *w = v + size;
  for (std::size_t third = 0; third < angles_[2].size(); ++third) {
    for (std::size_t first = 0; first < waves_; ++first) {
      const auto index = third * waves_ + first;
      if (second == 0 && index == 0) {
        u[0] = v[0] = w[0] = 0.0;
        continue;
      }
      const WaveSymbol symbol(angles_[0][first], y, angles_[2][third]);
      const auto moved = symbol.displacement<Complex>({scale * u[index], scale * v[index], scale * w[index]}, ratio);
      u[index] = moved[0];
      v[index] = moved[1];
      w[index] = moved[2];
    }
  }
}

void PeriodicPreconditioner::transform_planes_back(NodalField& waves) const {
  const auto row = lattice_.arrays.row;
  for_planes(lattice_, threads_, [&](std::size_t first) {
    double* values = waves.all().data() + first;
    fftw_execute_dft(back_along_second_.get(), as_complex(values), as_complex(values));
    fftw_execute_dft_c2r(back_along_first_.get(), as_complex(values), values);
    for (int second = 0; second < lattice_.nodes[1]; ++second) {
      double* of_row = values + static_cast<std::size_t>(second) * row;
      std::fill(of_row + lattice_.nodes[0], of_row + row, 0.0);
    }
  });
}

}  // namespace breccia::quasistatic
