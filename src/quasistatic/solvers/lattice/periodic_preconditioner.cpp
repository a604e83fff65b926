#include "quasistatic/solvers/lattice/periodic_preconditioner.hpp"

#include <algorithm>
#include <numbers>

#include <omp.h>

namespace breccia::quasistatic {
namespace {

std::complex<double>* as_complex(double* values) noexcept {
  return reinterpret_cast<std::complex<double>*>(values);
}

}  // namespace

PeriodicPreconditioner::PeriodicPreconditioner(const NodeLattice& lattice, int threads)
    : lattice_(lattice), exchange_(lattice), threads_(threads), waves_(lattice.arrays.row / 2) {
  const auto& nodes = lattice_.nodes;
  for (std::size_t axis = 0; axis < angles_.size(); ++axis) {
    angles_[axis] = half_angles(nodes[axis], 2.0 * std::numbers::pi / nodes[axis]);
  }
  const int waves = static_cast<int>(waves_), apart = static_cast<int>(exchange_.plane() / 2);
  along_first_ = real_transform({.length = nodes[0], .rows = nodes[1], .width = static_cast<int>(lattice_.arrays.row)});
  const auto along = [&](WaveDirection direction, std::size_t axis, int before, int after) {
    return wave_transform(
        direction,
        {.length = nodes[axis], .rows = waves, .apart = before, .apart_after = after, .is_in_place = axis == 1});
  };
  along_second_ = along(WaveDirection::forward, 1, waves, waves);
  back_along_second_ = along(WaveDirection::backward, 1, waves, waves);
  // The waves of a row across the planes are kept close together.
  along_third_ = along(WaveDirection::forward, 2, apart, waves);
  back_along_third_ = along(WaveDirection::backward, 2, waves, apart);
  const auto depth = waves_ * static_cast<std::size_t>(nodes[2]);
  for (int thread = 0; thread < threads; ++thread) rows_of_waves_.push_back(allocate_waves(3 * depth));
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
    along_first_->apply(values);
    along_second_->apply(as_complex(values), as_complex(values));
  });
}

void PeriodicPreconditioner::divide_by_symbol(const Moduli& reference, NodalField& waves) {
  const auto size = waves_ * static_cast<std::size_t>(lattice_.nodes[2]);
#pragma omp parallel num_threads(threads_)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    auto* depth = rows_of_waves_[thread].get();
#pragma omp for
    for (int row = 0; row < exchange_.rows(); ++row) {
      for (std::size_t component = 0; component < 3; ++component) {
        along_third_->apply(as_complex(exchange_.row(waves, component, row)), depth + component * size);
      }
      divide_row(reference, exchange_.first_row() + row, depth);
      for (std::size_t component = 0; component < 3; ++component) {
        back_along_third_->apply(depth + component * size, as_complex(exchange_.row(waves, component, row)));
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
    back_along_second_->apply(as_complex(values), as_complex(values));
    along_first_->apply_back(values);
    for (int second = 0; second < lattice_.nodes[1]; ++second) {
      double* of_row = values + static_cast<std::size_t>(second) * row;
      std::fill(of_row + lattice_.nodes[0], of_row + row, 0.0);
    }
  });
}

}  // namespace breccia::quasistatic
