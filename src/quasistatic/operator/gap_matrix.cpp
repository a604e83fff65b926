#include "quasistatic/operator/gap_matrix.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// The most unknowns that a cell has in common with the displacement of a node, and with an unknown of a gap. In the
/// plane a node shares its cells with 8 nodes and 12 faces, a face with 6 nodes and 7 faces; in space a node and
/// its slopes share them with 27 nodes, their slopes, and 36 faces.
template <int dim>
constexpr PetscInt beside_node = dim == 2 ? 9 * 2 + 12 * 3 : 27 * (3 + 6) + 36;
template <int dim>
constexpr PetscInt beside_gap = dim == 2 ? 6 * 2 + 7 * 3 : 27 * (3 + 6) + 36;

/// The rows of the unknowns that this process sees.
template <int dim>
class Rows {
 public:
  using Shape = CellShape<dim>;

  explicit Rows(const ElasticOperator<dim>& elastic_operator)
      : nodes_(elastic_operator.nodes()), gap_layout_(elastic_operator.gap_layout()) {
    constexpr const char* what = "numbering the rows of the stiffness matrix";
    const auto own_rows = nodes_.zeros();
    PetscInt begin = 0, end = 0;
    check(VecGetOwnershipRange(own_rows.get(), &begin, &end), what);
    {
      const WriteValues values(own_rows.get());
      for (PetscInt row = begin; row < end; ++row) values.data()[row - begin] = row;
    }
    of_nodes_ = nodes_.local_copy(own_rows.get());
    of_gaps_.resize(gap_layout_.seen());
    const auto first = static_cast<int>(end) - static_cast<int>(gap_layout_.own());
    std::iota(of_gaps_.begin(), of_gaps_.begin() + static_cast<std::ptrdiff_t>(gap_layout_.own()), first);
    gap_layout_.copy_from_owners(of_gaps_);
  }

  /// The rows of the unknowns of a cell; -1, which PETSc ignores, for those that it does not have.
  [[nodiscard]] std::array<PetscInt, gaps::unknowns_of_cell<dim>> of_cell(const Index<dim>& cell,
                                                                          const gaps::GapCell<dim>* gap) const {
    std::array<PetscInt, gaps::unknowns_of_cell<dim>> rows{};
    rows.fill(-1);
    const typename Shape::Values of_nodes = nodes_.cell_values(cell, ReadValues(of_nodes_.get()).data());
    for (int i = 0; i < Shape::dofs; ++i) rows[static_cast<std::size_t>(i)] = static_cast<PetscInt>(of_nodes[i]);
    if (gap == nullptr) return rows;
    for (std::size_t k = 0; k < gap->gap_unknowns.size(); ++k) {
      const auto number = gap->gap_unknowns[k];
      if (number != gaps::GapCell<dim>::none) rows[Shape::dofs + k] = of_gaps_[gap_layout_.index_of(number)];
    }
    return rows;
  }

 private:
  const NodeLayout<dim>& nodes_;
  const GapLayout& gap_layout_;
  NodalVector of_nodes_;
  std::vector<int> of_gaps_;
};

}  // namespace

template <int dim>
Matrix make_gap_matrix(const ElasticOperator<dim>& elastic_operator) {
  constexpr const char* what = "making the stiffness matrix";
  const auto nodal = elastic_operator.nodes().zeros();
  PetscInt size = 0;
  check(VecGetLocalSize(nodal.get(), &size), what);
  PetscInt all = 0;
  check(VecGetSize(nodal.get(), &all), what);
  const auto rows_of = [&](PetscInt columns) {
    std::vector<PetscInt> in_row(static_cast<std::size_t>(size), std::min(beside_node<dim>, columns));
    std::fill(in_row.end() - static_cast<std::ptrdiff_t>(elastic_operator.gap_layout().own()), in_row.end(),
              std::min(beside_gap<dim>, columns));
    return in_row;
  };
  const auto in_row = rows_of(size), elsewhere = rows_of(all - size);
  Matrix matrix;
  check(MatCreateAIJ(PETSC_COMM_WORLD, size, size, PETSC_DETERMINE, PETSC_DETERMINE, 0, in_row.data(), 0,
                     elsewhere.data(), matrix.put()),
        what);
  check(MatSetOption(matrix.get(), MAT_SPD, PETSC_TRUE), what);
  return matrix;
}

template <int dim>
void assemble_gap_matrix(const ElasticOperator<dim>& elastic_operator, std::span<const Moduli> moduli,
                         double stiffness_of_held, Mat matrix) {
  constexpr const char* what = "assembling the stiffness matrix";
  const auto& nodes = elastic_operator.nodes();
  const auto& kinds = elastic_operator.kinds();
  const auto by_kind = kinds.stiffnesses(moduli);
  const Rows<dim> rows(elastic_operator);
  nodes.for_cells([&](const Index<dim>& cell) {
    const auto kind = kinds.of(cell);
    const auto* gap = elastic_operator.gap_cell(cell);
    using Operator = GapOperator<dim>;
    typename Operator::Stiffness stiffness = Operator::Stiffness::Zero();
    if (gap != nullptr) {
      const auto of_cell = kinds.mixed()[kind]->moduli(moduli);
      stiffness = Operator(*gap, elastic_operator.modes()).stiffness(of_cell, moduli);
    } else {
      stiffness.template topLeftCorner<CellShape<dim>::dofs, CellShape<dim>::dofs>() = by_kind[kind];
    }
    typename Operator::Unknowns free = Operator::Unknowns::Ones();
    free.template head<CellShape<dim>::dofs>() = nodes.held_mask(cell);
    stiffness = free.asDiagonal() * stiffness * free.asDiagonal();
    stiffness.diagonal() += stiffness_of_held * (Operator::Unknowns::Ones() - free);
    const auto of_cell = rows.of_cell(cell, gap);
    check(MatSetValues(matrix, gaps::unknowns_of_cell<dim>, of_cell.data(), gaps::unknowns_of_cell<dim>, of_cell.data(),
                       stiffness.data(), ADD_VALUES),
          what);
  });
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY), what);
}

template Matrix make_gap_matrix(const ElasticOperator<2>&);
template Matrix make_gap_matrix(const ElasticOperator<3>&);
template void assemble_gap_matrix(const ElasticOperator<2>&, std::span<const Moduli>, double, Mat);
template void assemble_gap_matrix(const ElasticOperator<3>&, std::span<const Moduli>, double, Mat);

}  // namespace breccia::quasistatic
