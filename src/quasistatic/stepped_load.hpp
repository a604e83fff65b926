#pragma once

#include <string>
#include <vector>

#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

#include "elastic_solver.hpp"
#include "recovery.hpp"

namespace breccia::quasistatic {

/// A modulus that acts on a displacement that is linear over a step [s]: M_inf + sum_i M_i (1 - exp(-x_i)) / x_i.
[[nodiscard]] double algorithmic_modulus(const PronySeries& series, double step);

/// One modulus of one material that relaxes.
struct RelaxingModulus {
  std::vector<Moduli> unit;  ///< 1 for this modulus of this material, 0 else
  const PronySeries* series;
};

/// Of a composite. They point to the series of the materials.
[[nodiscard]] std::vector<RelaxingModulus> relaxing_moduli(const std::vector<Material>& materials);

/// The answer to one load so far. The memory of a term is a displacement, too: what its springs still hold, times their
/// modulus.
class SteppedLoad {
 public:
  SteppedLoad(const ElasticBox& box, const std::vector<Material>& materials,
              const std::vector<RelaxingModulus>& relaxing, Load load);

  /// Goes on by a time step [s], 0 for the jump at the beginning. Returns the value after it.
  double step(double time_step, const std::vector<Moduli>& algorithmic, ElasticSolver& solver);

  [[nodiscard]] const Field& displacement() const noexcept { return displacement_; }
  /// Its modulus at rest times the displacement, and what the memories of its terms hold, by material.
  [[nodiscard]] std::vector<AppliedModuli> applied_moduli() const;

  void save(StateWriter& state, const std::string& group) const;
  void restore(const StateReader& state, const std::string& group);

 private:
  template <class Self, class Visit>
  static void for_fields(Self& self, const std::string& group, const Visit& visit);
  [[nodiscard]] Field decayed_forces(std::size_t modulus, double time_step);
  void remember(double time_step);
  [[nodiscard]] std::vector<Moduli> equilibrium() const;
  [[nodiscard]] std::vector<Moduli> difference_to_equilibrium(const std::vector<Moduli>& algorithmic) const;
  [[nodiscard]] double affine_force_after(const Field& remembered, const std::vector<Moduli>& algorithmic) const;

  const ElasticBox* box_;
  const std::vector<Material>* materials_;
  const std::vector<RelaxingModulus>* relaxing_;
  Load load_;
  Field load_forces_;
  Field displacement_;
  Field increment_;
  std::vector<std::vector<Field>> memory_;  ///< by relaxing modulus and term
};

}  // namespace breccia::quasistatic
