#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "breccia/discretisation/tensor.hpp"

#include "dynamics/cell_row_kernel.hpp"
#include "dynamics/dynamic_solver.hpp"

namespace breccia::dynamics {

/// The formulation of the paper: points carry position, velocity, strain and stress and may move through the grid;
/// momenta are extrapolated to the nodes every step; velocities are updated with the nodes' accelerations (FLIP);
/// strains are updated half before and half after the momenta (update strain average), the second time from
/// re-extrapolated momenta.
///
/// Nodes gather from the points of the cells around them in a fixed order: no result depends on the number of threads.
/// Around the boundary nodes of a periodic box lie the cells of the opposite side, whose points differ in velocity by
/// the affine motion of the load.
template <int dim>
class Classical final : public DynamicSolver<dim> {
 public:
  using typename DynamicSolver<dim>::VelocityField;

  Classical(DynamicProblem<dim> problem, int threads);

  void set_velocities(const VelocityField& velocity) override;
  [[nodiscard]] Vector<dim> momentum() const override;
  [[nodiscard]] Energy energy() const override;
  [[nodiscard]] LatticeFields<dim> fields() const override;
  [[nodiscard]] Footprint footprint() const override;

 private:
  using DynamicSolver<dim>::load_at;
  using DynamicSolver<dim>::problem;
  using DynamicSolver<dim>::require_elastic;
  using DynamicSolver<dim>::steps_taken;

  static constexpr std::size_t components = tensor_components<dim>;
  /// Components of a symmetric tensor in Voigt's order.
  using Components = std::array<double, components>;
  static constexpr std::size_t nodes_per_cell = std::size_t{1} << dim;

  struct Point {
    Vector<dim> position;
    Vector<dim> velocity;
    Vector<dim> displacement;  ///< displacement [m]; summed up apart from the position, in which small steps would be
                               ///< lost by rounding
    Vector<dim> local;         ///< position relative to the centre of its cell, in cell sides
    Components strain;         ///< strain on which the stress depends, with engineering shears
    Components deviator;       ///< deviator of the stress [Pa]
    double pressure;           ///< mean normal stress, tension positive [Pa]
    double mass;               ///< mass [kg], in 2D per unit thickness [kg/m]
    std::size_t history;       ///< first value in `history_`
    std::size_t lattice;       ///< index in PointFields
    int cell;                  ///< index of the cell in lists of cells; -1 outside the box
    PhaseIndex phase;
  };
  struct Node {
    double mass;
    Vector<dim> momentum;
    Vector<dim> force;
    Vector<dim> velocity;
    Vector<dim> acceleration;
  };
  /// A material over half a step.
  struct MaterialHalfStep {
    double bulk = 0.0;
    double shear = 0.0;
    std::vector<TermStep> bulk_terms;
    std::vector<TermStep> shear_terms;
  };

  void take_steps(std::int64_t first, int steps, Averages<dim>* averages) override;
  [[nodiscard]] Vector<dim> most_moved() const override;
  void save_arrays(StateWriter& state, const std::string& group) const override;
  void restore_arrays(const StateReader& state, const std::string& group) override;

  // The parts of a step, in this order.
  void locate_points(std::int64_t step);
  void extrapolate_momenta(std::int64_t step);
  void update_strains_by_half_a_step();
  void find_forces(std::int64_t step);
  void update_momenta(std::int64_t step);
  void update_points();

  void add_points(const Index<dim>& cell);
  void sort_points(std::int64_t step);
  void update_stress(Point& point, const Components& strain_step);
  void update_mean_stresses();
  [[nodiscard]] Components strain_step(const Point& point) const;
  void bring_back(Point& point, std::int64_t step) const;
  [[nodiscard]] Vector<dim> load_velocity(const Index<dim>& node, std::int64_t step) const;
  [[nodiscard]] Averages<dim> averages() const;
  [[nodiscard]] std::array<std::size_t, nodes_per_cell> nodes_of(int cell) const noexcept;
  template <class Visit>
  void for_points_around(const Index<dim>& node, Visit&& visit) const;
  template <class Action>
  void for_nodes(Action&& action);

  int threads_;
  std::vector<MaterialHalfStep> materials_;
  std::vector<Point> points_;            ///< sorted by cell
  std::vector<std::size_t> cell_begin_;  ///< first point of each cell, and the end
  std::vector<double> mean_stress_;      ///< mean of the normal stresses (in 2D of those in the plane) of the points of
                                         ///< each cell [Pa]
  std::vector<Node> nodes_;
  std::array<std::size_t, nodes_per_cell> node_offsets_{};  ///< offsets of the nodes of a cell from its lowest one
  std::vector<double> history_;
  double initial_volume_ = 0.0;  ///< volume of all points [m^dim]
};

extern template class Classical<2>;
extern template class Classical<3>;

}  // namespace breccia::dynamics
