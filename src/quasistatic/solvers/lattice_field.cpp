#include "solvers/lattice_field.hpp"

#include <algorithm>
#include <new>
#include <numeric>

#include <fftw3.h>

namespace breccia::quasistatic {
namespace {

/// Places of a part of a field, which one thread takes at a time.
constexpr std::size_t places_of_part = 16384;

}  // namespace

NodeLattice::NodeLattice(const Index<3>& cells_along, Boundary boundary_of_box)
    : boundary(boundary_of_box), cells(cells_along) {
  const int more = is_periodic() ? 0 : 1;
  for (std::size_t axis = 0; axis < cells.size(); ++axis) arrays.nodes[axis] = cells[axis] + more;
  arrays.row = 2 * static_cast<std::size_t>(cells[0] / 2 + 1);
  arrays.plane = arrays.row * static_cast<std::size_t>(arrays.nodes[1]);
}

void LatticeField::Free::operator()(double* values) const noexcept {
  fftw_free(values);
}

LatticeField::LatticeField(const NodeLattice& lattice)
    : places_(lattice.places()), values_(fftw_alloc_real(3 * places_)) {
  if (values_ == nullptr) throw std::bad_alloc();
  std::ranges::fill(all(), 0.0);
}

LatticeSums::LatticeSums(std::size_t places, int threads)
    : places_(places), threads_(threads), sums_((places + places_of_part - 1) / places_of_part) {}

/// Calls work(part, first place, place behind the last one) for all parts.
template <class Work>
void LatticeSums::for_parts(const Work& work) const {
#pragma omp parallel for num_threads(threads_)
  for (std::size_t part = 0; part < sums_.size(); ++part) {
    const auto first = part * places_of_part;
    work(part, first, std::min(first + places_of_part, places_));
  }
}

double LatticeSums::product(const LatticeField& a, const LatticeField& b) {
  const double *x = a.all().data(), *y = b.all().data();
  for_parts([&](std::size_t part, std::size_t first, std::size_t end) {
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (auto place = first; place < end; ++place) sum += x[place] * y[place];
    sums_[part] = sum;
  });
  return std::accumulate(sums_.begin(), sums_.end(), 0.0);
}

void LatticeSums::combine(double factor, LatticeField& a, const LatticeField& b) const {
  double* x = a.all().data();
  const double* y = b.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) {
#pragma omp simd
    for (auto place = first; place < end; ++place) x[place] = factor * x[place] + y[place];
  });
}

void LatticeSums::add(LatticeField& a, double factor, const LatticeField& b) const {
  double* x = a.all().data();
  const double* y = b.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) {
#pragma omp simd
    for (auto place = first; place < end; ++place) x[place] += factor * y[place];
  });
}

void LatticeSums::set_zero(LatticeField& a) const {
  double* x = a.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) { std::fill(x + first, x + end, 0.0); });
}

}  // namespace breccia::quasistatic
