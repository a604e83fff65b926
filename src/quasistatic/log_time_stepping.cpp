#include "breccia/quasistatic/log_time_stepping.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "elastic_solver.hpp"
#include "recovery.hpp"

namespace breccia {
namespace {

using quasistatic::AppliedModuli;
using quasistatic::ElasticBox;
using quasistatic::ElasticSolver;
using quasistatic::Field;

/// (1 - exp(-x)) / x
double mean_decay(double x) {
  return x > 0.0 ? -std::expm1(-x) / x : 1.0;
}

/// A modulus that acts on a displacement that is linear over a step: M_inf + sum_i M_i (1 - exp(-x_i)) / x_i.
double algorithmic_modulus(const PronySeries& series, double step) {
  double modulus = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) modulus += strength * mean_decay(step / time);
  return modulus;
}

/// One modulus of one material that relaxes.
struct RelaxingModulus {
  std::vector<Moduli> unit;  ///< 1 for this modulus of this material, 0 else
  const PronySeries* series;
};

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

/// The answer to one load so far. The memory of a term is a displacement, too: what its springs still hold, times their
/// modulus.
class SteppedLoad {
 public:
  SteppedLoad(const ElasticBox& box, const std::vector<Material>& materials,
              const std::vector<RelaxingModulus>& relaxing, Load load)
      : box_(&box),
        materials_(&materials),
        relaxing_(&relaxing),
        load_(load),
        load_forces_(box.load_forces(load)),
        displacement_(box.zero_field()),
        increment_(box.zero_field()) {
    for (const auto& modulus : relaxing) {
      auto& memory = memory_.emplace_back();
      for (std::size_t i = 0; i < modulus.series->terms().size(); ++i) memory.push_back(box.zero_field());
    }
  }

  /// Goes on by a time step [s], 0 for the jump at the beginning. Returns the value after it.
  double step(double time_step, const std::vector<Moduli>& algorithmic, ElasticSolver& solver) {
    // K^ u(n+1) = f - P h + (K^ - K_inf) u(n), of which a displacement boundary gives the affine part.
    auto remembered = box_->zero_field();
    for (std::size_t m = 0; m < relaxing_->size(); ++m) remembered.add(1.0, decayed_forces(m, time_step));
    auto right = remembered.copy();
    right.scale(-1.0);
    right.add(1.0, box_->forces(difference_to_equilibrium(algorithmic), load_, displacement_));
    auto given = box_->zero_field();
    if (box_->boundary() == Boundary::traction) {
      right.add(1.0, load_forces_);
    } else {
      given.set_affine(1.0);
      right.add(-1.0, box_->forces(algorithmic, load_, given));
    }
    auto next = displacement_.copy();
    next.add(1.0, increment_);
    solver.solve(right, next);
    next.set_affine(given.affine());

    increment_ = next.copy();
    increment_.add(-1.0, displacement_);
    const double affine_force = affine_force_after(remembered, algorithmic);
    remember(time_step);
    displacement_ = std::move(next);
    // The jump is no rate that would go on.
    if (time_step == 0.0) increment_.set_zero();
    return (box_->boundary() == Boundary::traction ? work(load_forces_, displacement_) : affine_force) / box_->area();
  }

  [[nodiscard]] const Field& displacement() const noexcept { return displacement_; }

  /// Its modulus at rest times the displacement, and what the memories of its terms hold, by material.
  [[nodiscard]] std::vector<AppliedModuli> applied_moduli() const {
    std::vector<AppliedModuli> applied;
    for (const auto& [bulk, shear] : equilibrium()) {
      applied.push_back({displacement_.copy(), displacement_.copy()});
      applied.back().bulk.scale(bulk);
      applied.back().shear.scale(shear);
    }
    for (std::size_t r = 0; r < relaxing_->size(); ++r) {
      for (std::size_t m = 0; m < applied.size(); ++m) {
        const auto& [bulk, shear] = (*relaxing_)[r].unit[m];
        for (const auto& memory : memory_[r]) {
          if (bulk > 0.0) applied[m].bulk.add(bulk, memory);
          if (shear > 0.0) applied[m].shear.add(shear, memory);
        }
      }
    }
    return applied;
  }

 private:
  /// Lets the memory of a modulus decay, and returns its forces.
  Field decayed_forces(std::size_t modulus, double time_step) {
    auto sum = box_->zero_field();
    const auto& [unit, series] = (*relaxing_)[modulus];
    for (std::size_t i = 0; i < series->terms().size(); ++i) {
      memory_[modulus][i].scale(std::exp(-time_step / series->terms()[i].relaxation_time));
      sum.add(1.0, memory_[modulus][i]);
    }
    return box_->forces(unit, load_, sum);
  }

  void remember(double time_step) {
    for (std::size_t m = 0; m < relaxing_->size(); ++m) {
      const auto& terms = (*relaxing_)[m].series->terms();
      for (std::size_t i = 0; i < terms.size(); ++i) {
        memory_[m][i].add(terms[i].modulus * mean_decay(time_step / terms[i].relaxation_time), increment_);
      }
    }
  }

  [[nodiscard]] std::vector<Moduli> equilibrium() const {
    std::vector<Moduli> moduli;
    for (const auto& material : *materials_) {
      moduli.push_back({material.bulk.equilibrium(), material.shear.equilibrium()});
    }
    return moduli;
  }

  [[nodiscard]] std::vector<Moduli> difference_to_equilibrium(const std::vector<Moduli>& algorithmic) const {
    auto moduli = equilibrium();
    for (std::size_t m = 0; m < moduli.size(); ++m) {
      moduli[m] = {algorithmic[m].bulk - moduli[m].bulk, algorithmic[m].shear - moduli[m].shear};
    }
    return moduli;
  }

  /// Force conjugate to the affine motion: K_inf u(n) + P h + K^ (u(n+1) - u(n)).
  [[nodiscard]] double affine_force_after(const Field& remembered, const std::vector<Moduli>& algorithmic) const {
    return box_->forces(equilibrium(), load_, displacement_).affine() + remembered.affine() +
           box_->forces(algorithmic, load_, increment_).affine();
  }

  const ElasticBox* box_;
  const std::vector<Material>* materials_;
  const std::vector<RelaxingModulus>* relaxing_;
  Load load_;
  Field load_forces_;
  Field displacement_;
  Field increment_;
  std::vector<std::vector<Field>> memory_;  ///< by relaxing modulus and term
};

/// Told the time that has been reached, and the answer to the first load.
using StepObserver = std::function<void(double time, const SteppedLoad& first)>;

/// Values by load: first those right after the jump, then at the times.
std::vector<std::vector<double>> run(const QuasistaticProblem& problem, const ElasticBox& box,
                                     std::span<const Load> loads, std::span<const double> times, ElasticSolver& solver,
                                     const ShareObserver& observer, const StepObserver& after_step) {
  const auto relaxing = relaxing_moduli(problem.materials);
  std::vector<SteppedLoad> stepped;
  for (const auto load : loads) stepped.emplace_back(box, problem.materials, relaxing, load);
  std::vector<std::vector<double>> values(loads.size());
  const auto step_all = [&](double time_step) {
    std::vector<Moduli> algorithmic;
    for (const auto& material : problem.materials) {
      algorithmic.push_back(
          {algorithmic_modulus(material.bulk, time_step), algorithmic_modulus(material.shear, time_step)});
    }
    solver.set_moduli(algorithmic);
    for (std::size_t i = 0; i < loads.size(); ++i) {
      values[i].push_back(stepped[i].step(time_step, algorithmic, solver));
    }
  };
  step_all(0.0);
  double time = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    step_all(times[i] - time);
    time = times[i];
    after_step(time, stepped.front());
    if (observer) observer(static_cast<double>(i + 1) / static_cast<double>(times.size()));
  }
  return values;
}

/// Every other time, and the last one.
std::vector<std::size_t> every_other(std::size_t count) {
  std::vector<std::size_t> coarse;
  for (std::size_t i = 1; i < count; i += 2) coarse.push_back(i);
  if (count % 2 == 1) coarse.push_back(count - 1);
  return coarse;
}

/// Of second order: the error of the fine run is a third of the difference to the coarse one. Times between two of the
/// coarse run take the larger of the two estimates.
std::vector<double> error_estimates(const std::vector<double>& fine, const std::vector<double>& coarse,
                                    const std::vector<std::size_t>& places) {
  std::vector<double> errors(fine.size(), 0.0);
  for (std::size_t c = 0; c < places.size(); ++c) {
    const double error = std::abs(coarse[c] / fine[places[c]] - 1.0) / 3.0;
    const std::size_t before = c == 0 ? 0 : places[c - 1] + 1;
    const std::size_t behind = c + 1 == places.size() ? fine.size() : places[c + 1];
    for (std::size_t i = before; i < behind; ++i) errors[i] = std::max(errors[i], error);
  }
  return errors;
}

void require_complete(const QuasistaticProblem& problem, std::span<const double> times) {
  if (times.empty() || !(times.front() > 0.0) || !std::is_sorted(times.begin(), times.end())) {
    throw InputError("log-time stepping: expected rising positive times");
  }
  for (const auto& cell : problem.discretisation.cells()) {
    for (const auto material : cell) {
      if (material == no_material || material < problem.materials.size()) continue;
      throw InputError(
          fmt::format("log-time stepping: a point has material {} of {}", material, problem.materials.size()));
    }
  }
}

}  // namespace

SteppingResult run_log_time_stepping(const QuasistaticProblem& problem, std::span<const Load> loads,
                                     std::span<const double> times, const ShareObserver& observer,
                                     std::span<const double> field_times) {
  require_complete(problem, times);
  const ElasticBox box(problem.discretisation, problem.volumetric, problem.boundary);
  const auto solver = quasistatic::make_elastic_solver(box, problem.linear);
  SteppingResult result;
  const auto keep_fields = [&](double time, const SteppedLoad& first) {
    if (std::find(field_times.begin(), field_times.end(), time) == field_times.end()) return;
    result.fields.push_back({time, recover_fields(box, problem.discretisation, problem.volumetric, loads.front(),
                                                  first.displacement(), first.applied_moduli())});
  };
  constexpr double share_of_fine = 2.0 / 3.0;
  const auto fine = run(
      problem, box, loads, times, *solver,
      [&](double share) {
        if (observer) observer(share_of_fine * share);
      },
      keep_fields);
  const auto places = every_other(times.size());
  std::vector<double> coarse_times;
  coarse_times.reserve(places.size());
  for (const auto place : places) coarse_times.push_back(times[place]);
  const auto coarse = run(
      problem, box, loads, coarse_times, *solver,
      [&](double share) {
        if (observer) observer(share_of_fine + (1.0 - share_of_fine) * share);
      },
      [](double, const SteppedLoad&) {});

  result.effort = solver->effort();
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const std::vector<double> values(fine[l].begin() + 1, fine[l].end());
    const std::vector<double> coarse_values(coarse[l].begin() + 1, coarse[l].end());
    result.responses.push_back({loads[l], fine[l].front(), values, error_estimates(values, coarse_values, places)});
  }
  return result;
}

}  // namespace breccia
