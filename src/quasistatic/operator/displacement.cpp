#include "operator/displacement.hpp"

namespace breccia::quasistatic {

Displacement Displacement::zero() const {
  NodalVector fluctuation;
  check(VecDuplicate(fluctuation_.get(), fluctuation.put()), "making a nodal vector");
  check(VecSet(fluctuation.get(), 0.0), "making a nodal vector");
  return {0.0, std::move(fluctuation)};
}

Displacement Displacement::copy() const {
  auto displacement = zero();
  displacement.add(1.0, *this);
  return displacement;
}

void Displacement::add(double factor, const Displacement& other) {
  macroscopic_ += factor * other.macroscopic_;
  check(VecAXPY(fluctuation_.get(), factor, other.fluctuation_.get()), "adding nodal vectors");
}

void Displacement::scale(double factor) {
  macroscopic_ *= factor;
  check(VecScale(fluctuation_.get(), factor), "scaling a nodal vector");
}

void Displacement::set_zero() {
  macroscopic_ = 0.0;
  check(VecSet(fluctuation_.get(), 0.0), "clearing a nodal vector");
}

double work(const Forces& forces, const Displacement& displacement) {
  double sum = 0.0;
  check(VecDot(forces.fluctuation(), displacement.fluctuation(), &sum), "a scalar product");
  return sum + forces.macroscopic() * displacement.macroscopic();
}

}  // namespace breccia::quasistatic
