#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

#include "checkpoint/state.hpp"
#include "quasistatic/reduced/affine_composite.hpp"
#include "quasistatic/reduced/composite_state.hpp"
#include "quasistatic/reduced/network.hpp"
#include "quasistatic/reduced/reduced_response_state.hpp"
#include "quasistatic/reduced/stored_vectors.hpp"

namespace breccia::quasistatic {

/// The reduced basis of one load, and the Galerkin projection of the stiffness on it. Its vectors are the uniform
/// strain of the load and the solutions for the moduli of the snapshots, orthonormal in the energy of a composite of
/// reference moduli. Moduli [Pa] are those of the phases that vary, in the order of ReducedResponse::phases(). Since
/// the uniform strain is one of the vectors, the mean stress of the reduced solution agrees exactly with its energy.
///
/// GreedySampling fills the basis: the first snapshot gives the reference moduli, each further snapshot a vector. The
/// reduced response is copied out at the end; relaxation moduli, `response.h5` and a Responder use only this response
/// (creep_compliance in reduced_response.hpp). The vectors are used only for the fields (theory, section 10).
///
/// The forces of the vectors are not stored: computing them again is cheap.
template <AffineComposite Composite>
class ReducedBasis {
 public:
  using Vector = typename Composite::Vector;

  ReducedBasis(const Composite& composite, Load load, std::vector<Moduli> reference);

  [[nodiscard]] Load load() const noexcept { return load_; }
  [[nodiscard]] const ReducedResponse& response() const noexcept { return response_; }

  /// The reduced solution for these moduli, as a guess for the solver: under the prescribed strain or, with a traction
  /// boundary, under the unit traction. It is zero for an empty basis.
  [[nodiscard]] Vector approximation(std::span<const Moduli> moduli) const;
  /// The composite at a time [s] after the load was applied, per unit of the load, where the varying phases have these
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
  [[nodiscard]] Vector load_forces() const;
  [[nodiscard]] bool normalise(Vector& vector, VectorOrigin& origin) const;
  void extend(Vector candidate, std::optional<std::vector<double>> parameters);
  void extend_projection();
  void extend_residual_products();
  /// The forces K_0 u for part 0, and K_i u for part i.
  [[nodiscard]] Vector forces_of_part(Eigen::Index part, const Vector& displacement) const;
  [[nodiscard]] std::vector<Vector> forces_of_parts(Eigen::Index first, Eigen::Index end,
                                                    const Vector& displacement) const;

  const Composite* composite_;
  Load load_;
  std::vector<Moduli> reference_;
  typename Composite::BasisVectors vectors_;
  ReducedResponse response_;
};

/// Appends a row and a column of zeros to a symmetric matrix.
inline void enlarge(Eigen::MatrixXd& matrix) {
  const auto size = matrix.rows();
  matrix.conservativeResize(size + 1, size + 1);
  matrix.row(size).setZero();
  matrix.col(size).setZero();
}

/// Products of the parts of the residual, in blocks of `count` vectors for each part and then the load, with zeros for
/// the products of one more vector.
inline Eigen::MatrixXd with_room_for_a_vector(const Eigen::MatrixXd& products, Eigen::Index parts, Eigen::Index count) {
  const auto size = count + 1, load = parts * count, new_load = parts * size;
  Eigen::MatrixXd larger = Eigen::MatrixXd::Zero(new_load + 1, new_load + 1);
  if (count == 0) return larger;
  for (Eigen::Index a = 0; a < parts; ++a) {
    for (Eigen::Index b = 0; b < parts; ++b) {
      larger.block(a * size, b * size, count, count) = products.block(a * count, b * count, count, count);
    }
    larger.block(a * size, new_load, count, 1) = products.block(a * count, load, count, 1);
    larger.block(new_load, a * size, 1, count) = products.block(load, a * count, 1, count);
  }
  larger(new_load, new_load) = products(load, load);
  return larger;
}

template <AffineComposite Composite>
ReducedBasis<Composite>::ReducedBasis(const Composite& composite, Load load, std::vector<Moduli> reference)
    : composite_(&composite), load_(load), reference_(std::move(reference)), vectors_(composite.no_vectors(load)) {
  response_.load = load;
  response_.boundary = composite.boundary();
  for (const auto& parameter : composite.parameters()) response_.parts.push_back({parameter, {}});
  extend(composite.uniform_strain(load), {});
}

/// The forces e of the load, scaled by the volume V so that e' K^-1 e is a compliance [1/Pa]: the forces of the unit
/// traction over the root of V, or, where the strain is prescribed, the root of V as the macroscopic stress.
template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::load_forces() const {
  auto forces = composite_->load_forces(load_);
  const double root = std::sqrt(composite_->volume());
  forces.scale(1.0 / root);
  if (composite_->boundary() != Boundary::traction) forces.set_macroscopic(root);
  return forces;
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

/// Orthonormalises a vector against the basis (Gram-Schmidt), and adds up the subtracted amounts of the basis vectors.
/// Returns false when the vector lies in the span of the basis.
template <AffineComposite Composite>
bool ReducedBasis<Composite>::normalise(Vector& vector, VectorOrigin& origin) const {
  constexpr double nothing = 1e-13;
  double before = work(reference_forces(vector), vector);
  // "Twice is enough" for orthogonality to working precision (Giraud, Langou and Rozloznik 2005).
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd taken = -vectors_.works(reference_forces(vector));
    vectors_.add_to(vector, taken);
    const double energy = work(reference_forces(vector), vector);
    if (!(energy > nothing * before)) return false;
    vector.scale(1.0 / std::sqrt(energy));
    origin.of_earlier = (origin.of_earlier + taken) / std::sqrt(energy);
    before = 1.0;
  }
  return true;
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::add(Vector solution, std::vector<Moduli> moduli) {
  auto parameters = response_.parameters(moduli);
  response_.snapshots.push_back({std::move(moduli)});
  extend(std::move(solution), std::move(parameters));
}

/// Adds a vector unless it lies in the span of the basis.
template <AffineComposite Composite>
void ReducedBasis<Composite>::extend(Vector candidate, std::optional<std::vector<double>> parameters) {
  VectorOrigin origin{std::move(parameters), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vectors_.size()))};
  if (!normalise(candidate, origin)) return;
  vectors_.add(std::move(candidate), std::move(origin));
  extend_projection();
  extend_residual_products();
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::extend_projection() {
  auto& response = response_;
  const auto last = static_cast<Eigen::Index>(vectors_.size()) - 1;
  const auto extend = [&](Eigen::MatrixXd& projection, Eigen::Index part) {
    enlarge(projection);
    const auto works = vectors_.works(forces_of_part(part, vectors_.at(vectors_.size() - 1)));
    for (Eigen::Index i = 0; i <= last; ++i) projection(i, last) = projection(last, i) = works[i];
  };
  extend(response.constant, 0);
  Eigen::Index number = 0;
  for (auto& part : response.parts) extend(part.stiffness, ++number);
  response.load_forces.conservativeResize(last + 1);
  response.load_forces[last] = vectors_.works(load_forces())[last];
}

/// Scalar products of the parts of the residual, R_(a i)(b j) = (K_a v_i)' (K_b v_j), are extended by those of the
/// newest vector. Only a few forces are in memory at a time.
template <AffineComposite Composite>
void ReducedBasis<Composite>::extend_residual_products() {
  const auto count = static_cast<Eigen::Index>(response_.parts.size()) + 1;
  const auto last = static_cast<Eigen::Index>(vectors_.size()) - 1, load = count * (last + 1);
  auto& products = response_.residual_products;
  products = with_room_for_a_vector(products, count, last);
  const auto row = [last](Eigen::Index part, Eigen::Index vector) { return part * (last + 1) + vector; };
  const auto vector = [this](Eigen::Index i) -> decltype(auto) { return vectors_.at(static_cast<std::size_t>(i)); };

  constexpr auto at_hand = static_cast<Eigen::Index>(Composite::forces_at_hand);
  for (Eigen::Index first = 0; first < count; first += at_hand) {
    const auto end = std::min(first + at_hand, count);
    const auto of_newest = forces_of_parts(first, end, vector(last));  // K_b v, b from first to end
    const auto multiply = [&](Eigen::Index i, const Vector& forces) {
      for (auto b = first; b < end; ++b) {
        const auto j = row(b, last);
        products(i, j) = products(j, i) = product(forces, of_newest[static_cast<std::size_t>(b - first)]);
      }
    };
    for (Eigen::Index i = 0; i < last; ++i) {
      const auto& earlier = vector(i);
      for (Eigen::Index a = 0; a < count; ++a) multiply(row(a, i), forces_of_part(a, earlier));
    }
    // The products of the newest vector with itself are symmetric: products with parts before `first` are known.
    for (auto a = first; a < end; ++a) multiply(row(a, last), of_newest[static_cast<std::size_t>(a - first)]);
    for (auto a = end; a < count; ++a) multiply(row(a, last), forces_of_part(a, vector(last)));
    multiply(load, load_forces());
  }
  if (last > 0) return;
  const auto forces = load_forces();
  products(load, load) = product(forces, forces);
}

/// The forces of the parts from `first` to `end`.
template <AffineComposite Composite>
std::vector<typename Composite::Vector> ReducedBasis<Composite>::forces_of_parts(Eigen::Index first, Eigen::Index end,
                                                                                 const Vector& displacement) const {
  std::vector<Vector> forces;
  forces.reserve(static_cast<std::size_t>(end - first));
  for (auto part = first; part < end; ++part) forces.push_back(forces_of_part(part, displacement));
  return forces;
}

template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::approximation(std::span<const Moduli> moduli) const {
  if (vectors_.size() == 0) return composite_->zero();
  const Eigen::VectorXd weights = response_.stiffness(response_.parameters(moduli)).ldlt().solve(response_.load_forces);
  auto sum = combination(weights);
  // The result is scaled like a solution: with a macroscopic amplitude of 1 where the strain is prescribed, under unit
  // traction otherwise. The forces of the projection are those of load_forces().
  const bool is_strained = composite_->boundary() != Boundary::traction;
  sum.scale(is_strained ? 1.0 / sum.macroscopic() : std::sqrt(composite_->volume()));
  return sum;
}

template <AffineComposite Composite>
CompositeState<typename Composite::Vector> ReducedBasis<Composite>::state(std::span<const Material> of_phases,
                                                                          double time) const {
  const auto weights = network_state(response_, of_phases, time);
  // The forces of the basis are those of load_forces(), a unit load over the root of the volume.
  const double unit = std::sqrt(composite_->volume());
  CompositeState<Vector> state{combination(unit * weights.displacement), {}};
  for (const auto& applied : weights.applied) state.applied.push_back(combination(unit * applied));
  return state;
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::save(StateWriter& state, const std::string& group) const {
  breccia::save(state, group + "/response", response_);
  vectors_.save(state, group);
}

template <AffineComposite Composite>
void ReducedBasis<Composite>::restore(const StateReader& state, const std::string& group) {
  response_ = read_response(state, group + "/response");
  vectors_.restore(state, group, [this] { return composite_->zero(); });
}

template <AffineComposite Composite>
typename ReducedBasis<Composite>::Vector ReducedBasis<Composite>::combination(const Eigen::VectorXd& weights) const {
  auto sum = composite_->zero();
  vectors_.add_to(sum, weights);
  return sum;
}

}  // namespace breccia::quasistatic
