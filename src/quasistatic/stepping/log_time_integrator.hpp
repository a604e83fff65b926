#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/viscoelasticity/prony_series.hpp"

#include "checkpoint/state.hpp"
#include "quasistatic/reduced/affine_composite.hpp"
#include "quasistatic/reduced/composite_state.hpp"

namespace breccia::quasistatic {

/// Algorithmic modulus [Pa] of a time step [s]: the modulus that acts on a displacement increment that is linear over
/// the step, M_inf + sum_i M_i (1 - exp(-x_i)) / x_i with x_i = step / relaxation time.
[[nodiscard]] double algorithmic_modulus(const PronySeries& series, double step);

/// (1 - exp(-x)) / x
[[nodiscard]] double mean_decay(double x);

/// A composite whose parts can be stepped in time.
template <class Composite>
concept SteppableComposite = AffineComposite<Composite> &&
    requires(const Composite& composite, Load load, const typename Composite::Vector& u, std::span<const double> p) {
  { composite.varying_forces(p, load, u) } -> std::same_as<typename Composite::Vector>;  // sum_i p_i K_i u
};

/// Solves for displacements under any forces on the unknowns, for one choice of the moduli p_i after the other: in a
/// time step under a load, whose unit strain or stress is prescribed. The macroscopic part of the result of
/// solve_forces() is undefined; the solver may start from the guess.
template <class Solver, class Vector>
concept StepSolver = requires(Solver& solver, std::span<const double> p, Load load, const Vector& forces,
                              Vector guess) {
  solver.take(p);
  { solver.solve_forces(load, forces, std::move(guess)) } -> std::same_as<Vector>;
};

/// Integrates the response to one load through time (theory, Eq. 17). The internal variable h of a Maxwell term is a
/// displacement times a modulus [Pa]: the remaining strain of its spring times its modulus.
template <SteppableComposite Composite>
class LogTimeIntegrator {
 public:
  using Vector = typename Composite::Vector;

  /// `series` are the relaxation moduli of the parts of the composite; both must outlive this object.
  LogTimeIntegrator(const Composite& composite, const std::vector<const PronySeries*>& series, Load load)
      : composite_(&composite),
        series_(&series),
        load_(load),
        load_forces_(composite.load_forces(load)),
        displacement_(composite.zero()),
        increment_(composite.zero()) {
    for (const auto* modulus : series) {
      auto& variables = internal_variables_.emplace_back();
      for (std::size_t i = 0; i < modulus->terms().size(); ++i) variables.push_back(composite.zero());
      equilibrium_.push_back(modulus->equilibrium());
    }
  }

  /// Takes a time step [s], or the jump at time 0 with a step of 0. `algorithmic` holds the algorithmic moduli of the
  /// step by part, which the solver has taken. Returns the mean stress [Pa], or under a traction boundary the mean
  /// strain per unit stress [1/Pa], after the step.
  template <StepSolver<Vector> Solver>
  double step(double time_step, const std::vector<double>& algorithmic, Solver& solver) {
    auto history_forces = composite_->zero();
    for (std::size_t part = 0; part < series_->size(); ++part) {
      if (!internal_variables_[part].empty()) history_forces.add(1.0, decayed_forces(part, time_step));
    }
    auto next = solve_step(history_forces, algorithmic, solver);
    increment_ = copied(next);
    increment_.add(-1.0, displacement_);
    const double macroscopic_force = macroscopic_force_after(history_forces, algorithmic);
    update_internal_variables(time_step);
    displacement_ = std::move(next);
    // The jump at time 0 gives no guess of the rate in the first step.
    if (time_step == 0.0) increment_ = composite_->zero();
    const bool is_traction = composite_->boundary() == Boundary::traction;
    return (is_traction ? work(load_forces_, displacement_) : macroscopic_force) / composite_->volume();
  }

  /// The displacement and, by part, the product of the equilibrium modulus and the displacement plus the internal
  /// variables.
  [[nodiscard]] CompositeState<Vector> state() const {
    CompositeState<Vector> state{copied(displacement_), {}};
    for (std::size_t part = 0; part < series_->size(); ++part) {
      auto& applied = state.applied.emplace_back(copied(displacement_));
      applied.scale(equilibrium_[part]);
      for (const auto& variable : internal_variables_[part]) applied.add(1.0, variable);
    }
    return state;
  }

  void save(StateWriter& state, const std::string& group) const {
    for_displacements(*this, group,
                      [&](const std::string& name, const Vector& vector) { save_vector(state, name, vector); });
  }
  void restore(const StateReader& state, const std::string& group) {
    for_displacements(*this, group,
                      [&](const std::string& name, Vector& vector) { restore_vector(state, name, vector); });
  }

 private:
  /// Visits the displacements that make up the state, with their names in a saved state.
  template <class Self, class Visit>
  static void for_displacements(Self& self, const std::string& group, const Visit& visit) {
    visit(group + "/displacement", self.displacement_);
    visit(group + "/increment", self.increment_);
    for (std::size_t part = 0; part < self.internal_variables_.size(); ++part) {
      for (std::size_t i = 0; i < self.internal_variables_[part].size(); ++i) {
        visit(fmt::format("{}/memory/{}/{}", group, part, i), self.internal_variables_[part][i]);
      }
    }
  }

  [[nodiscard]] Vector copied(const Vector& vector) const {
    auto copy = composite_->zero();
    copy.add(1.0, vector);
    return copy;
  }

  /// Lets the internal variables of a part decay over a step, and returns their forces P exp(-x) h.
  [[nodiscard]] Vector decayed_forces(std::size_t part, double time_step) {
    auto sum = composite_->zero();
    const auto& terms = (*series_)[part]->terms();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      internal_variables_[part][i].scale(std::exp(-time_step / terms[i].relaxation_time));
      sum.add(1.0, internal_variables_[part][i]);
    }
    return composite_->part_forces(part, load_, sum);
  }

  /// Solves K^ u(n+1) = f - P h + (K^ - K_inf) u(n), where a displacement or periodic boundary prescribes the
  /// macroscopic part.
  template <class Solver>
  [[nodiscard]] Vector solve_step(const Vector& history_forces, const std::vector<double>& algorithmic,
                                  Solver& solver) const {
    auto right = copied(history_forces);
    right.scale(-1.0);
    auto differences = algorithmic;
    for (std::size_t part = 0; part < differences.size(); ++part) differences[part] -= equilibrium_[part];
    right.add(1.0, composite_->varying_forces(differences, load_, displacement_));
    auto prescribed = composite_->zero();
    if (composite_->boundary() == Boundary::traction) {
      right.add(1.0, load_forces_);
    } else {
      prescribed.set_macroscopic(1.0);
      right.add(-1.0, composite_->forces(algorithmic, load_, prescribed));
    }
    auto guess = copied(displacement_);
    guess.add(1.0, increment_);
    auto next = solver.solve_forces(load_, right, std::move(guess));
    next.set_macroscopic(prescribed.macroscopic());
    return next;
  }

  void update_internal_variables(double time_step) {
    for (std::size_t part = 0; part < series_->size(); ++part) {
      const auto& terms = (*series_)[part]->terms();
      for (std::size_t i = 0; i < terms.size(); ++i) {
        internal_variables_[part][i].add(terms[i].modulus * mean_decay(time_step / terms[i].relaxation_time),
                                         increment_);
      }
    }
  }

  /// Force conjugate to the macroscopic part after a step, that is, the macroscopic part of K_inf u(n) + P h + K^
  /// (u(n+1) - u(n)).
  [[nodiscard]] double macroscopic_force_after(const Vector& history_forces,
                                               const std::vector<double>& algorithmic) const {
    return composite_->forces(equilibrium_, load_, displacement_).macroscopic() + history_forces.macroscopic() +
           composite_->forces(algorithmic, load_, increment_).macroscopic();
  }

  const Composite* composite_;
  const std::vector<const PronySeries*>* series_;  ///< series by part
  std::vector<double> equilibrium_;                ///< equilibrium moduli by part [Pa]
  Load load_;
  Vector load_forces_;
  Vector displacement_;
  Vector increment_;                                     ///< increment of the last step, the guess for the next one
  std::vector<std::vector<Vector>> internal_variables_;  ///< internal variables h, by part and term
};

}  // namespace breccia::quasistatic
