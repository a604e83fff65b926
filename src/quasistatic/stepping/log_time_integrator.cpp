#include "stepping/log_time_integrator.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "operator/displacement_state.hpp"

namespace breccia::quasistatic {
namespace {

/// (1 - exp(-x)) / x
double mean_decay(double x) {
  return x > 0.0 ? -std::expm1(-x) / x : 1.0;
}

}  // namespace

double algorithmic_modulus(const PronySeries& series, double step) {
  double modulus = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) modulus += strength * mean_decay(step / time);
  return modulus;
}

std::vector<RelaxingModulus> relaxing_moduli(const std::vector<Material>& materials) {
  std::vector<RelaxingModulus> relaxing;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto add = [&](const PronySeries& series, const Moduli& one) {
      if (series.is_elastic()) return;
      std::vector<Moduli> unit(materials.size(), {0.0, 0.0});
      unit[m] = one;
      relaxing.push_back({std::move(unit), &series});
    };
    add(materials[m].bulk, {.bulk = 1.0, .shear = 0.0});
    add(materials[m].shear, {.bulk = 0.0, .shear = 1.0});
  }
  return relaxing;
}

template <int dim>
LogTimeIntegrator<dim>::LogTimeIntegrator(const ElasticOperator<dim>& elastic_operator,
                                          const std::vector<Material>& materials,
                                          const std::vector<RelaxingModulus>& relaxing, Load load)
    : elastic_operator_(&elastic_operator),
      materials_(&materials),
      relaxing_(&relaxing),
      load_(load),
      load_forces_(elastic_operator.load_forces(load)),
      displacement_(elastic_operator.zero()),
      increment_(elastic_operator.zero()) {
  for (const auto& modulus : relaxing) {
    auto& variables = internal_variables_.emplace_back();
    for (std::size_t i = 0; i < modulus.series->terms().size(); ++i) variables.push_back(elastic_operator.zero());
  }
}

template <int dim>
double LogTimeIntegrator<dim>::step(double time_step, const std::vector<Moduli>& algorithmic,
                                    ElasticSolver<dim>& solver) {
  auto history_forces = elastic_operator_->zero();
  for (std::size_t m = 0; m < relaxing_->size(); ++m) history_forces.add(1.0, decayed_forces(m, time_step));
  auto next = solve_step(history_forces, algorithmic, solver);
  increment_ = next.copy();
  increment_.add(-1.0, displacement_);
  const double macroscopic_force = macroscopic_force_after(history_forces, algorithmic);
  update_internal_variables(time_step);
  displacement_ = std::move(next);
  // The jump at time 0 says nothing about the rate in the first step.
  if (time_step == 0.0) increment_.set_zero();
  const bool is_traction = elastic_operator_->boundary() == Boundary::traction;
  return (is_traction ? work(load_forces_, displacement_) : macroscopic_force) / elastic_operator_->volume();
}

/// K^ u(n+1) = f - P h + (K^ - K_inf) u(n), where a displacement or periodic boundary prescribes the macroscopic part.
template <int dim>
Displacement LogTimeIntegrator<dim>::solve_step(const Forces& history_forces, const std::vector<Moduli>& algorithmic,
                                                ElasticSolver<dim>& solver) const {
  auto right = history_forces.copy();
  right.scale(-1.0);
  right.add(1.0, elastic_operator_->forces(difference_to_equilibrium(algorithmic), load_, displacement_));
  auto prescribed = elastic_operator_->zero();
  if (elastic_operator_->boundary() == Boundary::traction) {
    right.add(1.0, load_forces_);
  } else {
    prescribed.set_macroscopic(1.0);
    right.add(-1.0, elastic_operator_->forces(algorithmic, load_, prescribed));
  }
  auto next = displacement_.copy();
  next.add(1.0, increment_);
  solver.solve(right, next);
  next.set_macroscopic(prescribed.macroscopic());
  return next;
}

template <int dim>
std::vector<AppliedModuli> LogTimeIntegrator<dim>::applied_moduli() const {
  std::vector<AppliedModuli> applied;
  for (const auto& [bulk, shear] : equilibrium()) {
    applied.push_back({displacement_.copy(), displacement_.copy()});
    applied.back().bulk.scale(bulk);
    applied.back().shear.scale(shear);
  }
  for (std::size_t r = 0; r < relaxing_->size(); ++r) {
    for (std::size_t m = 0; m < applied.size(); ++m) {
      const auto& [bulk, shear] = (*relaxing_)[r].unit[m];
      for (const auto& variable : internal_variables_[r]) {
        if (bulk > 0.0) applied[m].bulk.add(bulk, variable);
        if (shear > 0.0) applied[m].shear.add(shear, variable);
      }
    }
  }
  return applied;
}

/// Lets the internal variables of a modulus decay over a step, and returns their forces P exp(-x) h.
template <int dim>
Forces LogTimeIntegrator<dim>::decayed_forces(std::size_t modulus, double time_step) {
  auto sum = elastic_operator_->zero();
  const auto& [unit, series] = (*relaxing_)[modulus];
  for (std::size_t i = 0; i < series->terms().size(); ++i) {
    internal_variables_[modulus][i].scale(std::exp(-time_step / series->terms()[i].relaxation_time));
    sum.add(1.0, internal_variables_[modulus][i]);
  }
  return elastic_operator_->forces(unit, load_, sum);
}

template <int dim>
void LogTimeIntegrator<dim>::update_internal_variables(double time_step) {
  for (std::size_t m = 0; m < relaxing_->size(); ++m) {
    const auto& terms = (*relaxing_)[m].series->terms();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      internal_variables_[m][i].add(terms[i].modulus * mean_decay(time_step / terms[i].relaxation_time), increment_);
    }
  }
}

template <int dim>
std::vector<Moduli> LogTimeIntegrator<dim>::equilibrium() const {
  std::vector<Moduli> moduli;
  for (const auto& material : *materials_) {
    moduli.push_back({material.bulk.equilibrium(), material.shear.equilibrium()});
  }
  return moduli;
}

template <int dim>
std::vector<Moduli> LogTimeIntegrator<dim>::difference_to_equilibrium(const std::vector<Moduli>& algorithmic) const {
  auto moduli = equilibrium();
  for (std::size_t m = 0; m < moduli.size(); ++m) {
    moduli[m] = {algorithmic[m].bulk - moduli[m].bulk, algorithmic[m].shear - moduli[m].shear};
  }
  return moduli;
}

/// Force conjugate to the macroscopic part after a step: that part of K_inf u(n) + P h + K^ (u(n+1) - u(n)).
template <int dim>
double LogTimeIntegrator<dim>::macroscopic_force_after(const Forces& history_forces,
                                                       const std::vector<Moduli>& algorithmic) const {
  return elastic_operator_->forces(equilibrium(), load_, displacement_).macroscopic() + history_forces.macroscopic() +
         elastic_operator_->forces(algorithmic, load_, increment_).macroscopic();
}

/// Visits the displacements that make the state, with their names in it.
template <int dim>
template <class Self, class Visit>
void LogTimeIntegrator<dim>::for_displacements(Self& self, const std::string& group, const Visit& visit) {
  visit(group + "/displacement", self.displacement_);
  visit(group + "/increment", self.increment_);
  for (std::size_t m = 0; m < self.internal_variables_.size(); ++m) {
    for (std::size_t i = 0; i < self.internal_variables_[m].size(); ++i) {
      visit(fmt::format("{}/memory/{}/{}", group, m, i), self.internal_variables_[m][i]);
    }
  }
}

template <int dim>
void LogTimeIntegrator<dim>::save(StateWriter& state, const std::string& group) const {
  for_displacements(*this, group, [&](const std::string& name, const Displacement& displacement) {
    quasistatic::save(state, name, displacement);
  });
}

template <int dim>
void LogTimeIntegrator<dim>::restore(const StateReader& state, const std::string& group) {
  for_displacements(*this, group, [&](const std::string& name, Displacement& displacement) {
    quasistatic::restore(state, name, displacement);
  });
}

template class LogTimeIntegrator<2>;
template class LogTimeIntegrator<3>;

}  // namespace breccia::quasistatic
