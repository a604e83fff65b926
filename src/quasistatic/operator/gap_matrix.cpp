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

using Shape = CellShape<2>;

/// The rows of the unknowns that this process sees.
class Rows {
 public:
  explicit Rows(const ElasticOperator<2>& elastic_operator)
      : nodes_(elastic_operator.nodes()), faces_(elastic_operator.faces()) {
    constexpr const char* what = "numbering the rows of the stiffness matrix";
    const auto own_rows = nodes_.zeros();
    PetscInt begin = 0, end = 0;
    check(VecGetOwnershipRange(own_rows.get(), &begin, &end), what);
    {
      const WriteValues values(own_rows.get());
      for (PetscInt row = begin; row < end; ++row) values.data()[row - begin] = row;
    }
    of_nodes_ = nodes_.local_copy(own_rows.get());
    of_faces_.resize(faces_.seen());
    const auto first = static_cast<int>(end) - static_cast<int>(faces_.own());
    std::iota(of_faces_.begin(), of_faces_.begin() + static_cast<std::ptrdiff_t>(faces_.own()), first);
    faces_.copy_from_owners(of_faces_);
  }

  /// The rows of the unknowns of a cell; -1, which PETSc ignores, for those that it does not have.
  [[nodiscard]] std::array<PetscInt, gaps::unknowns_of_cell> of_cell(const Index<2>& cell,
                                                                     const gaps::GapCell* gap) const {
    std::array<PetscInt, gaps::unknowns_of_cell> rows{};
    rows.fill(-1);
    const Shape::Values of_nodes = nodes_.cell_values(cell, ReadValues(of_nodes_.get()).data());
    for (int i = 0; i < Shape::dofs; ++i) rows[static_cast<std::size_t>(i)] = static_cast<PetscInt>(of_nodes[i]);
    if (gap == nullptr) return rows;
    for (std::size_t k = 0; k < gap->face_unknowns.size(); ++k) {
      const auto number = gap->face_unknowns[k];
      if (number != gaps::GapCell::none) rows[Shape::dofs + k] = of_faces_[faces_.index_of(number)];
    }
    return rows;
  }

 private:
  const NodeLayout<2>& nodes_;
  const FaceLayout& faces_;
  NodalVector of_nodes_;
  std::vector<int> of_faces_;
};

}  // namespace

Matrix make_gap_matrix(const ElasticOperator<2>& elastic_operator) {
  constexpr const char* what = "making the stiffness matrix";
  // A node shares its cells with 8 nodes and 12 faces, a face with 6 nodes and 7 faces.
  constexpr PetscInt of_node = 9 * 2 + 12 * gaps::unknowns_of_face, of_face = 6 * 2 + 7 * gaps::unknowns_of_face;
  const auto nodal = elastic_operator.nodes().zeros();
  PetscInt size = 0;
  check(VecGetLocalSize(nodal.get(), &size), what);
  PetscInt all = 0;
  check(VecGetSize(nodal.get(), &all), what);
  const auto rows_of = [&](PetscInt columns) {
    std::vector<PetscInt> in_row(static_cast<std::size_t>(size), std::min(of_node, columns));
    std::fill(in_row.end() - static_cast<std::ptrdiff_t>(elastic_operator.faces().own()), in_row.end(),
              std::min(of_face, columns));
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

void assemble_gap_matrix(const ElasticOperator<2>& elastic_operator, std::span<const Moduli> moduli,
                         double stiffness_of_held, Mat matrix) {
  constexpr const char* what = "assembling the stiffness matrix";
  const auto& nodes = elastic_operator.nodes();
  const auto& kinds = elastic_operator.kinds();
  const auto by_kind = kinds.stiffnesses(moduli);
  const Rows rows(elastic_operator);
  nodes.for_cells([&](const Index<2>& cell) {
    const auto kind = kinds.of(cell);
    const auto* gap = elastic_operator.gap_cell(cell);
    GapOperator::Stiffness stiffness = GapOperator::Stiffness::Zero();
    if (gap != nullptr) {
      const auto of_cell = kinds.mixed()[kind]->moduli(moduli);
      stiffness = GapOperator(*gap, elastic_operator.modes()).stiffness(of_cell, moduli);
    } else {
      stiffness.topLeftCorner<Shape::dofs, Shape::dofs>() = by_kind[kind];
    }
    GapOperator::Unknowns free = GapOperator::Unknowns::Ones();
    free.head<Shape::dofs>() = nodes.held_mask(cell);
    stiffness = free.asDiagonal() * stiffness * free.asDiagonal();
    stiffness.diagonal() += stiffness_of_held * (GapOperator::Unknowns::Ones() - free);
    const auto of_cell = rows.of_cell(cell, gap);
    check(MatSetValues(matrix, gaps::unknowns_of_cell, of_cell.data(), gaps::unknowns_of_cell, of_cell.data(),
                       stiffness.data(), ADD_VALUES),
          what);
  });
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY), what);
}

}  // namespace breccia::quasistatic
