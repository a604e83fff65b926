#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/checkpoint/state.hpp"
#include "breccia/quasistatic/affine_composite.hpp"
#include "breccia/quasistatic/composite_state.hpp"
#include "breccia/quasistatic/network.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/quasistatic/reduced_response_state.hpp"

namespace breccia::quasistatic {

/// The reduced basis of one load, and the Galerkin projection of the stiffness on it. Its vectors are the uniform
/// strain of the load and the solutions for the moduli of the snapshots, orthonormal in the energy of a composite of
/// reference moduli. Moduli [Pa] are those of the phases that vary, in the order of ReducedResponse::phases(). Since
/// the uniform strain is one of the vectors, the mean stress of the reduced solution is exactly the one that follows
/// from its energy.
///
/// The forces of the vectors are not stored: computing them again is cheap.
template <AffineComposite Composite>
class ReducedBasis {
 public:
  using Vector = typename Composite::Vector;

  ReducedBasis(const Composite& composite, Load load, std::vector<Moduli> reference);

  [[nodiscard]] Load load() const noexcept { return load_; }
  [[nodiscard]] const Vector& load_forces() const noexcept { return load_forces_; }
  [[nodiscard]] const ReducedResponse& response() const noexcept { return response_; }

  /// The reduced solution for these moduli, a guess for the solver: under the prescribed strain or,
  /// under a traction boundary, under the unit traction. Zero for an empty basis.
  [[nodiscard]] Vector approximation(std::span<const Moduli> moduli) const;
  /// The composite at a time [s] after the load was applied, per unit of it, where its varying phases are of these
  /// materials, in the order of ReducedResponse::phases() (theory, Eq. 34).
  [[nodiscard]] CompositeState<Vector> state(std::span<const Material> of_phases, double time) const;
  /// Linear combination of the vectors with these weights.
  [[nodiscard]] Vector combination(const Eigen::VectorXd& weights) const;
  /// Adds the solution for these moduli. A solution in the span of the vectors, as in a box of one
  /// material, adds no vector.
  void add(Vector solution, std::vector<Moduli> moduli);

  void save(StateWriter& state, const std::string& group) const;
  void restore(const StateReader& state, const std::string& group);

 private:
  [[nodiscard]] Vector reference_forces(const Vector& displacement) const;
  [[nodiscard]] bool normalise(Vector& vector) const;
  void extend(Vector candidate);
  void extend_projection();
  void extend_residual_products();
  /// K_0 u for part 0, then K_i u.
  [[nodiscard]] Vector forces_of_part(Eigen::Index part, const Vector& displacement) const;

  const Composite* composite_;
  Load load_;
  std::vector<Moduli> reference_;
  Vector load_forces_;
  std::vector<Vector> vectors_;
  ReducedResponse response_;
};

/// Appends a row and a column of zeros to a symmetric matrix.
inline void enlarge(Eigen::MatrixXd& matrix) {
  const auto size = matrix.rows();
  matrix.conservativeResize(size + 1, size + 1);
  matrix.row(size).setZero();
  matrix.col(size).setZero();
}

template <AffineComposite Composite>
ReducedBasis<Composite>::ReducedBasis(const Composite& composite, Load load, std::vector<Moduli> reference)
    : composite_(&composite), load_(load), reference_(std::move(reference)), load_forces_(composite.load_forces(load)) {
  response_.load = load;
  response_.boundary = composite.boundary();
  for (const auto& parameter : composite.parameters()) response_.parts.push_back({parameter, {}});
  // With the square root of the area, e' K^-1 e is a compliance [1/Pa].
  load_forces_.scale(1.0 / std::sqrt(composite.volume()));
  if (composite.boundary() != Boundary::traction) load_forces_.set_macroscopic(std::sqrt(composite.volume()));
  extend(composite.uniform_strain(load));
}

template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::reference_forces(const Vector& displacement) const {
  return composite_->forces(response_.parameters(reference_), load_, displacement);
}

template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::forces_of_part(Eigen::Index part,
                                                                                 const Vector& displacement) const {
  if (part == 0) return composite_->constant_forces(load_, displacement);
  return composite_->part_forces(static_cast<std::size_t>(part) - 1, load_, displacement);
}

/// Orthonormalises a vector against the others (Gram-Schmidt). False when it lies in their span.
template <AffineComposite Composite>
bool ReducedBasis<Composite>::normalise(Vector& vector) const {
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

template <AffineComposite Composite>
void ReducedBasis<Composite>::add(Vector solution, std::vector<Moduli> moduli) {
  response_.snapshots.push_back({std::move(moduli)});
  extend(std::move(solution));
}

/// Adds a vector unless it lies in the span of the others.
template <AffineComposite Composite>
void ReducedBasis<Composite>::extend(Vector candidate) {
  if (!normalise(candidate)) return;
  vectors_.push_back(std::move(candidate));
  extend_projection();
  extend_residual_products();
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::extend_projection() {
  auto& response = response_;
  const auto last = static_cast<Eigen::Index>(vectors_.size()) - 1;
  const auto extend = [&](Eigen::MatrixXd& projection, Eigen::Index part) {
    enlarge(projection);
    const auto forces = forces_of_part(part, vectors_.back());
    for (Eigen::Index i = 0; i <= last; ++i) {
      projection(i, last) = projection(last, i) = work(forces, vectors_[static_cast<std::size_t>(i)]);
    }
  };
  extend(response.constant, 0);
  Eigen::Index number = 0;
  for (auto& part : response.parts) extend(part.stiffness, ++number);
  response.load_forces.conservativeResize(last + 1);
  response.load_forces[last] = work(load_forces_, vectors_.back());
}

/// Scalar products of the parts of the residual: K_0 v of all vectors v, then K_i v for each part, then the load.
template <AffineComposite Composite>
void ReducedBasis<Composite>::extend_residual_products() {
  const auto count = static_cast<Eigen::Index>(response_.parts.size()) + 1;
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
  std::vector<Vector> newest;
  newest.reserve(static_cast<std::size_t>(count));
  for (Eigen::Index part = 0; part < count; ++part) newest.push_back(forces_of_part(part, vectors_.back()));
  const auto multiply = [&](Eigen::Index i, const Vector& forces) {
    for (Eigen::Index part = 0; part < count; ++part) {
      const Eigen::Index j = part * size + last;
      products(i, j) = products(j, i) = product(forces, newest[static_cast<std::size_t>(part)]);
    }
  };
  for (Eigen::Index part = 0; part < count; ++part) {
    for (Eigen::Index i = 0; i < last; ++i) {
      multiply(part * size + i, forces_of_part(part, vectors_[static_cast<std::size_t>(i)]));
    }
    multiply(part * size + last, newest[static_cast<std::size_t>(part)]);
  }
  multiply(count * size, load_forces_);
  if (last == 0) products(count, count) = product(load_forces_, load_forces_);
  response_.residual_products = std::move(products);
}

template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::approximation(std::span<const Moduli> moduli) const {
  if (vectors_.empty()) return composite_->zero();
  const Eigen::VectorXd weights = response_.stiffness(response_.parameters(moduli)).ldlt().solve(response_.load_forces);
  auto sum = combination(weights);
  // Scaled like a solution: macroscopic amplitude 1 where the strain is prescribed, unit traction otherwise. The forces
  // of the projection are those of the unit traction over the square root of the area.
  const bool is_strained = composite_->boundary() != Boundary::traction;
  sum.scale(is_strained ? 1.0 / sum.macroscopic() : std::sqrt(composite_->volume()));
  return sum;
}

template <AffineComposite Composite>
CompositeState<typename Composite::Vector> ReducedBasis<Composite>::state(std::span<const Material> of_phases,
                                                                          double time) const {
  const auto weights = network_state(response_, of_phases, time);
  // The load forces e of the basis are those of the unit load over the square root of the area.
  const double unit = std::sqrt(composite_->volume());
  CompositeState<Vector> state{combination(unit * weights.displacement), {}};
  for (const auto& applied : weights.applied) state.applied.push_back(combination(unit * applied));
  return state;
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::save(StateWriter& state, const std::string& group) const {
  breccia::save(state, group + "/response", response_);
  state.write(group + "/vectors", static_cast<std::int64_t>(vectors_.size()));
  for (std::size_t i = 0; i < vectors_.size(); ++i) {
    save_vector(state, fmt::format("{}/vector/{}", group, i), vectors_[i]);
  }
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::restore(const StateReader& state, const std::string& group) {
  response_ = read_response(state, group + "/response");
  const auto count = state.integer(group + "/vectors");
  vectors_.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    restore_vector(state, fmt::format("{}/vector/{}", group, i), vectors_.emplace_back(composite_->zero()));
  }
}

template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::combination(const Eigen::VectorXd& weights) const {
  auto sum = composite_->zero();
  for (std::size_t i = 0; i < vectors_.size(); ++i) sum.add(weights[static_cast<Eigen::Index>(i)], vectors_[i]);
  return sum;
}

}  // namespace breccia::quasistatic
