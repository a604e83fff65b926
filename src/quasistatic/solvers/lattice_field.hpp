#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/discretisation/grid.hpp"

#include "operator/cell_sweep.hpp"

namespace breccia::quasistatic {

/// The nodes of a box of cubic cells on one process, in arrays that transforms take: rows have an even number of
/// places, and in a periodic box one more than nodes at least, for the first node that comes again behind the last one.
struct NodeLattice {
  NodeLattice(const Index<3>& cells_along, Boundary boundary_of_box);

  /// Number of places of one component.
  [[nodiscard]] std::size_t places() const noexcept { return arrays.plane * static_cast<std::size_t>(arrays.nodes[2]); }
  [[nodiscard]] bool is_periodic() const noexcept { return boundary == Boundary::periodic; }

  Boundary boundary;
  Index<3> cells;
  NodeArrays arrays;
};

/// Displacements or forces of the nodes of a lattice, component by component. Places of no node are zero unless said
/// otherwise.
class LatticeField {
 public:
  explicit LatticeField(const NodeLattice& lattice);

  [[nodiscard]] double* component(std::size_t component) noexcept { return values_.get() + component * places_; }
  [[nodiscard]] const double* component(std::size_t component) const noexcept {
    return values_.get() + component * places_;
  }
  [[nodiscard]] std::array<double*, 3> components() noexcept { return {component(0), component(1), component(2)}; }
  [[nodiscard]] std::array<const double*, 3> components() const noexcept {
    return {component(0), component(1), component(2)};
  }
  /// All places of all components.
  [[nodiscard]] std::span<double> all() noexcept { return {values_.get(), 3 * places_}; }
  [[nodiscard]] std::span<const double> all() const noexcept { return {values_.get(), 3 * places_}; }

 private:
  struct Free {
    void operator()(double* values) const noexcept;
  };

  std::size_t places_;
  std::unique_ptr<double, Free> values_;  ///< aligned for the transforms
};

/// Sums over the places of lattice fields, and the sums of fields, by several threads: the fields are divided into
/// parts of a size that does not depend on the threads, so that the results have the same bits for any number of them.
class LatticeSums {
 public:
  LatticeSums(std::size_t places, int threads);

  /// The scalar product.
  [[nodiscard]] double product(const LatticeField& a, const LatticeField& b);
  /// a = factor * a + b
  void combine(double factor, LatticeField& a, const LatticeField& b) const;
  /// a += factor * b
  void add(LatticeField& a, double factor, const LatticeField& b) const;
  void set_zero(LatticeField& a) const;

 private:
  template <class Work>
  void for_parts(const Work& work) const;

  std::size_t places_;
  int threads_;
  std::vector<double> sums_;  ///< by part
};

}  // namespace breccia::quasistatic
