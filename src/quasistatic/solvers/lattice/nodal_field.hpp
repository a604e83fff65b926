#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "breccia/discretisation/boundary.hpp"

#include "quasistatic/operator/cell_sweep.hpp"
#include "quasistatic/operator/node_layout.hpp"
#include "quasistatic/solvers/lattice/fourier_transform.hpp"

namespace breccia::quasistatic {

/// The nodes of a box of cubic cells, in arrays for the transforms: rows have an even number of entries. In a periodic
/// box they have at least one entry more than nodes, for the first node, which is repeated behind the last one. Several
/// processes have slabs of whole planes (PlaneDivision), and each has the first plane of the process above as well.
struct NodeLattice {
  explicit NodeLattice(const NodeLayout<3>& nodes);

  /// Number of entries of one component.
  [[nodiscard]] std::size_t size() const noexcept { return arrays.plane * static_cast<std::size_t>(arrays.nodes[2]); }
  [[nodiscard]] bool is_periodic() const noexcept { return boundary == Boundary::periodic; }
  /// Whether there is a plane of the process above, behind those of this process.
  [[nodiscard]] bool has_plane_above() const noexcept { return arrays.nodes[2] > planes; }
  /// Index of a node of this process among the entries of a component; its third index counts from the first plane of
  /// the process.
  [[nodiscard]] std::size_t index_of(const Index<3>& node) const noexcept {
    return static_cast<std::size_t>(node[0]) + static_cast<std::size_t>(node[1]) * arrays.row +
           static_cast<std::size_t>(node[2]) * arrays.plane;
  }
  /// Number of cells of this process along each axis.
  [[nodiscard]] Index<3> own_cells() const noexcept;

  Boundary boundary;
  Index<3> cells;   ///< number of cells of the box along each axis
  Index<3> nodes;   ///< number of nodes of the box along each axis; in a periodic box without the last ones
  int first_plane;  ///< first plane of this process among those of the box
  int planes;       ///< number of planes of this process
  NodeArrays arrays;
};

/// Displacements or forces of the nodes of a lattice, component by component, and further values behind them. Entries
/// that do not belong to a node of this process are zero unless stated otherwise.
class NodalField {
 public:
  explicit NodalField(const NodeLattice& lattice, std::size_t further = 0);

  [[nodiscard]] double* component(std::size_t component) noexcept { return first() + component * size_; }
  [[nodiscard]] const double* component(std::size_t component) const noexcept { return first() + component * size_; }
  [[nodiscard]] std::array<double*, 3> components() noexcept { return {component(0), component(1), component(2)}; }
  [[nodiscard]] std::array<const double*, 3> components() const noexcept {
    return {component(0), component(1), component(2)};
  }
  /// The entries of all components, and the further values.
  [[nodiscard]] std::span<double> all() noexcept { return {first(), 3 * size_ + further_}; }
  [[nodiscard]] std::span<const double> all() const noexcept { return {first(), 3 * size_ + further_}; }
  [[nodiscard]] std::span<double> further() noexcept { return {first() + 3 * size_, further_}; }
  [[nodiscard]] std::span<const double> further() const noexcept { return {first() + 3 * size_, further_}; }

 private:
  [[nodiscard]] double* first() const noexcept { return reinterpret_cast<double*>(values_.get()); }

  std::size_t size_, further_;
  Waves values_;  ///< values, two entries a wave; rows have an even number of entries
};

/// Calls work(first index) for all components of the planes of this process, by several threads.
void for_planes(const NodeLattice& lattice, int threads, const std::function<void(std::size_t)>& work);

/// Sums over the entries of nodal fields, and the sums of fields, by several threads: the fields are divided into parts
/// of a size that does not depend on the threads, so that the results are bitwise identical for any number of threads.
/// Every process has the sums of its own entries.
class LatticeSums {
 public:
  LatticeSums(std::size_t size, int threads);

  /// The scalar product, over all processes.
  [[nodiscard]] double product(const NodalField& a, const NodalField& b);
  /// a = factor * a + b
  void combine(double factor, NodalField& a, const NodalField& b) const;
  /// a += factor * b
  void add(NodalField& a, double factor, const NodalField& b) const;
  /// a *= factor
  void scale(NodalField& a, double factor) const;
  void set_zero(NodalField& a) const;

 private:
  template <class Work>
  void for_parts(const Work& work) const;

  std::size_t size_;
  int threads_;
  std::vector<double> sums_;  ///< sums by part
};

}  // namespace breccia::quasistatic
