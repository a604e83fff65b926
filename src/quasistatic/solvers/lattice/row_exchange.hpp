#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <mpi.h>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// Parts of an array of four axes, one for each process, as MPI sends and receives them in their place.
class ArrayParts {
 public:
  using Axes = std::array<int, 4>;

  ArrayParts() = default;
  ArrayParts(const ArrayParts&) = delete;
  ArrayParts& operator=(const ArrayParts&) = delete;
  ArrayParts(ArrayParts&&) = delete;
  ArrayParts& operator=(ArrayParts&&) = delete;
  ~ArrayParts();

  /// Adds the part of the next process: its size along each axis, the last of which is contiguous, and the index of its
  /// first value. It may be empty.
  void add(const Axes& array, const Axes& part, const Axes& first);

  [[nodiscard]] const int* counts() const noexcept { return counts_.data(); }
  [[nodiscard]] const int* displacements() const noexcept { return displacements_.data(); }
  [[nodiscard]] const MPI_Datatype* types() const noexcept { return types_.data(); }

 private:
  std::vector<int> counts_;         ///< 1, or 0 of an empty part
  std::vector<int> displacements_;  ///< all zero: the offsets are in the types
  std::vector<MPI_Datatype> types_;
};

/// The fields of a lattice row by row, as transforms along the third axis take them. A process has the values of all
/// components on its planes; in exchange it gets those on all planes, in some of the rows that lie beside each other
/// along the second axis. A process that has all planes keeps its values in their place. All processes of the group
/// call the exchanges together.
class RowExchange {
 public:
  explicit RowExchange(const NodeLattice& lattice);

  /// The rows of this process: the index of the first one along the second axis, and their number.
  [[nodiscard]] int first_row() const noexcept { return first_row_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }
  /// Distance of values that are neighbours along the third axis.
  [[nodiscard]] std::size_t plane() const noexcept { return plane_; }

  /// Makes the rows of a field.
  void give_planes_for_rows(NodalField& field);
  /// Makes the field again from its rows.
  void give_rows_for_planes(NodalField& field);
  /// The values of a component in a row, on the first plane; `row` counts from the first one of this process.
  [[nodiscard]] double* row(NodalField& field, std::size_t component, int row) noexcept;

 private:
  void make_parts(const NodeLattice& lattice);
  /// The rows on all planes, where processes exchange them.
  [[nodiscard]] double* values() noexcept { return reinterpret_cast<double*>(values_.get()); }

  bool is_alone_;  ///< does this process have all planes?
  int first_row_, rows_;
  std::size_t distance_;  ///< of rows that are neighbours along the second axis
  std::size_t plane_;
  std::size_t component_;  ///< distance of components
  Waves values_;           ///< of the rows on all planes, by component; null on one process
  ArrayParts of_planes_;   ///< of a field
  ArrayParts of_rows_;     ///< of `values_`
};

}  // namespace breccia::quasistatic
