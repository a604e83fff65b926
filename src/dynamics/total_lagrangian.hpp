#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "breccia/discretisation/cell_shape.hpp"
#include "breccia/dynamics/dynamic_solver.hpp"

#include "band_schedule.hpp"
#include "row_exchange.hpp"
#include "row_step.hpp"

namespace breccia::dynamics {

/// The fast formulation: RowStep has its equations, BandSchedule spreads them over threads and processes.
class TotalLagrangian final : public DynamicSolver<2> {
 public:
  TotalLagrangian(DynamicProblem<2> problem, int threads, InstructionSet instructions);

  void set_velocities(const VelocityField& velocity) override;
  [[nodiscard]] Vector<2> momentum() const override;
  [[nodiscard]] Energy energy() const override;
  [[nodiscard]] PointFields<2> fields() const override;
  [[nodiscard]] Footprint footprint() const override;

 private:
  void take_steps(std::int64_t first, int steps, Averages<2>* averages) override;
  [[nodiscard]] Vector<2> most_moved() const override;
  void save_arrays(StateWriter& state, const std::string& group) const override;
  void restore_arrays(const StateReader& state, const std::string& group) override;
  void fetch_nodes() const;
  void set_fields_of_cell(PointFields<2>& fields, const Index<2>& cell) const;

  RowExchange exchange_;
  mutable RowStep rows_;  ///< its nodes of other processes are fetched when they are asked for
  std::vector<double> masses_;
  BandSchedule schedule_;
};

}  // namespace breccia::dynamics
