#include "operator/displacement_state.hpp"

#include <cstddef>
#include <span>

#include "operator/natural_order.hpp"
#include "operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// The values of a process that has them all, as they are.
std::span<const double> whole(const ReadValues& values, Vec vector) {
  PetscInt size = 0;
  check(VecGetLocalSize(vector, &size), "reading the size of a vector");
  return {values.data(), static_cast<std::size_t>(size)};
}

std::size_t length_of(Vec vector) {
  PetscInt length = 0;
  check(VecGetSize(vector, &length), "reading the size of a vector");
  return static_cast<std::size_t>(length);
}

}  // namespace

void save(StateWriter& state, const std::string& group, const Displacement& displacement) {
  state.write(group + "/affine", displacement.macroscopic());
  const Vec nodes = displacement.fluctuation(), phases = displacement.phase_strains();
  if (parallel::ranks() == 1) {
    state.write(group + "/nodes", whole(ReadValues(nodes), nodes));
    if (length_of(phases) > 0) state.write(group + "/phases", whole(ReadValues(phases), phases));
    return;
  }
  state.write(group + "/nodes", nodes_in_natural_order(nodes));
  if (length_of(phases) > 0) state.write(group + "/phases", places_in_natural_order(phases));
}

void restore(const StateReader& state, const std::string& group, Displacement& displacement) {
  const Vec nodes = displacement.fluctuation(), phases = displacement.phase_strains();
  set_nodes(state.numbers(group + "/nodes", length_of(nodes)), nodes);
  if (length_of(phases) > 0) set_places(state.numbers(group + "/phases", length_of(phases)), phases);
  displacement.set_macroscopic(state.number(group + "/affine"));
}

}  // namespace breccia::quasistatic
