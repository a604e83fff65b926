#include "field.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include "breccia/error.hpp"

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

void save(StateWriter& state, const std::string& group, const Field& field) {
  constexpr const char* what = "collecting a nodal vector";
  state.write(group + "/affine", field.affine());
  NodalVector whole;
  if (parallel::ranks() > 1) {
    Scatter to_first;
    check(VecScatterCreateToZero(field.rest(), to_first.put(), whole.put()), what);
    check(VecScatterBegin(to_first.get(), field.rest(), whole.get(), INSERT_VALUES, SCATTER_FORWARD), what);
    check(VecScatterEnd(to_first.get(), field.rest(), whole.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  }
  Vec all = parallel::ranks() > 1 ? whole.get() : field.rest();
  PetscInt size = 0;
  const double* values = nullptr;
  check(VecGetLocalSize(all, &size), what);
  check(VecGetArrayRead(all, &values), what);
  state.write(group + "/nodes", std::span(values, static_cast<std::size_t>(size)));
  check(VecRestoreArrayRead(all, &values), what);
}

void restore(const StateReader& state, const std::string& group, Field& field) {
  constexpr const char* what = "restoring a nodal vector";
  PetscInt size = 0, begin = 0, end = 0;
  check(VecGetSize(field.rest(), &size), what);
  check(VecGetOwnershipRange(field.rest(), &begin, &end), what);
  const auto all = state.numbers(group + "/nodes", static_cast<std::size_t>(size));
  double* values = nullptr;
  check(VecGetArray(field.rest(), &values), what);
  std::copy(all.begin() + begin, all.begin() + end, values);
  check(VecRestoreArray(field.rest(), &values), what);
  field.set_affine(state.number(group + "/affine"));
}

void require_as_many_processes(const StateReader& state) {
  const auto before = state.integer("/processes");
  if (before == parallel::ranks()) return;
  throw InputError(
      fmt::format("quasi-static run: it was interrupted with {} processes, and goes on with as many, not with {}",
                  before, parallel::ranks()));
}

double work(const Field& forces, const Field& displacement) {
  double sum = 0.0;
  check(VecDot(forces.rest(), displacement.rest(), &sum), "a scalar product");
  return sum + forces.affine() * displacement.affine();
}

}  // namespace breccia::quasistatic
