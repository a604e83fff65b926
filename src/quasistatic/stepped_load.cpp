#include "stepped_load.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

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

SteppedLoad::SteppedLoad(const ElasticBox& box, const std::vector<Material>& materials,
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

double SteppedLoad::step(double time_step, const std::vector<Moduli>& algorithmic, ElasticSolver& solver) {
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

std::vector<AppliedModuli> SteppedLoad::applied_moduli() const {
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

/// Lets the memory of a modulus decay, and returns its forces.
Field SteppedLoad::decayed_forces(std::size_t modulus, double time_step) {
  auto sum = box_->zero_field();
  const auto& [unit, series] = (*relaxing_)[modulus];
  for (std::size_t i = 0; i < series->terms().size(); ++i) {
    memory_[modulus][i].scale(std::exp(-time_step / series->terms()[i].relaxation_time));
    sum.add(1.0, memory_[modulus][i]);
  }
  return box_->forces(unit, load_, sum);
}

void SteppedLoad::remember(double time_step) {
  for (std::size_t m = 0; m < relaxing_->size(); ++m) {
    const auto& terms = (*relaxing_)[m].series->terms();
    for (std::size_t i = 0; i < terms.size(); ++i) {
      memory_[m][i].add(terms[i].modulus * mean_decay(time_step / terms[i].relaxation_time), increment_);
    }
  }
}

std::vector<Moduli> SteppedLoad::equilibrium() const {
  std::vector<Moduli> moduli;
  for (const auto& material : *materials_) {
    moduli.push_back({material.bulk.equilibrium(), material.shear.equilibrium()});
  }
  return moduli;
}

std::vector<Moduli> SteppedLoad::difference_to_equilibrium(const std::vector<Moduli>& algorithmic) const {
  auto moduli = equilibrium();
  for (std::size_t m = 0; m < moduli.size(); ++m) {
    moduli[m] = {algorithmic[m].bulk - moduli[m].bulk, algorithmic[m].shear - moduli[m].shear};
  }
  return moduli;
}

/// Force conjugate to the affine motion: K_inf u(n) + P h + K^ (u(n+1) - u(n)).
double SteppedLoad::affine_force_after(const Field& remembered, const std::vector<Moduli>& algorithmic) const {
  return box_->forces(equilibrium(), load_, displacement_).affine() + remembered.affine() +
         box_->forces(algorithmic, load_, increment_).affine();
}

/// Visits the fields of the state, with their names.
template <class Self, class Visit>
void SteppedLoad::for_fields(Self& self, const std::string& group, const Visit& visit) {
  visit(group + "/displacement", self.displacement_);
  visit(group + "/increment", self.increment_);
  for (std::size_t m = 0; m < self.memory_.size(); ++m) {
    for (std::size_t i = 0; i < self.memory_[m].size(); ++i) {
      visit(fmt::format("{}/memory/{}/{}", group, m, i), self.memory_[m][i]);
    }
  }
}

void SteppedLoad::save(StateWriter& state, const std::string& group) const {
  for_fields(*this, group, [&](const std::string& name, const Field& field) { quasistatic::save(state, name, field); });
}

void SteppedLoad::restore(const StateReader& state, const std::string& group) {
  for_fields(*this, group, [&](const std::string& name, Field& field) { quasistatic::restore(state, name, field); });
}

}  // namespace breccia::quasistatic
