#include "quasistatic/solvers/lattice/nodal_field.hpp"

#include <algorithm>
#include <numeric>

#include "breccia/error.hpp"

#include "parallel/reduction.hpp"

namespace breccia::quasistatic {
namespace {

/// Number of entries of a part of a field, which one thread takes at a time.
constexpr std::size_t entries_of_part = 16384;

}  // namespace

NodeLattice::NodeLattice(const NodeLayout<3>& layout)
    : boundary(layout.boundary()),
      cells(layout.grid().cells),
      nodes(is_periodic() ? cells : layout.grid().nodes()),
      first_plane(layout.own_nodes().begin[2]),
      planes(layout.own_nodes().end[2] - first_plane) {
  const auto& [begin, end] = layout.own_nodes();
  if (begin[0] != 0 || begin[1] != 0 || end[0] != nodes[0] || end[1] != nodes[1]) {
    throw InputError(
        "quasi-static solver: expected whole planes of nodes on each process, of which there must be as many");
  }
  const bool is_last = first_plane + planes == nodes[2], is_alone = planes == nodes[2];
  const bool is_plane_above = !is_alone && (!is_last || is_periodic());
  arrays.nodes = {nodes[0], nodes[1], planes + (is_plane_above ? 1 : 0)};
  arrays.row = 2 * static_cast<std::size_t>(cells[0] / 2 + 1);
  arrays.plane = arrays.row * static_cast<std::size_t>(arrays.nodes[1]);
}

Index<3> NodeLattice::own_cells() const noexcept {
  return {cells[0], cells[1], std::min(planes, cells[2] - first_plane)};
}

NodalField::NodalField(const NodeLattice& lattice, std::size_t further)
    : size_(lattice.size()), further_(further), values_(allocate_waves((3 * size_ + further + 1) / 2)) {
  std::ranges::fill(all(), 0.0);
}

void for_planes(const NodeLattice& lattice, int threads, const std::function<void(std::size_t)>& work) {
#pragma omp parallel for num_threads(threads) collapse(2)
  for (std::size_t component = 0; component < 3; ++component) {
    for (int plane = 0; plane < lattice.planes; ++plane) {
      work(component * lattice.size() + static_cast<std::size_t>(plane) * lattice.arrays.plane);
    }
  }
}

LatticeSums::LatticeSums(std::size_t size, int threads)
    : size_(size), threads_(threads), sums_((size + entries_of_part - 1) / entries_of_part) {}

/// Calls work(part, first index, last index + 1) for all parts.
template <class Work>
void LatticeSums::for_parts(const Work& work) const {
#pragma omp parallel for num_threads(threads_)
  for (std::size_t part = 0; part < sums_.size(); ++part) {
    const auto first = part * entries_of_part;
    work(part, first, std::min(first + entries_of_part, size_));
  }
}

double LatticeSums::product(const NodalField& a, const NodalField& b) {
  const double *x = a.all().data(), *y = b.all().data();
  for_parts([&](std::size_t part, std::size_t first, std::size_t end) {
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (auto index = first; index < end; ++index) sum += x[index] * y[index];
    sums_[part] = sum;
  });
  return parallel::sum(std::accumulate(sums_.begin(), sums_.end(), 0.0));
}

void LatticeSums::combine(double factor, NodalField& a, const NodalField& b) const {
  double* x = a.all().data();
  const double* y = b.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) {
#pragma omp simd
    for (auto index = first; index < end; ++index) x[index] = factor * x[index] + y[index];
  });
}

void LatticeSums::add(NodalField& a, double factor, const NodalField& b) const {
  double* x = a.all().data();
  const double* y = b.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) {
#pragma omp simd
    for (auto index = first; index < end; ++index) x[index] += factor * y[index];
  });
}

void LatticeSums::scale(NodalField& a, double factor) const {
  double* x = a.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) {
#pragma omp simd
    for (auto index = first; index < end; ++index) x[index] *= factor;
  });
}

void LatticeSums::set_zero(NodalField& a) const {
  double* x = a.all().data();
  for_parts([&](std::size_t, std::size_t first, std::size_t end) { std::fill(x + first, x + end, 0.0); });
}

}  // namespace breccia::quasistatic
