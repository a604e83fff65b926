#include "operator/displacement_state.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

void save(StateWriter& state, const std::string& name, Vec distributed) {
  constexpr const char* what = "collecting a nodal vector";
  NodalVector whole;
  if (parallel::ranks() > 1) {
    Scatter to_first;
    check(VecScatterCreateToZero(distributed, to_first.put(), whole.put()), what);
    check(VecScatterBegin(to_first.get(), distributed, whole.get(), INSERT_VALUES, SCATTER_FORWARD), what);
    check(VecScatterEnd(to_first.get(), distributed, whole.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  }
  Vec all = parallel::ranks() > 1 ? whole.get() : distributed;
  PetscInt size = 0;
  const double* values = nullptr;
  check(VecGetLocalSize(all, &size), what);
  check(VecGetArrayRead(all, &values), what);
  state.write(name, std::span(values, static_cast<std::size_t>(size)));
  check(VecRestoreArrayRead(all, &values), what);
}

void restore(const StateReader& state, const std::string& name, Vec distributed) {
  constexpr const char* what = "restoring a nodal vector";
  PetscInt size = 0, begin = 0, end = 0;
  check(VecGetSize(distributed, &size), what);
  check(VecGetOwnershipRange(distributed, &begin, &end), what);
  const auto all = state.numbers(name, static_cast<std::size_t>(size));
  double* values = nullptr;
  check(VecGetArray(distributed, &values), what);
  std::copy(all.begin() + begin, all.begin() + end, values);
  check(VecRestoreArray(distributed, &values), what);
}

bool is_empty(Vec vector) {
  PetscInt size = 0;
  check(VecGetSize(vector, &size), "reading the size of a vector");
  return size == 0;
}

}  // namespace

void save(StateWriter& state, const std::string& group, const Displacement& displacement) {
  state.write(group + "/affine", displacement.macroscopic());
  save(state, group + "/nodes", displacement.fluctuation());
  if (!is_empty(displacement.phase_strains())) save(state, group + "/phases", displacement.phase_strains());
}

void restore(const StateReader& state, const std::string& group, Displacement& displacement) {
  restore(state, group + "/nodes", displacement.fluctuation());
  if (!is_empty(displacement.phase_strains())) restore(state, group + "/phases", displacement.phase_strains());
  displacement.set_macroscopic(state.number(group + "/affine"));
}

void require_as_many_processes(const StateReader& state) {
  const auto before = state.integer("/processes");
  if (before == parallel::ranks()) return;
  throw InputError(fmt::format(
      "quasi-static run: it was interrupted with {} processes and can only be resumed with as many, not with {}",
      before, parallel::ranks()));
}

}  // namespace breccia::quasistatic
