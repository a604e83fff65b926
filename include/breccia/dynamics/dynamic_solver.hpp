#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/point_fields.hpp"
#include "breccia/dynamics/dynamic_problem.hpp"
#include "breccia/dynamics/instruction_set.hpp"

namespace breccia {

/// Volume averages, per unit of the load.
struct Averages {
  PlaneStress stress;  ///< [Pa]
  PlaneStrain strain;  ///< that of the boundary's displacement, sym(u n) integrated over it and divided by the area [-]

  friend bool operator==(const Averages&, const Averages&) = default;
};

/// Energy per unit thickness [J/m] and per squared unit of the load.
struct Energy {
  double kinetic = 0.0;  ///< with the velocities at the half step
  /// total-lagrangian: half of u(n) K u(n+1), whose sum with the kinetic energy is what central differences conserve;
  /// classical: that of the points.
  double strain = 0.0;
};

/// The arrays of a run in this process [B].
struct Footprint {
  std::size_t held = 0;
  /// What a step reads and writes of them where the caches hold some rows of the grid and no more.
  std::size_t moved_per_step = 0;
};

/// An explicit run of the material point method: displacements at whole steps, velocities at half steps.
class DynamicSolver {
 public:
  using VelocityField = std::function<Vector<2>(const Vector<2>& position)>;

  virtual ~DynamicSolver() = default;
  DynamicSolver(const DynamicSolver&) = delete;
  DynamicSolver& operator=(const DynamicSolver&) = delete;
  DynamicSolver(DynamicSolver&&) = delete;
  DynamicSolver& operator=(DynamicSolver&&) = delete;

  /// Takes steps and appends, for each, the averages at the time where the step begins.
  /// Throws NumericalError when the stress grows beyond any that a stable run has, with the step and the place.
  void advance(int steps, std::vector<Averages>& averages);

  /// Time where the next step begins [s], counted from the midpoint of the ramp.
  [[nodiscard]] double time() const noexcept { return time_at(step_); }
  [[nodiscard]] std::int64_t steps_taken() const noexcept { return step_; }

  /// Sets the velocities [m/s per unit load] before the first step.
  virtual void set_velocities(const VelocityField& velocity) = 0;
  [[nodiscard]] virtual Vector<2> momentum() const = 0;  ///< [kg/s per unit thickness]
  /// Only for elastic materials. Throws InputError otherwise.
  [[nodiscard]] virtual Energy energy() const = 0;
  [[nodiscard]] virtual PointFields fields() const = 0;
  [[nodiscard]] virtual Footprint footprint() const = 0;

  /// Leaves all that changes during a run in a group such as "/solver". Every process must call it.
  void save(StateWriter& state, const std::string& group) const;
  /// Goes on from there, with as many threads and processes as there are now. Throws FileError when the state is of
  /// another problem.
  void restore(const StateReader& state, const std::string& group);

 protected:
  /// Throws InputError when the problem is incomplete or its time step not stable, or when the traction of a load would
  /// act where the box has no points.
  explicit DynamicSolver(DynamicProblem problem);

  [[nodiscard]] const DynamicProblem& problem() const noexcept { return problem_; }
  /// Time of a step [s].
  [[nodiscard]] double time_at(std::int64_t step) const noexcept;
  /// Share of the load that has been applied at a step; nothing at step 0 even where the ramp is a jump.
  [[nodiscard]] double load_at(std::int64_t step) const noexcept;
  void require_elastic() const;

 private:
  /// Takes steps from `first` on, storing the averages where each begins.
  virtual void take_steps(std::int64_t first, int steps, Averages* averages) = 0;
  /// Where the displacement of a step is largest or no number at all [m].
  [[nodiscard]] virtual Vector<2> most_moved() const = 0;
  virtual void save_arrays(StateWriter& state, const std::string& group) const = 0;
  virtual void restore_arrays(const StateReader& state, const std::string& group) = 0;

  [[nodiscard]] double largest_sound_stress() const;
  void require_sound(std::span<const Averages> averages) const;

  DynamicProblem problem_;
  std::int64_t step_ = 0;
};

/// A solver for the problem. `threads` = 0 takes all that OpenMP offers; the results depend neither on it nor on the
/// instructions of the total-lagrangian formulation, which this processor must have.
/// Throws InputError when the problem is incomplete or its time step not stable.
std::unique_ptr<DynamicSolver> make_dynamic_solver(Formulation formulation, DynamicProblem problem, int threads = 0,
                                                   InstructionSet instructions = chosen_instruction_set());

}  // namespace breccia
