#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/microstructure/index.hpp"

#include "discretisation/gaps/gap_cells.hpp"
#include "quasistatic/operator/petsc_handle.hpp"
#include "quasistatic/operator/shared_values.hpp"

namespace breccia::quasistatic {

/// The unknowns of gaps (GapCell), distributed over the processes. An unknown belongs to the process of its node. In a
/// nodal vector the unknowns of a process follow the values of its nodes.
class GapLayout {
 public:
  /// A grid without gaps.
  GapLayout() = default;
  /// `own_nodes` are the nodes of this process, `own_cells` the cells that it works on.
  template <int dim>
  GapLayout(const gaps::GapCells<dim>& cells, const IndexRange<dim>& own_nodes, const IndexRange<dim>& own_cells);

  /// Number of the unknowns of this process.
  [[nodiscard]] std::size_t own() const noexcept { return own_; }
  /// Number of the unknowns of this process and of those of other processes in its cells.
  [[nodiscard]] std::size_t seen() const noexcept { return numbers_.size(); }
  /// Index among the unknowns that this process sees, its own first, of one with a number of GapCell::gap_unknowns.
  [[nodiscard]] std::size_t index_of(std::int32_t number) const noexcept {
    return static_cast<std::size_t>(index_of_[static_cast<std::size_t>(number)]);
  }
  /// The numbers of the unknowns that this process sees.
  [[nodiscard]] std::span<const std::int32_t> numbers() const noexcept { return numbers_; }

  /// The values of all unknowns seen, from a nodal vector.
  [[nodiscard]] std::vector<double> values(Vec nodal) const;
  /// Sets the values in a nodal vector; on every process those of its own unknowns are right.
  void set(std::span<const double> values, Vec nodal) const;
  /// Adds the contributions of all processes to a nodal vector.
  void add(std::vector<double> contributions, Vec nodal) const;
  /// Sets the values of other processes, behind those of this one.
  void copy_from_owners(std::span<int> values) const { shared_.copy_from_owners(values); }
  void copy_from_owners(std::span<double> values) const { shared_.copy_from_owners(values); }
  /// Adds the values behind those of this process to those of their owners, and sets them to zero.
  void add_to_owners(std::span<double> values) const;

 private:
  [[nodiscard]] std::size_t first_in(Vec nodal) const;

  std::size_t own_ = 0;
  std::vector<std::int32_t> numbers_, index_of_;
  SharedValues shared_;
};

}  // namespace breccia::quasistatic
