#include "quasistatic/operator/displacement_state.hpp"

#include <cstddef>
#include <span>

#include "quasistatic/operator/natural_order.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// The values of this process.
template <class Values>
auto own(const Values& values, Vec vector) {
  PetscInt size = 0;
  check(VecGetLocalSize(vector, &size), "reading the size of a vector");
  return std::span(values.data(), static_cast<std::size_t>(size));
}

std::size_t length_of(Vec vector) {
  PetscInt length = 0;
  check(VecGetSize(vector, &length), "reading the size of a vector");
  return static_cast<std::size_t>(length);
}

void save(StateWriter& state, const std::string& name, Vec vector, const parallel::OrderedPlaces& indices) {
  state.write(name, own(ReadValues(vector), vector), indices, length_of(vector));
}

void restore(const StateReader& state, const std::string& name, Vec vector, const parallel::OrderedPlaces& indices) {
  state.read(name, own(WriteValues(vector), vector), indices, length_of(vector));
}

}  // namespace

void save(StateWriter& state, const std::string& group, const Displacement& displacement) {
  auto* const nodes = displacement.fluctuation();
  auto* const phases = displacement.phase_strains();
  state.write(group + "/affine", displacement.macroscopic());
  save(state, group + "/nodes", nodes, natural_indices_of_nodes(nodes));
  if (length_of(phases) > 0) save(state, group + "/phases", phases, natural_indices(phases));
}

void restore(const StateReader& state, const std::string& group, Displacement& displacement) {
  auto* const nodes = displacement.fluctuation();
  auto* const phases = displacement.phase_strains();
  restore(state, group + "/nodes", nodes, natural_indices_of_nodes(nodes));
  if (length_of(phases) > 0) restore(state, group + "/phases", phases, natural_indices(phases));
  displacement.set_macroscopic(state.number(group + "/affine"));
}

}  // namespace breccia::quasistatic
