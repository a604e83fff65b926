#include "reduced_basis.hpp"

#include <cmath>
#include <utility>

namespace breccia::quasistatic {
namespace {

/// Puts a row and column around a symmetric matrix.
void enlarge(Eigen::MatrixXd& matrix) {
  const auto size = matrix.rows();
  matrix.conservativeResize(size + 1, size + 1);
  matrix.row(size).setZero();
  matrix.col(size).setZero();
}

double product(const Field& a, const Field& b) {
  double sum = 0.0;
  check(VecDot(a.rest(), b.rest(), &sum), "a scalar product");
  return sum;
}

}  // namespace

std::vector<Moduli> StiffnessParts::with(const Moduli& matrix) const {
  auto moduli = filler;
  for (std::size_t m = 0; m < moduli.size(); ++m) {
    moduli[m].bulk += matrix.bulk * matrix_bulk[m].bulk;
    moduli[m].shear += matrix.shear * matrix_shear[m].shear;
  }
  return moduli;
}

ReducedBasis::ReducedBasis(const ElasticBox& box, const StiffnessParts& parts, Load load, const Moduli& reference)
    : box_(&box), parts_(&parts), load_(load), reference_(reference), load_forces_(box.load_forces(load)) {
  response_.load = load;
  response_.boundary = box.boundary();
  // With the square root of the area, e' K^-1 e is a compliance [1/Pa].
  load_forces_.scale(1.0 / std::sqrt(box.area()));
  if (box.boundary() != Boundary::traction) load_forces_.set_affine(std::sqrt(box.area()));
  extend(box.uniform_strain(load));
}

double ReducedBasis::reference_energy(const PartForces& forces, const Field& displacement) const {
  return work(forces.filler, displacement) + reference_.shear * work(forces.matrix_shear, displacement) +
         reference_.bulk * work(forces.matrix_bulk, displacement);
}

/// Makes a vector orthonormal to the others. False when nothing is left of it.
bool ReducedBasis::normalise(Field& vector) const {
  constexpr double nothing = 1e-13;
  double before = work(box_->forces(parts_->with(reference_), load_, vector), vector);
  // Twice is enough (Giraud, Langou and Rozloznik 2005).
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      vector.add(-reference_energy(forces_[i], vector), vectors_[i]);
    }
    const double energy = work(box_->forces(parts_->with(reference_), load_, vector), vector);
    if (!(energy > nothing * before)) return false;
    vector.scale(1.0 / std::sqrt(energy));
    before = 1.0;
  }
  return true;
}

void ReducedBasis::add(Field solution, const Moduli& matrix) {
  response_.snapshots.push_back({matrix});
  extend(std::move(solution));
}

/// Takes a vector that the others do not hold already.
void ReducedBasis::extend(Field candidate) {
  if (!normalise(candidate)) return;
  vectors_.push_back(std::move(candidate));
  const auto& vector = vectors_.back();
  forces_.push_back({box_->forces(parts_->filler, load_, vector), box_->forces(parts_->matrix_shear, load_, vector),
                     box_->forces(parts_->matrix_bulk, load_, vector)});
  extend_projection();
}

void ReducedBasis::extend_projection() {
  const auto size = static_cast<Eigen::Index>(vectors_.size());
  auto& [load, boundary, a, b, c, e, products, scale, snapshots] = response_;
  for (auto* matrix : {&a, &b, &c}) enlarge(*matrix);
  e.conservativeResize(size);
  const auto last = size - 1;
  e[last] = work(load_forces_, vectors_.back());
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& forces = forces_[static_cast<std::size_t>(i)];
    a(i, last) = a(last, i) = work(forces.filler, vectors_.back());
    b(i, last) = b(last, i) = work(forces.matrix_shear, vectors_.back());
    c(i, last) = c(last, i) = work(forces.matrix_bulk, vectors_.back());
  }
  // The parts of the residual: of A, then of B, then of C, then the load.
  std::vector<const Field*> parts;
  for (const auto& forces : forces_) parts.push_back(&forces.filler);
  for (const auto& forces : forces_) parts.push_back(&forces.matrix_shear);
  for (const auto& forces : forces_) parts.push_back(&forces.matrix_bulk);
  parts.push_back(&load_forces_);
  const auto count = static_cast<Eigen::Index>(parts.size());
  products.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      products(i, j) = products(j, i) =
          product(*parts[static_cast<std::size_t>(i)], *parts[static_cast<std::size_t>(j)]);
    }
  }
}

Field ReducedBasis::approximation(const Moduli& matrix) const {
  if (vectors_.empty()) return box_->zero_field();
  const Eigen::VectorXd weights =
      (response_.filler + matrix.shear * response_.matrix_shear + matrix.bulk * response_.matrix_bulk)
          .ldlt()
          .solve(response_.load_forces);
  auto sum = combination(weights);
  // As the solutions are: all of the affine motion where that is given, the unit traction else.
  const bool is_strained = box_->boundary() != Boundary::traction;
  sum.scale(is_strained ? 1.0 / sum.affine() : 1.0);
  return sum;
}

Field ReducedBasis::combination(const Eigen::VectorXd& weights) const {
  auto sum = box_->zero_field();
  for (std::size_t i = 0; i < vectors_.size(); ++i) sum.add(weights[static_cast<Eigen::Index>(i)], vectors_[i]);
  return sum;
}

}  // namespace breccia::quasistatic
