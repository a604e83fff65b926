#include "reference_element.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace disc_packings {
namespace {

using Eigen::VectorXd;

/// Points and weights of Gauss's rule on [-1, 1], by the eigenvalues of the recursion of Legendre's polynomials.
struct GaussRule {
  VectorXd points, weights;
};

GaussRule gauss_rule(int count) {
  Eigen::MatrixXd recursion = Eigen::MatrixXd::Zero(count, count);
  for (int i = 1; i < count; ++i) recursion(i, i - 1) = recursion(i - 1, i) = i / std::sqrt(4.0 * i * i - 1.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(recursion);
  return {eigen.eigenvalues(), 2.0 * eigen.eigenvectors().row(0).transpose().cwiseAbs2()};
}

/// Lagrange's polynomials of equidistant nodes on [-1, 1] and their derivatives at x.
struct LagrangePolynomials {
  VectorXd values, derivatives;
};

LagrangePolynomials lagrange_polynomials(int order, double x) {
  const VectorXd nodes = VectorXd::LinSpaced(order + 1, -1.0, 1.0);
  LagrangePolynomials result = {VectorXd::Ones(order + 1), VectorXd::Zero(order + 1)};
  for (int i = 0; i <= order; ++i) {
    for (int j = 0; j <= order; ++j) {
      if (j == i) continue;
      result.values[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
      double term = 1.0 / (nodes[i] - nodes[j]);  // the product with its factor j differentiated
      for (int other = 0; other <= order; ++other) {
        if (other != i && other != j) term *= (x - nodes[other]) / (nodes[i] - nodes[other]);
      }
      result.derivatives[i] += term;
    }
  }
  return result;
}

ShapeFunctions shape_functions(int order, double x, double y) {
  const LagrangePolynomials along_x = lagrange_polynomials(order, x);
  const LagrangePolynomials along_y = lagrange_polynomials(order, y);
  const int side = order + 1;
  ShapeFunctions shapes = {VectorXd(side * side), Eigen::MatrixX2d(side * side, 2)};
  for (int node = 0; node < side * side; ++node) {
    const int i = node % side;
    const int j = node / side;
    shapes.values[node] = along_x.values[i] * along_y.values[j];
    shapes.gradients.row(node) << along_x.derivatives[i] * along_y.values[j],
        along_x.values[i] * along_y.derivatives[j];
  }
  return shapes;
}

}  // namespace

ReferenceElement::ReferenceElement(int order) : order_(order), centre_(shape_functions(order, 0.0, 0.0)) {
  const auto [points, weights] = gauss_rule(order + 2);
  for (int i = 0; i < points.size(); ++i) {
    for (int j = 0; j < points.size(); ++j) {
      points_.push_back({weights[i] * weights[j], shape_functions(order, points[i], points[j])});
    }
  }
}

}  // namespace disc_packings
