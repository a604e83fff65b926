#include "quasistatic/operator/gap_operator.hpp"

#include <cstddef>

#include "discretisation/gaps/cell_place.hpp"

namespace breccia::quasistatic {

GapOperator::Unknowns GapOperator::unknowns(const Shape::Values& of_nodes, const FaceLayout& faces,
                                            std::span<const double> of_faces) const noexcept {
  Unknowns unknowns = Unknowns::Zero();
  unknowns.head<Shape::dofs>() = of_nodes;
  for (std::size_t k = 0; k < cell_->face_unknowns.size(); ++k) {
    const auto number = cell_->face_unknowns[k];
    if (number != gaps::GapCell::none)
      unknowns[Shape::dofs + static_cast<Eigen::Index>(k)] = of_faces[faces.index_of(number)];
  }
  return unknowns;
}

GapOperator::Modes GapOperator::strain(const Unknowns& unknowns) const noexcept {
  Modes strain = *modes_ * unknowns.head<Shape::dofs>();
  strain[Shape::modes - 1] = volume(unknowns);
  return strain;
}

GapOperator::Unknowns GapOperator::linear_motion(const Eigen::Matrix2d& gradient) noexcept {
  Unknowns motion = Unknowns::Zero();
  for (int node = 0; node < Shape::nodes; ++node) {
    const auto corner = Shape::corner(node);
    motion.segment<2>(2 * node) = gradient * Eigen::Vector2d(corner[0], corner[1]);
  }
  for (int face = 0; face < gaps::faces_of_cell; ++face) {
    const auto normal = static_cast<Eigen::Index>(gaps::CellPlace::normal(face));
    for (int end = 0; end < 2; ++end) motion[gaps::slope_at(face, end)] = gradient(normal, 1 - normal);
  }
  return motion;
}

void GapOperator::add_forces_of(const Modes& stress, Unknowns& forces) const noexcept {
  forces.head<Shape::dofs>() += modes_->topRows<Shape::modes - 1>().transpose() * stress.head<Shape::modes - 1>();
  forces += stress[Shape::modes - 1] * cell_->volume;
}

void GapOperator::add_forces_of_terms(std::span<const Moduli> moduli, const Unknowns& unknowns,
                                      Unknowns& forces) const noexcept {
  for (const auto& [phase, factor, form] : cell_->terms) {
    form.add_to(forces, factor * moduli[phase].shear * form.of(unknowns));
  }
}

void GapOperator::add_to_faces(const Unknowns& forces, const FaceLayout& faces,
                               std::span<double> on_faces) const noexcept {
  for (std::size_t k = 0; k < cell_->face_unknowns.size(); ++k) {
    const auto number = cell_->face_unknowns[k];
    if (number != gaps::GapCell::none)
      on_faces[faces.index_of(number)] += forces[Shape::dofs + static_cast<Eigen::Index>(k)];
  }
}

GapOperator::Stiffness GapOperator::stiffness(const Moduli& of_cell, std::span<const Moduli> moduli) const {
  Modes weights = Modes::Constant(of_cell.shear);
  weights[Shape::modes - 1] = dilatational_modulus<2>(of_cell);
  Stiffness stiffness;
  for (Eigen::Index column = 0; column < gaps::unknowns_of_cell; ++column) {
    const Unknowns unit = Unknowns::Unit(column);
    Unknowns forces = Unknowns::Zero();
    add_forces_of(weights.cwiseProduct(strain(unit)), forces);
    add_forces_of_terms(moduli, unit, forces);
    stiffness.col(column) = forces;
  }
  return stiffness;
}

}  // namespace breccia::quasistatic
