#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <mpi.h>

#include "quasistatic/solvers/lattice/fourier_transform.hpp"
#include "quasistatic/solvers/lattice/nodal_field.hpp"

namespace breccia::quasistatic {

/// Parts of an array of four axes, one for each process, in the form in which MPI sends and receives them in place.
class ArrayParts {
 public:
  using Axes = std::array<int, 4>;

  ArrayParts() = default;
  ArrayParts(const ArrayParts&) = delete;
  ArrayParts& operator=(const ArrayParts&) = delete;
  ArrayParts(ArrayParts&&) = delete;
  ArrayParts& operator=(ArrayParts&&) = delete;
  ~ArrayParts();

  /// Adds the part of the next process, given by its size along each axis, the last of which is contiguous, and the
  /// index of its first value. The part may be empty.
  void add(const Axes& array, const Axes& part, const Axes& first);

  [[nodiscard]] const int* counts() const noexcept { return counts_.data(); }
  [[nodiscard]] const int* displacements() const noexcept { return displacements_.data(); }
  [[nodiscard]] const MPI_Datatype* types() const noexcept { return types_.data(); }

 private:
  std::vector<int> counts_;         ///< 1, or 0 for an empty part
  std::vector<int> displacements_;  ///< zeros: the offsets are in the types
  std::vector<MPI_Datatype> types_;
};

/// The fields of a lattice row by row, in the form for transforms along the third axis. A process has the values of all
/// components on its own planes; in exchange it gets the values on all planes in some neighbouring rows along the
/// second axis. A process that has all planes keeps its values in place. All processes of the group call the exchanges
/// together.
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
  /// The values of a component in a row, on the first plane; `row` counts from the first row of this process.
  [[nodiscard]] double* row(NodalField& field, std::size_t component, int row) noexcept;

 private:
  void make_parts(const NodeLattice& lattice);
  /// The rows on all planes, where processes exchange them.
  [[nodiscard]] double* values() noexcept { return reinterpret_cast<double*>(values_.get()); }

  bool is_alone_;  ///< whether this process has all planes
  int first_row_, rows_;
  std::size_t distance_;  ///< distance of rows that are neighbours along the second axis
  std::size_t plane_;
  std::size_t component_;  ///< distance of components
  Waves values_;           ///< values of the rows on all planes, by component; null on one process
  ArrayParts of_planes_;   ///< parts of a field
  ArrayParts of_rows_;     ///< parts of `values_`
};

}  // namespace breccia::quasistatic
