#include "element_matrices.hpp"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "reference_element.hpp"

namespace disc_packings {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixX2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The matrices of an element by the displacements of its nodes, x and y in turn.
struct NodalMatrices {
  double area = 0.0;
  MatrixXd shear, dilatation;
  Eigen::MatrixX3d strains;  ///< integrals of e_xx, e_yy and 2 e_xy
};

/// The points of an element, a row for each node, from their mean.
MatrixX2d centred_points(const MeshElement& element) {
  MatrixX2d points(element.points.size(), 2);
  for (int node = 0; node < points.rows(); ++node) points.row(node) = element.points[node].transpose();
  return points.rowwise() - points.colwise().mean();
}

/// The monomials of up to order - 1 at a point.
VectorXd pressure_polynomials(int order, const Vector2d& point) {
  VectorXd polynomials(order * (order + 1) / 2);
  int next = 0;
  for (int degree = 0; degree < order; ++degree) {
    for (int of_y = 0; of_y <= degree; ++of_y) {
      polynomials[next++] = std::pow(point.x(), degree - of_y) * std::pow(point.y(), of_y);
    }
  }
  return polynomials;
}

NodalMatrices nodal_matrices(const MeshElement& element, const ReferenceElement& reference) {
  const int size = 2 * reference.nodes();
  const int pressures = reference.order() * (reference.order() + 1) / 2;
  const MatrixX2d points = centred_points(element);
  // Pressures are polynomials of the position, not of the coordinates of the square, scaled to the element.
  const Matrix2d to_square = (points.transpose() * reference.centre().gradients).inverse();

  NodalMatrices result = {0.0, MatrixXd::Zero(size, size), {}, Eigen::MatrixX3d::Zero(size, 3)};
  MatrixXd pressure_by_divergence = MatrixXd::Zero(pressures, size);
  MatrixXd pressure_by_pressure = MatrixXd::Zero(pressures, pressures);
  double orientation = 0.0;
  for (const auto& [weight, shapes] : reference.points()) {
    const Matrix2d jacobian = points.transpose() * shapes.gradients;
    const double determinant = jacobian.determinant();
    if (orientation == 0.0) orientation = determinant;
    if (determinant * orientation <= 0.0) throw std::runtime_error("an element is folded");
    const double area = std::abs(determinant) * weight;
    const MatrixX2d gradients = shapes.gradients * jacobian.inverse();

    VectorXd strain_xx = VectorXd::Zero(size);
    VectorXd strain_yy = VectorXd::Zero(size);
    VectorXd twice_strain_xy(size);
    for (int node = 0; node < reference.nodes(); ++node) {
      strain_xx[2 * node] = twice_strain_xy[2 * node + 1] = gradients(node, 0);
      strain_yy[2 * node + 1] = twice_strain_xy[2 * node] = gradients(node, 1);
    }
    const VectorXd divergence = strain_xx + strain_yy;
    const VectorXd pressure = pressure_polynomials(reference.order(), to_square * (points.transpose() * shapes.values));
    result.area += area;
    result.shear += area * (2.0 * strain_xx * strain_xx.transpose() + 2.0 * strain_yy * strain_yy.transpose() +
                            twice_strain_xy * twice_strain_xy.transpose());
    result.strains.col(0) += area * strain_xx;
    result.strains.col(1) += area * strain_yy;
    result.strains.col(2) += area * twice_strain_xy;
    pressure_by_divergence += area * pressure * divergence.transpose();
    pressure_by_pressure += area * pressure * pressure.transpose();
  }
  result.dilatation = pressure_by_pressure.llt().matrixL().solve(pressure_by_divergence);
  return result;
}

/// How the nodes of an element move with its unknowns.
struct Motion {
  std::vector<int> unknowns;
  MatrixXd of_nodes;       ///< displacements of the nodes by the unknowns
  MatrixX2d translations;  ///< the unknowns of translations
};

Motion motion_of(const MeshElement& element, const Disc& disc, const Unknowns& all) {
  const int nodes = static_cast<int>(element.nodes.size());
  Motion motion = {{}, MatrixXd::Zero(2 * nodes, 2 * nodes + 3), MatrixX2d::Zero(2 * nodes + 3, 2)};
  std::map<int, int> columns;  // of the first unknown of each node, or of the disc
  const auto column_of = [&](int first, int count) {
    const int next = static_cast<int>(motion.unknowns.size());
    const auto [entry, is_new] = columns.insert({first, next});
    if (is_new) {
      for (int i = 0; i < count; ++i) motion.unknowns.push_back(first + i);
      motion.translations.block<2, 2>(next, 0).setIdentity();
    }
    return entry->second;
  };
  for (int node = 0; node < nodes; ++node) {
    const int first = all.first_of_node[element.nodes[node]];
    const bool follows_disc = first < 0;
    const int column = follows_disc ? column_of(all.first_of_disc(element.disc), 3) : column_of(first, 2);
    motion.of_nodes.block<2, 2>(2 * node, column).setIdentity();
    if (!follows_disc) continue;
    const Vector2d arm = (element.points[node] - disc.centre) / disc.radius;
    motion.of_nodes.block<2, 1>(2 * node, column + 2) << -arm.y(), arm.x();
  }
  const auto count = static_cast<Eigen::Index>(motion.unknowns.size());
  motion.of_nodes.conservativeResize(Eigen::NoChange, count);
  motion.translations.conservativeResize(count, Eigen::NoChange);
  return motion;
}

/// The displacements of the nodes by the macroscopic strain alone, seen from the centre of the disc: rigid discs stay.
VectorXd affine_displacements(const MeshElement& element, const Disc& disc, const Unknowns& all,
                              const Matrix2d& strain) {
  VectorXd displacements = VectorXd::Zero(2 * static_cast<Eigen::Index>(element.nodes.size()));
  for (std::size_t node = 0; node < element.nodes.size(); ++node) {
    if (all.first_of_node[element.nodes[node]] < 0) continue;
    displacements.segment<2>(2 * static_cast<Eigen::Index>(node)) = strain * (element.points[node] - disc.centre);
  }
  return displacements;
}

}  // namespace

const std::array<Load, 3>& loads() {
  static const std::array<Load, 3> all = {
      Load{"xx-yy", Matrix2d{{0.5, 0.0}, {0.0, -0.5}}},
      Load{"xy", Matrix2d{{0.0, 0.5}, {0.5, 0.0}}},
      Load{"bulk", Matrix2d{{0.5, 0.0}, {0.0, 0.5}}},
  };
  return all;
}

std::vector<ElementMatrices> element_matrices(const Mesh& mesh, const Packing& packing, const Unknowns& unknowns,
                                              int order) {
  const ReferenceElement reference(order);
  std::vector<ElementMatrices> all;
  for (const MeshElement& element : mesh.elements) {
    const Disc& disc = packing[element.disc];
    const auto [area, shear, dilatation, strains] = nodal_matrices(element, reference);
    const auto [numbers, of_nodes, translations] = motion_of(element, disc, unknowns);
    MatrixXd affine(2 * reference.nodes(), 3);
    Eigen::Matrix3d stresses;
    for (int load = 0; load < 3; ++load) {
      const Matrix2d& strain = loads()[load].strain;
      affine.col(load) = affine_displacements(element, disc, unknowns, strain);
      stresses.col(load) << 2.0 * strain(0, 0), 2.0 * strain(1, 1), 2.0 * strain(0, 1);
    }
    const MatrixXd shear_by_nodes = of_nodes.transpose() * shear;
    all.push_back({.region = element.region,
                   .area = area,
                   .unknowns = numbers,
                   .translations = translations,
                   .shear = shear_by_nodes * of_nodes,
                   .dilatation = dilatation * of_nodes,
                   .shear_loads = shear_by_nodes * affine,
                   .dilatation_loads = dilatation * affine,
                   .stress_forces = of_nodes.transpose() * strains * stresses,
                   .shear_energies = (affine.transpose() * shear * affine).diagonal()});
  }
  return all;
}

}  // namespace disc_packings
