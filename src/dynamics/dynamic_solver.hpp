#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "breccia/discretisation/point_fields.hpp"

#include "dynamics/dynamic_problem.hpp"
#include "dynamics/instruction_set.hpp"

namespace breccia {

class StateReader;
class StateWriter;

/// Volume averages, per unit of the load.
template <int dim>
struct Averages {
  Stress<dim> stress;  ///< [Pa]
  Strain<dim> strain;  ///< mean strain from the displacement of the boundary: sym(u n) integrated over it, divided by
                       ///< the volume [-]

  friend bool operator==(const Averages&, const Averages&) = default;
};

/// Energy per squared unit of the load [J], in 2D per unit thickness [J/m].
struct Energy {
  double kinetic = 0.0;  ///< kinetic energy with the velocities at the half step
  /// Strain energy. In the total-lagrangian formulation it is half of u(n) K u(n+1), since central differences conserve
  /// the sum of this and the kinetic energy; in the classical one it is the strain energy of the points.
  double strain = 0.0;
};

/// The arrays of a run in this process [B].
struct Footprint {
  std::size_t held = 0;
  /// Traffic of a step between these arrays and the memory, if the caches hold only a few rows of the grid.
  std::size_t moved_per_step = 0;
};

/// An explicit run of the material point method: displacements at whole steps, velocities at half steps.
template <int dim>
class DynamicSolver {
 public:
  using VelocityField = std::function<Vector<dim>(const Vector<dim>& position)>;

  virtual ~DynamicSolver() = default;
  DynamicSolver(const DynamicSolver&) = delete;
  DynamicSolver& operator=(const DynamicSolver&) = delete;
  DynamicSolver(DynamicSolver&&) = delete;
  DynamicSolver& operator=(DynamicSolver&&) = delete;

  /// Takes steps and appends, for each, the averages at the time where the step begins. Throws NumericalError, with the
  /// step and the position, when the stress grows beyond that of any stable run.
  void advance(int steps, std::vector<Averages<dim>>& averages);

  /// Time where the next step begins [s], counted from the midpoint of the ramp.
  [[nodiscard]] double time() const noexcept { return time_at(step_); }
  [[nodiscard]] std::int64_t steps_taken() const noexcept { return step_; }

  /// Sets the velocities [m/s per unit load] before the first step.
  virtual void set_velocities(const VelocityField& velocity) = 0;
  [[nodiscard]] virtual Vector<dim> momentum() const = 0;  ///< [kg m/s per unit load], in 2D per unit thickness
  /// The energy of a body of elastic materials. Throws InputError for other materials.
  [[nodiscard]] virtual Energy energy() const = 0;
  /// Fields of own_cells(): at the points of square cells, or means over cubic cells (zero_timed_fields).
  [[nodiscard]] virtual LatticeFields<dim> fields() const = 0;
  [[nodiscard]] virtual Footprint footprint() const = 0;

  /// Saves all data that change during a run in a group such as "/solver". Every process must call it.
  void save(StateWriter& state, const std::string& group) const;
  /// Continues from a saved state, with any number of threads and processes. Throws FileError when the state is of
  /// another problem.
  void restore(const StateReader& state, const std::string& group);

 protected:
  /// Throws InputError when the problem is incomplete or its time step not stable, or when the traction of a load would
  /// act where the box has no points.
  explicit DynamicSolver(DynamicProblem<dim> problem);

  [[nodiscard]] const DynamicProblem<dim>& problem() const noexcept { return problem_; }
  /// Time of a step [s].
  [[nodiscard]] double time_at(std::int64_t step) const noexcept;
  /// Share of the load that has been applied at a step; 0 at step 0 even where the ramp is a jump.
  [[nodiscard]] double load_at(std::int64_t step) const noexcept;
  void require_elastic() const;

 private:
  /// Takes steps from `first` on, storing the averages where each begins.
  virtual void take_steps(std::int64_t first, int steps, Averages<dim>* averages) = 0;
  /// The position where the displacement of a step is largest or not a number [m].
  [[nodiscard]] virtual Vector<dim> most_moved() const = 0;
  virtual void save_arrays(StateWriter& state, const std::string& group) const = 0;
  virtual void restore_arrays(const StateReader& state, const std::string& group) = 0;

  [[nodiscard]] double largest_sound_stress() const;
  void require_sound(std::span<const Averages<dim>> averages) const;

  DynamicProblem<dim> problem_;
  std::int64_t step_ = 0;
};

extern template class DynamicSolver<2>;
extern template class DynamicSolver<3>;

/// The cells whose fields a solver of this formulation holds on this process.
template <int dim>
[[nodiscard]] IndexRange<dim> own_cells(Formulation formulation, const Grid<dim>& grid);

/// A solver for the problem. `threads` = 0 takes all cores of this process (parallel::threads_for); the results depend
/// neither on it nor on the instructions of the total-lagrangian formulation, which this processor must have. Throws
/// InputError when the problem is incomplete or its time step not stable. Instantiated for 2 and 3 dimensions.
template <int dim>
std::unique_ptr<DynamicSolver<dim>> make_dynamic_solver(Formulation formulation, DynamicProblem<dim> problem,
                                                        int threads = 0,
                                                        InstructionSet instructions = chosen_instruction_set());

}  // namespace breccia
