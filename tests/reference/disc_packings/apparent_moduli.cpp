#include "apparent_moduli.hpp"

#include <stdexcept>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

namespace disc_packings {
namespace {

using Eigen::VectorXd;

/// The linear equations of a packing with given moduli.
class Equations {
 public:
  Equations(const std::vector<ElementMatrices>& elements, const Unknowns& unknowns, const Moduli& binder,
            const Moduli& discs)
      : elements_(elements), unknowns_(unknowns.count), held_(unknowns.held), binder_(binder), discs_(discs) {
    // Nested dissection alone: CHOLMOD would try the minimum degree first.
    factor_.cholmod().nmethods = 1;
    factor_.cholmod().method[0].ordering = CHOLMOD_METIS;
    factor_.compute(matrix());
    if (factor_.info() != Eigen::Success) throw std::runtime_error("the equations cannot be factorised");
  }

  /// The forces of the macroscopic strain on the unknowns.
  [[nodiscard]] VectorXd forces(int load) const {
    VectorXd forces = VectorXd::Zero(unknowns_);
    for (const ElementMatrices& element : elements_) {
      forces(element.unknowns) -= shear(element) * element.shear_loads.col(load) +
                                  lame(element) * (element.dilatation.transpose() * element.dilatation_loads.col(load));
    }
    forces.head(held_).setZero();
    return forces;
  }

  [[nodiscard]] VectorXd multiply(const VectorXd& vector) const {
    VectorXd product = VectorXd::Zero(unknowns_);
    for (const ElementMatrices& element : elements_) {
      const VectorXd local = fluctuation(element, vector);
      product(element.unknowns) += shear(element) * (element.shear * local) +
                                   lame(element) * (element.dilatation.transpose() * (element.dilatation * local));
    }
    product.head(held_).setZero();
    return product;
  }

  [[nodiscard]] VectorXd divide(const VectorXd& vector) const {
    VectorXd quotient = VectorXd::Zero(unknowns_);
    quotient.tail(unknowns_ - held_) = factor_.solve(vector.tail(unknowns_ - held_));
    return quotient;
  }

  /// The forces of the tractions on the unknowns: their work is that of the stress on the strains of the binder and,
  /// unless they are rigid, of the discs.
  [[nodiscard]] VectorXd traction_forces(int load) const {
    VectorXd forces = VectorXd::Zero(unknowns_);
    for (const ElementMatrices& element : elements_) forces(element.unknowns) += element.stress_forces.col(load);
    forces.head(held_).setZero();
    return forces;
  }

  /// Twice the energy of the box at the strain of the load.
  [[nodiscard]] double energy(int load, const VectorXd& fluctuations) const {
    double energy = 0.0;
    for (const ElementMatrices& element : elements_) {
      const VectorXd local = fluctuation(element, fluctuations);
      const VectorXd dilatation = element.dilatation * local + element.dilatation_loads.col(load);
      energy += shear(element) * (local.dot(element.shear * local) + 2.0 * local.dot(element.shear_loads.col(load)) +
                                  element.shear_energies[load]) +
                lame(element) * dilatation.squaredNorm();
    }
    return energy;
  }

 private:
  [[nodiscard]] const Moduli& moduli(const ElementMatrices& element) const {
    return element.region == Region::disc ? discs_ : binder_;
  }
  [[nodiscard]] double shear(const ElementMatrices& element) const { return moduli(element).shear; }
  [[nodiscard]] double lame(const ElementMatrices& element) const {
    return moduli(element).bulk - 2.0 / 3.0 * moduli(element).shear;
  }

  /// The unknowns of an element less its translation, which has no energy: its forces would be differences of large
  /// numbers, the larger the bulk modulus.
  [[nodiscard]] VectorXd fluctuation(const ElementMatrices& element, const VectorXd& vector) const {
    const VectorXd local = vector(element.unknowns);
    return local - element.translations * local.tail<2>();
  }

  /// The upper triangle of the matrix.
  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (const ElementMatrices& element : elements_) {
      const Eigen::MatrixXd local =
          shear(element) * element.shear + lame(element) * element.dilatation.transpose() * element.dilatation;
      for (int i = 0; i < local.rows(); ++i) {
        for (int j = 0; j < local.cols(); ++j) {
          const int row = element.unknowns[i] - held_;
          const int column = element.unknowns[j] - held_;
          if (row >= 0 && row <= column) entries.emplace_back(row, column, local(i, j));
        }
      }
    }
    Eigen::SparseMatrix<double> matrix(unknowns_ - held_, unknowns_ - held_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  const std::vector<ElementMatrices>& elements_;
  int unknowns_, held_;
  Moduli binder_, discs_;
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Upper> factor_;
};

/// Solves by conjugate gradients with the factors of the matrix as preconditioner. One or two steps take away the
/// rounding errors of the matrix, in whose entries a large bulk modulus drowns the shear modulus; in the product by
/// elements both are apart.
VectorXd solve(const Equations& equations, const VectorXd& forces) {
  constexpr double tolerance = 1e-18;  // of the energy of the error
  constexpr int most_steps = 300;
  VectorXd solution = VectorXd::Zero(forces.size());
  VectorXd residual = forces;
  VectorXd correction = equations.divide(residual);
  VectorXd direction = correction;
  double error = residual.dot(correction);
  const double first_error = error;
  for (int step = 0; step < most_steps; ++step) {
    const VectorXd product = equations.multiply(direction);
    const double length = error / direction.dot(product);
    solution += length * direction;
    residual -= length * product;
    correction = equations.divide(residual);
    const double next_error = residual.dot(correction);
    if (next_error < tolerance * first_error) return solution;
    direction = correction + next_error / error * direction;
    error = next_error;
  }
  throw std::runtime_error("conjugate gradients do not converge");
}

/// Twice the energy at the strain E of the load.
double modulus_at_strain(const Equations& equations, int load) {
  return equations.energy(load, solve(equations, equations.forces(load)));
}

/// The stress 2 E has the work 2 E : e on the mean strain e, which is twice the energy. In a material for which E is an
/// eigenvector of the stiffness, this is 1 / (E : C E), as E : E = 1/2; C E is the modulus times 2 E.
double modulus_at_stress(const Equations& equations, int load) {
  const VectorXd forces = equations.traction_forces(load);
  const VectorXd displacements = solve(equations, forces);
  return 1.0 / (2.0 * forces.dot(displacements) - displacements.dot(equations.multiply(displacements)));
}

}  // namespace

std::array<double, 3> apparent_moduli(const std::vector<ElementMatrices>& elements, const Unknowns& unknowns,
                                      Boundary boundary, const Moduli& binder, const Moduli& discs) {
  const Equations equations(elements, unknowns, binder, discs);
  const auto modulus = boundary == Boundary::traction ? modulus_at_stress : modulus_at_strain;
  std::array<double, 3> moduli = {};
  for (int load = 0; load < 3; ++load) moduli[load] = modulus(equations, load);
  return moduli;
}

}  // namespace disc_packings
