#include "checkpoint/state.hpp"
#include "dynamics/dynamic_solver.hpp"

namespace breccia {

template <int dim>
void DynamicSolver<dim>::save(StateWriter& state, const std::string& group) const {
  state.write(group + "/step", step_);
  save_arrays(state, group);
}

template <int dim>
void DynamicSolver<dim>::restore(const StateReader& state, const std::string& group) {
  step_ = state.integer(group + "/step");
  restore_arrays(state, group);
}

template void DynamicSolver<2>::save(StateWriter&, const std::string&) const;
template void DynamicSolver<2>::restore(const StateReader&, const std::string&);
template void DynamicSolver<3>::save(StateWriter&, const std::string&) const;
template void DynamicSolver<3>::restore(const StateReader&, const std::string&);

}  // namespace breccia
