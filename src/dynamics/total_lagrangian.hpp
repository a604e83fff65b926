#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "breccia/discretisation/cell.hpp"
#include "breccia/dynamics/dynamic_solver.hpp"

#include "aligned_vector.hpp"
#include "block_layout.hpp"
#include "cell_row_kernel.hpp"
#include "crew.hpp"
#include "milestone.hpp"
#include "row_exchange.hpp"

namespace breccia::dynamics {

/// The fast formulation: points never leave their cell, so velocities live on the nodes, the weights are constants and
/// masses are summed once. One sweep over the rows of cells makes a step: a row of nodes moves as soon as both rows of
/// cells around it have given their forces.
///
/// Rows are dealt to threads in bands. The row of nodes between two bands moves after both are done, from the same two
/// sums as any other row, so results do not depend on the number of threads. A band waits for those beside it alone,
/// and for the one above not before its last row of cells. Processes have bands of bands: the row of nodes between two
/// processes is moved by both, from the same sums.
///
/// Opposite nodes of a periodic box move as one: the forces at the ends of a row are added crosswise, the lowest row of
/// nodes takes the forces of the highest row of cells, too, and images are copies but for the affine motion.
class TotalLagrangian final : public DynamicSolver {
 public:
  TotalLagrangian(DynamicProblem problem, int threads, InstructionSet instructions);

  void set_velocities(const VelocityField& velocity) override;
  [[nodiscard]] Vector<2> momentum() const override;
  [[nodiscard]] Energy energy() const override;
  [[nodiscard]] PointFields fields() const override;
  [[nodiscard]] Footprint footprint() const override;

 private:
  /// A pair of components along a row of nodes.
  struct Row {
    double* x;
    double* y;
  };
  /// Storage behind RowForces.
  struct ForceRow {
    std::array<AlignedVector, 4> values;
    explicit ForceRow(std::size_t length);
    [[nodiscard]] RowForces view() noexcept;
  };
  /// A thread's rows of cells, [first, end), and its forces.
  struct Band {
    int first = 0;
    int end = 0;
    ForceRow lowest;   ///< of the first row of cells on the nodes below it
    ForceRow bottom;   ///< of the present row of cells on the nodes below it
    ForceRow top;      ///< of the present row of cells on the nodes above it
    ForceRow carried;  ///< of the row of cells below on the nodes below the present row of cells
    ForceRow highest;  ///< of the last row of cells on the nodes above it
  };
  /// How far a band is in the steps of one call.
  struct Progress {
    Milestone swept;  ///< all of its cells have given their forces
    Milestone moved;  ///< its lowest row of nodes has moved, and all above it but the highest
  };

  /// What a row of cells, and the row of nodes below it, adds to the averages.
  struct RowSums {
    std::array<double, 3> stress = {};
    PlaneStrain strain = {};
  };

  void take_steps(std::int64_t first, int steps, Averages* averages) override;
  [[nodiscard]] Vector<2> most_moved() const override;
  void save_arrays(StateWriter& state, const std::string& group) const override;
  void restore_arrays(const StateReader& state, const std::string& group) override;
  int take_turn(std::int64_t first, int most_steps, Averages* averages);
  void take_step(std::size_t first_band, std::size_t end_band, std::int64_t step, int done);
  void sweep(std::size_t place, std::int64_t step, int done);
  void take_outer_forces(int done);
  void move_lowest_row(std::size_t place, std::int64_t step, int done);
  void sum_rows(std::int64_t first, int taken, int steps, Averages* averages);
  void move_row(int row, const RowForces& from_cells_below, const RowForces& from_cells_above, std::int64_t step);
  void follow_load(int row, std::int64_t step);
  void add_traction(int row, std::int64_t step);
  void close_row(int row, std::int64_t step);
  void copy_lowest_row(std::int64_t step);
  void fetch_nodes() const;
  [[nodiscard]] PlaneStrain boundary_strain(int row) const;
  [[nodiscard]] Averages averages(std::int64_t step, int place) const;
  [[nodiscard]] RowSums& sums_of(int row, int done) noexcept {
    const int place = row * chunk_ + done % chunk_;
    return row_sums_[static_cast<std::size_t>(place)];
  }

  [[nodiscard]] Row displacement(int row) noexcept { return {field(row, 0), field(row, 1)}; }
  [[nodiscard]] Row increment(int row) noexcept { return {field(row, 2), field(row, 3)}; }
  [[nodiscard]] double* step_over_mass(int row) noexcept { return field(row, 4); }
  [[nodiscard]] double* field(int row, int which) noexcept {
    return nodes_.data() + (static_cast<std::size_t>(row) * 5 + static_cast<std::size_t>(which)) * stride_;
  }
  [[nodiscard]] const double* field(int row, int which) const noexcept {
    return nodes_.data() + (static_cast<std::size_t>(row) * 5 + static_cast<std::size_t>(which)) * stride_;
  }
  [[nodiscard]] CellVector cell_values(int column, int row, int first_field) const;

  const KernelTable* kernels_;
  std::size_t stride_;  ///< nodes a row holds, with the filling
  RowExchange exchange_;
  BlockLayout layout_;  ///< of the rows of this process
  /// Rows of displacement x, y, increment x, y, dt^2 / m. Those of other processes are fetched when they are asked for.
  mutable AlignedVector nodes_;
  std::vector<double> masses_;
  ForceRow from_below_;  ///< of the row of cells below the rows of this process; zero below the box
  ForceRow from_above_;
  std::vector<Band> bands_;
  Crew crew_{1};
  std::vector<Progress> progress_;  ///< by band
  Milestone outer_forces_;          ///< those of the neighbours of this process are here
  Milestone summed_;                ///< the rows of all bands
  int chunk_;                       ///< steps after which the sums of rows are put together
  std::vector<RowSums> row_sums_;   ///< by row of nodes, and for each the steps of a chunk
};

}  // namespace breccia::dynamics
