#pragma once

#include <string>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

#include "elastic_box.hpp"

namespace breccia::quasistatic {

/// Moduli by material that show the three parts of the stiffness A + G B + K C.
struct StiffnessParts {
  std::vector<Moduli> filler;        ///< A: the matrix has no stiffness
  std::vector<Moduli> matrix_shear;  ///< B: nothing but a unit shear modulus of the matrix
  std::vector<Moduli> matrix_bulk;   ///< C

  /// A + G B + K C
  [[nodiscard]] std::vector<Moduli> with(const Moduli& matrix) const;
};

/// The uniform strain of a load and solutions under it, orthonormal in the energy of a reference matrix, and the
/// projection of the stiffness on them. With the uniform strain among them the mean stress of a combination that is in
/// balance with all of them is exactly the one that its modulus tells.
///
/// Keeps the vectors alone: their forces are cheaper to work out again than to store.
class ReducedBasis {
 public:
  ReducedBasis(const ElasticBox& box, const StiffnessParts& parts, Load load, const Moduli& reference);

  [[nodiscard]] Load load() const noexcept { return load_; }
  [[nodiscard]] const Field& load_forces() const noexcept { return load_forces_; }
  [[nodiscard]] const ReducedResponse& response() const noexcept { return response_; }

  /// Displacement that the basis holds for best; zero when it is empty.
  [[nodiscard]] Field approximation(const Moduli& matrix) const;
  /// The sum of the vectors with these weights.
  [[nodiscard]] Field combination(const Eigen::VectorXd& weights) const;
  /// Adds a solution for these moduli. One that the basis holds already, as in a box of one material, leaves it as it
  /// is.
  void add(Field solution, const Moduli& matrix);

  void save(StateWriter& state, const std::string& group) const;
  void restore(const StateReader& state, const std::string& group);

 private:
  [[nodiscard]] Field reference_forces(const Field& displacement) const;
  [[nodiscard]] bool normalise(Field& vector) const;
  void extend(Field candidate);
  void extend_projection();
  void extend_residual_products();

  const ElasticBox* box_;
  const StiffnessParts* parts_;
  Load load_;
  Moduli reference_;
  Field load_forces_;
  std::vector<Field> vectors_;
  ReducedResponse response_;
};

}  // namespace breccia::quasistatic
