#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "dynamics/band_schedule.hpp"
#include "dynamics/dynamic_solver.hpp"
#include "dynamics/layer_exchange.hpp"
#include "dynamics/layer_step.hpp"
#include "dynamics/nodal_diagnostics.hpp"

namespace breccia::dynamics {

/// The total-lagrangian formulation, which is the faster one: LayerStep has its equations, and BandSchedule spreads
/// them over threads and processes.
template <int dim>
class TotalLagrangian final : public DynamicSolver<dim> {
 public:
  using typename DynamicSolver<dim>::VelocityField;

  TotalLagrangian(DynamicProblem<dim> problem, int threads, InstructionSet instructions);

  void set_velocities(const VelocityField& velocity) override;
  [[nodiscard]] Vector<dim> momentum() const override;
  [[nodiscard]] Energy energy() const override;
  [[nodiscard]] LatticeFields<dim> fields() const override;
  [[nodiscard]] Footprint footprint() const override;

 private:
  using DynamicSolver<dim>::problem;
  using DynamicSolver<dim>::require_elastic;

  void take_steps(std::int64_t first, int steps, Averages<dim>* averages) override;
  [[nodiscard]] Vector<dim> most_moved() const override;
  void save_arrays(StateWriter& state, const std::string& group) const override;
  void restore_arrays(const StateReader& state, const std::string& group) override;
  [[nodiscard]] OwnNodes<dim> own_nodes() const noexcept;
  [[nodiscard]] std::size_t values_of_all_nodes() const;

  LayerExchange<dim> exchange_;
  LayerStep<dim> layers_;
  BandSchedule<dim> schedule_;
};

extern template class TotalLagrangian<2>;
extern template class TotalLagrangian<3>;

}  // namespace breccia::dynamics
