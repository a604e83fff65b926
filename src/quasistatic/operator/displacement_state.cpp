#include "operator/displacement_state.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

void save(StateWriter& state, const std::string& group, const Displacement& displacement) {
  constexpr const char* what = "collecting a nodal vector";
  state.write(group + "/affine", displacement.macroscopic());
  Vec distributed = displacement.fluctuation();
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
  state.write(group + "/nodes", std::span(values, static_cast<std::size_t>(size)));
  check(VecRestoreArrayRead(all, &values), what);
}

void restore(const StateReader& state, const std::string& group, Displacement& displacement) {
  constexpr const char* what = "restoring a nodal vector";
  Vec fluctuation = displacement.fluctuation();
  PetscInt size = 0, begin = 0, end = 0;
  check(VecGetSize(fluctuation, &size), what);
  check(VecGetOwnershipRange(fluctuation, &begin, &end), what);
  const auto all = state.numbers(group + "/nodes", static_cast<std::size_t>(size));
  double* values = nullptr;
  check(VecGetArray(fluctuation, &values), what);
  std::copy(all.begin() + begin, all.begin() + end, values);
  check(VecRestoreArray(fluctuation, &values), what);
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
