#pragma once

#include <string>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

#include "operator/recovery.hpp"
#include "solvers/elastic_solver.hpp"

namespace breccia::quasistatic {

/// Algorithmic modulus [Pa] of a time step [s]: the modulus that acts on a displacement increment that is linear over
/// the step, M_inf + sum_i M_i (1 - exp(-x_i)) / x_i with x_i = step / relaxation time.
[[nodiscard]] double algorithmic_modulus(const PronySeries& series, double step);

/// One modulus of one material that relaxes.
struct RelaxingModulus {
  std::vector<Moduli> unit;  ///< by material: 1 for this modulus of this material, 0 for all others
  const PronySeries* series;
};

/// The relaxing moduli of a composite. They point to the series of the materials.
[[nodiscard]] std::vector<RelaxingModulus> relaxing_moduli(const std::vector<Material>& materials);

/// Integrates the response to one load through time (theory, Eq. 17). The internal variable h of a Maxwell term is a
/// nodal displacement times a modulus [Pa]: the strain that its spring still holds, times its modulus.
template <int dim>
class LogTimeIntegrator {
 public:
  LogTimeIntegrator(const ElasticOperator<dim>& elastic_operator, const std::vector<Material>& materials,
                    const std::vector<RelaxingModulus>& relaxing, Load load);

  /// Takes a time step [s], or the jump at time 0 with a step of 0. `algorithmic` holds the algorithmic moduli of the
  /// step by material, for which the solver has been prepared. Returns the mean stress [Pa], or under a traction
  /// boundary the mean strain per unit stress [1/Pa], after the step.
  double step(double time_step, const std::vector<Moduli>& algorithmic, ElasticSolver<dim>& solver);

  [[nodiscard]] const Displacement& displacement() const noexcept { return displacement_; }
  /// By material: the equilibrium moduli times the displacement, plus the internal variables of the material's terms.
  [[nodiscard]] std::vector<AppliedModuli> applied_moduli() const;

  void save(StateWriter& state, const std::string& group) const;
  void restore(const StateReader& state, const std::string& group);

 private:
  template <class Self, class Visit>
  static void for_displacements(Self& self, const std::string& group, const Visit& visit);
  [[nodiscard]] Forces decayed_forces(std::size_t modulus, double time_step);
  [[nodiscard]] Displacement solve_step(const Forces& history_forces, const std::vector<Moduli>& algorithmic,
                                        ElasticSolver<dim>& solver) const;
  void update_internal_variables(double time_step);
  [[nodiscard]] std::vector<Moduli> equilibrium() const;
  [[nodiscard]] std::vector<Moduli> difference_to_equilibrium(const std::vector<Moduli>& algorithmic) const;
  [[nodiscard]] double macroscopic_force_after(const Forces& history_forces,
                                               const std::vector<Moduli>& algorithmic) const;

  const ElasticOperator<dim>* elastic_operator_;
  const std::vector<Material>* materials_;
  const std::vector<RelaxingModulus>* relaxing_;
  Load load_;
  Forces load_forces_;
  Displacement displacement_;
  Displacement increment_;                                     ///< of the last step, the guess for the next one
  std::vector<std::vector<Displacement>> internal_variables_;  ///< h, by relaxing modulus and term
};

extern template class LogTimeIntegrator<2>;
extern template class LogTimeIntegrator<3>;

}  // namespace breccia::quasistatic
