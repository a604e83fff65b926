#pragma once

#include <span>
#include <string>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/quasistatic/reduced_response.hpp"

#include "operator/elastic_operator.hpp"
#include "reduced/affine_stiffness.hpp"

namespace breccia::quasistatic {

/// The reduced basis of one load, and the Galerkin projection of the stiffness on it. Its vectors are the uniform
/// strain of the load and the solutions for the moduli of the snapshots, orthonormal in the energy of a composite of
/// reference moduli. Moduli [Pa] are those of the phases that vary, in the order of ReducedResponse::phases(). Since
/// the uniform strain is one of the vectors, the mean stress of the reduced solution is exactly the one that follows
/// from its energy.
///
/// The forces of the vectors are not stored: computing them again is cheap.
class ReducedBasis {
 public:
  ReducedBasis(const ElasticOperator<2>& elastic_operator, const AffineStiffness& stiffness, Load load,
               std::vector<Moduli> reference);

  [[nodiscard]] Load load() const noexcept { return load_; }
  [[nodiscard]] const Forces& load_forces() const noexcept { return load_forces_; }
  [[nodiscard]] const ReducedResponse& response() const noexcept { return response_; }

  /// The reduced solution for these moduli, a guess for the solver: under the prescribed strain or,
  /// under a traction boundary, under the unit traction. Zero for an empty basis.
  [[nodiscard]] Displacement approximation(std::span<const Moduli> moduli) const;
  /// Linear combination of the vectors with these weights.
  [[nodiscard]] Displacement combination(const Eigen::VectorXd& weights) const;
  /// Adds the solution for these moduli. A solution in the span of the vectors, as in a box of one
  /// material, adds no vector.
  void add(Displacement solution, std::vector<Moduli> moduli);

  void save(StateWriter& state, const std::string& group) const;
  void restore(const StateReader& state, const std::string& group);

 private:
  [[nodiscard]] Forces reference_forces(const Displacement& displacement) const;
  [[nodiscard]] bool normalise(Displacement& vector) const;
  void extend(Displacement candidate);
  void extend_projection();
  void extend_residual_products();

  const ElasticOperator<2>* elastic_operator_;
  const AffineStiffness* stiffness_;
  Load load_;
  std::vector<Moduli> reference_;
  Forces load_forces_;
  std::vector<Displacement> vectors_;
  ReducedResponse response_;
};

}  // namespace breccia::quasistatic
