#include "quasistatic/operator/displacement.hpp"

namespace breccia::quasistatic {

namespace {

/// A vector of zeros, distributed like another one.
NodalVector zeros_like(Vec other) {
  NodalVector zeros;
  check(VecDuplicate(other, zeros.put()), "making a nodal vector");
  check(VecSet(zeros.get(), 0.0), "making a nodal vector");
  return zeros;
}

}  // namespace

Displacement Displacement::zero() const {
  return {0.0, zeros_like(fluctuation_.get()), zeros_like(phase_strains_.get())};
}

Displacement Displacement::copy() const {
  auto displacement = zero();
  displacement.add(1.0, *this);
  return displacement;
}

void Displacement::add(double factor, const Displacement& other) {
  macroscopic_ += factor * other.macroscopic_;
  check(VecAXPY(fluctuation_.get(), factor, other.fluctuation_.get()), "adding nodal vectors");
  check(VecAXPY(phase_strains_.get(), factor, other.phase_strains_.get()), "adding strains of phases");
}

void Displacement::scale(double factor) {
  macroscopic_ *= factor;
  check(VecScale(fluctuation_.get(), factor), "scaling a nodal vector");
  check(VecScale(phase_strains_.get(), factor), "scaling strains of phases");
}

void Displacement::set_zero() {
  macroscopic_ = 0.0;
  check(VecSet(fluctuation_.get(), 0.0), "clearing a nodal vector");
  check(VecSet(phase_strains_.get(), 0.0), "clearing strains of phases");
}

double product(const Forces& a, const Forces& b) {
  double of_nodes = 0.0, of_phases = 0.0;
  check(VecDot(a.fluctuation(), b.fluctuation(), &of_nodes), "a scalar product");
  check(VecDot(a.phase_strains(), b.phase_strains(), &of_phases), "a scalar product");
  return of_nodes + of_phases;
}

double work(const Forces& forces, const Displacement& displacement) {
  return product(forces, displacement) + forces.macroscopic() * displacement.macroscopic();
}

}  // namespace breccia::quasistatic
