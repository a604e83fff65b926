#pragma once

#include <vector>

#include <Eigen/Core>

namespace disc_packings {

/// The shape functions of all nodes at a point of the square [-1, 1] x [-1, 1], in the order of MeshElement.
struct ShapeFunctions {
  Eigen::VectorXd values;
  Eigen::MatrixX2d gradients;
};

/// The square with equidistant nodes from which the elements of a mesh are mapped.
class ReferenceElement {
 public:
  explicit ReferenceElement(int order);

  struct Point {
    double weight;
    ShapeFunctions shapes;
  };

  [[nodiscard]] int order() const { return order_; }
  [[nodiscard]] int nodes() const { return (order_ + 1) * (order_ + 1); }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }  ///< Gauss points
  [[nodiscard]] const ShapeFunctions& centre() const { return centre_; }

 private:
  int order_;
  std::vector<Point> points_;
  ShapeFunctions centre_;
};

}  // namespace disc_packings
