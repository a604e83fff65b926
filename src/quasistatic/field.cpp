#include "field.hpp"

namespace breccia::quasistatic {

Field Field::zero() const {
  NodalVector rest;
  check(VecDuplicate(rest_.get(), rest.put()), "making a nodal vector");
  check(VecSet(rest.get(), 0.0), "making a nodal vector");
  return {0.0, std::move(rest)};
}

Field Field::copy() const {
  auto field = zero();
  field.add(1.0, *this);
  return field;
}

void Field::add(double factor, const Field& other) {
  affine_ += factor * other.affine_;
  check(VecAXPY(rest_.get(), factor, other.rest_.get()), "adding nodal vectors");
}

void Field::scale(double factor) {
  affine_ *= factor;
  check(VecScale(rest_.get(), factor), "scaling a nodal vector");
}

void Field::set_zero() {
  affine_ = 0.0;
  check(VecSet(rest_.get(), 0.0), "clearing a nodal vector");
}

double work(const Field& forces, const Field& displacement) {
  double sum = 0.0;
  check(VecDot(forces.rest(), displacement.rest(), &sum), "a scalar product");
  return sum + forces.affine() * displacement.affine();
}

}  // namespace breccia::quasistatic
