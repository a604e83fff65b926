// Checkpoints of a run of the total-lagrangian formulation.
#include <cstddef>

#include "breccia/parallel/ordered_values.hpp"

#include "checkpoint/state.hpp"
#include "dynamics/total_lagrangian.hpp"

namespace breccia::dynamics {

/// Number of the values of all layers of nodes of the box.
template <int dim>
std::size_t TotalLagrangian<dim>::values_of_all_nodes() const {
  const auto layers = static_cast<std::size_t>(problem().discretisation.grid().cells.back()) + 1;
  return layers * layers_.nodes().values_of_layer();
}

template <int dim>
void TotalLagrangian<dim>::save_arrays(StateWriter& state, const std::string& group) const {
  const auto& nodes = layers_.nodes();
  const auto first = static_cast<std::size_t>(exchange_.first()) * nodes.values_of_layer();
  const auto own = nodes.values(exchange_.first(), exchange_.end_of_nodes());
  state.write(group + "/nodes", own, parallel::consecutive_places(first, own.size()), values_of_all_nodes());
  const auto history = layers_.layout().history();
  const auto [indices, count] = exchange_.share_of(history.size());
  state.write(group + "/history", history, indices, count);
}

template <int dim>
void TotalLagrangian<dim>::restore_arrays(const StateReader& state, const std::string& group) {
  // A layer of nodes that several processes hold is read by each of them.
  auto& nodes = layers_.nodes();
  state.read(group + "/nodes", nodes.values(), nodes.indices(), values_of_all_nodes());
  const auto history = layers_.layout().history();
  const auto [indices, count] = exchange_.share_of(history.size());
  state.read(group + "/history", history, indices, count);
}

template std::size_t TotalLagrangian<2>::values_of_all_nodes() const;
template void TotalLagrangian<2>::save_arrays(StateWriter&, const std::string&) const;
template void TotalLagrangian<2>::restore_arrays(const StateReader&, const std::string&);
template std::size_t TotalLagrangian<3>::values_of_all_nodes() const;
template void TotalLagrangian<3>::save_arrays(StateWriter&, const std::string&) const;
template void TotalLagrangian<3>::restore_arrays(const StateReader&, const std::string&);

}  // namespace breccia::dynamics
