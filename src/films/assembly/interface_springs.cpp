#include "films/assembly/interface_springs.hpp"

#include <iterator>

namespace breccia::films {
namespace {

/// A matrix with columns for the jumps: those of the displacements of the second side.
Eigen::MatrixXd with_columns_of_jumps(const Eigen::MatrixXd& matrix, const InterfaceSprings& springs) {
  const auto side = std::ssize(springs.jumps);
  Eigen::MatrixXd all(matrix.rows(), matrix.cols() + side);
  all << matrix, matrix.middleCols(side, side);
  return all;
}

}  // namespace

InterfaceStiffness in_sides_of_the_box(const InterfaceStiffness& springs, double side) {
  return {.normal = side * springs.normal, .tangential = side * springs.tangential};
}

Eigen::MatrixXd spring_stiffness(const InterfaceStiffness& springs, const Eigen::VectorXd& normal,
                                 const Eigen::MatrixXd& products) {
  const auto dim = normal.size(), nodes = products.rows();
  const Eigen::MatrixXd across = normal * normal.transpose();
  const Eigen::MatrixXd along = Eigen::MatrixXd::Identity(dim, dim) - across;
  const Eigen::MatrixXd of_point = springs.normal * across + springs.tangential * along;
  Eigen::MatrixXd stiffness(dim * nodes, dim * nodes);
  for (Eigen::Index a = 0; a < nodes; ++a) {
    for (Eigen::Index b = 0; b < nodes; ++b) stiffness.block(dim * a, dim * b, dim, dim) = products(a, b) * of_point;
  }
  return stiffness;
}

template <int dim>
ElementUnknowns<dim> unknowns_of_jumps(const InterfaceSprings& springs) {
  ElementUnknowns<dim> unknowns;
  unknowns.numbers = springs.jumps;
  unknowns.macroscopic.setZero(std::ssize(springs.jumps), FilmMatrices<dim>::macroscopic);
  return unknowns;
}

template <int dim>
ElementUnknowns<dim> with_jumps(const ElementUnknowns<dim>& unknowns, const InterfaceSprings& springs) {
  const auto jumps = unknowns_of_jumps<dim>(springs);
  ElementUnknowns<dim> all = unknowns;
  all.numbers.insert(all.numbers.end(), jumps.numbers.begin(), jumps.numbers.end());
  all.macroscopic.resize(std::ssize(all.numbers), FilmMatrices<dim>::macroscopic);
  all.macroscopic << unknowns.macroscopic, jumps.macroscopic;
  return all;
}

Eigen::MatrixXd dilatation_with_jumps(const Eigen::MatrixXd& dilatation, const InterfaceSprings& springs) {
  auto all = with_columns_of_jumps(dilatation, springs);
  if (!springs.jumps.empty()) all.rightCols(std::ssize(springs.jumps)) -= springs.outflow;
  return all;
}

Eigen::MatrixXd stiffness_with_jumps(const Eigen::MatrixXd& stiffness, const InterfaceSprings& springs) {
  return with_columns_of_jumps(with_columns_of_jumps(stiffness, springs).transpose(), springs);
}

template ElementUnknowns<2> unknowns_of_jumps<2>(const InterfaceSprings&);
template ElementUnknowns<3> unknowns_of_jumps<3>(const InterfaceSprings&);
template ElementUnknowns<2> with_jumps(const ElementUnknowns<2>&, const InterfaceSprings&);
template ElementUnknowns<3> with_jumps(const ElementUnknowns<3>&, const InterfaceSprings&);

}  // namespace breccia::films
