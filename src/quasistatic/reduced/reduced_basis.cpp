#include "reduced/reduced_basis.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "breccia/quasistatic/reduced_response_state.hpp"

#include "operator/displacement_state.hpp"

namespace breccia::quasistatic {
namespace {

/// Appends a row and a column of zeros to a symmetric matrix.
void enlarge(Eigen::MatrixXd& matrix) {
  const auto size = matrix.rows();
  matrix.conservativeResize(size + 1, size + 1);
  matrix.row(size).setZero();
  matrix.col(size).setZero();
}

}  // namespace

ReducedBasis::ReducedBasis(const ElasticOperator<2>& elastic_operator, const AffineStiffness& stiffness, Load load,
                           std::vector<Moduli> reference)
    : elastic_operator_(&elastic_operator),
      stiffness_(&stiffness),
      load_(load),
      reference_(std::move(reference)),
      load_forces_(elastic_operator.load_forces(load)) {
  response_.load = load;
  response_.boundary = elastic_operator.boundary();
  for (const auto& part : stiffness.parts) response_.parts.push_back({part.parameter, {}});
  // With the square root of the area, e' K^-1 e is a compliance [1/Pa].
  load_forces_.scale(1.0 / std::sqrt(elastic_operator.volume()));
  if (elastic_operator.boundary() != Boundary::traction)
    load_forces_.set_macroscopic(std::sqrt(elastic_operator.volume()));
  extend(elastic_operator.uniform_strain(load));
}

Forces ReducedBasis::reference_forces(const Displacement& displacement) const {
  return elastic_operator_->forces(stiffness_->moduli_at(response_.parameters(reference_)), load_, displacement);
}

/// Orthonormalises a vector against the others (Gram-Schmidt). False when it lies in their span.
bool ReducedBasis::normalise(Displacement& vector) const {
  constexpr double nothing = 1e-13;
  double before = work(reference_forces(vector), vector);
  // "Twice is enough" for orthogonality to working precision (Giraud, Langou and Rozloznik 2005).
  for (int pass = 0; pass < 2; ++pass) {
    const auto forces = reference_forces(vector);
    for (const auto& other : vectors_) vector.add(-work(forces, other), other);
    const double energy = work(reference_forces(vector), vector);
    if (!(energy > nothing * before)) return false;
    vector.scale(1.0 / std::sqrt(energy));
    before = 1.0;
  }
  return true;
}

void ReducedBasis::add(Displacement solution, std::vector<Moduli> moduli) {
  response_.snapshots.push_back({std::move(moduli)});
  extend(std::move(solution));
}

/// Adds a vector unless it lies in the span of the others.
void ReducedBasis::extend(Displacement candidate) {
  if (!normalise(candidate)) return;
  vectors_.push_back(std::move(candidate));
  extend_projection();
  extend_residual_products();
}

void ReducedBasis::extend_projection() {
  auto& response = response_;
  const auto last = static_cast<Eigen::Index>(vectors_.size()) - 1;
  const auto extend = [&](Eigen::MatrixXd& projection, const std::vector<Moduli>& moduli) {
    enlarge(projection);
    const auto forces = elastic_operator_->forces(moduli, load_, vectors_.back());
    for (Eigen::Index i = 0; i <= last; ++i) {
      projection(i, last) = projection(last, i) = work(forces, vectors_[static_cast<std::size_t>(i)]);
    }
  };
  extend(response.constant, stiffness_->constant);
  for (std::size_t i = 0; i < response.parts.size(); ++i) {
    extend(response.parts[i].stiffness, stiffness_->parts[i].unit);
  }
  response.load_forces.conservativeResize(last + 1);
  response.load_forces[last] = work(load_forces_, vectors_.back());
}

/// Scalar products of the parts of the residual: K_0 v of all vectors v, then K_i v for each part, then the load.
void ReducedBasis::extend_residual_products() {
  std::vector<const std::vector<Moduli>*> parts = {&stiffness_->constant};
  for (const auto& part : stiffness_->parts) parts.push_back(&part.unit);
  const auto count = static_cast<Eigen::Index>(parts.size());
  const auto size = static_cast<Eigen::Index>(vectors_.size()), last = size - 1;
  Eigen::MatrixXd products(count * size + 1, count * size + 1);
  // Index of an earlier product in the smaller matrix.
  const auto earlier = [&](Eigen::Index index) {
    return index == count * size ? count * last : index / size * last + index % size;
  };
  const auto is_new = [&](Eigen::Index index) { return index < count * size && index % size == last; };
  for (Eigen::Index i = 0; i < products.rows(); ++i) {
    for (Eigen::Index j = 0; j < products.cols(); ++j) {
      if (!is_new(i) && !is_new(j) && last > 0) products(i, j) = response_.residual_products(earlier(i), earlier(j));
    }
  }
  std::vector<Forces> newest;
  newest.reserve(parts.size());
  for (const auto* part : parts) newest.push_back(elastic_operator_->forces(*part, load_, vectors_.back()));
  const auto multiply = [&](Eigen::Index i, const Forces& forces) {
    for (Eigen::Index part = 0; part < count; ++part) {
      const Eigen::Index j = part * size + last;
      products(i, j) = products(j, i) = product(forces, newest[static_cast<std::size_t>(part)]);
    }
  };
  for (Eigen::Index part = 0; part < count; ++part) {
    for (Eigen::Index i = 0; i < last; ++i) {
      multiply(part * size + i, elastic_operator_->forces(*parts[static_cast<std::size_t>(part)], load_,
                                                          vectors_[static_cast<std::size_t>(i)]));
    }
    multiply(part * size + last, newest[static_cast<std::size_t>(part)]);
  }
  multiply(count * size, load_forces_);
  if (last == 0) products(count, count) = product(load_forces_, load_forces_);
  response_.residual_products = std::move(products);
}

Displacement ReducedBasis::approximation(std::span<const Moduli> moduli) const {
  if (vectors_.empty()) return elastic_operator_->zero();
  const Eigen::VectorXd weights = response_.stiffness(response_.parameters(moduli)).ldlt().solve(response_.load_forces);
  auto sum = combination(weights);
  // Scaled like a solution: macroscopic amplitude 1 where the strain is prescribed, unit traction otherwise. The forces
  // of the projection are those of the unit traction over the square root of the area.
  const bool is_strained = elastic_operator_->boundary() != Boundary::traction;
  sum.scale(is_strained ? 1.0 / sum.macroscopic() : std::sqrt(elastic_operator_->volume()));
  return sum;
}

void ReducedBasis::save(StateWriter& state, const std::string& group) const {
  breccia::save(state, group + "/response", response_);
  state.write(group + "/vectors", static_cast<std::int64_t>(vectors_.size()));
  for (std::size_t i = 0; i < vectors_.size(); ++i) {
    quasistatic::save(state, fmt::format("{}/vector/{}", group, i), vectors_[i]);
  }
}

void ReducedBasis::restore(const StateReader& state, const std::string& group) {
  response_ = read_response(state, group + "/response");
  const auto count = state.integer(group + "/vectors");
  vectors_.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    quasistatic::restore(state, fmt::format("{}/vector/{}", group, i),
                         vectors_.emplace_back(elastic_operator_->zero()));
  }
}

Displacement ReducedBasis::combination(const Eigen::VectorXd& weights) const {
  auto sum = elastic_operator_->zero();
  for (std::size_t i = 0; i < vectors_.size(); ++i) sum.add(weights[static_cast<Eigen::Index>(i)], vectors_[i]);
  return sum;
}

}  // namespace breccia::quasistatic
