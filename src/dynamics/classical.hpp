#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "breccia/dynamics/dynamic_solver.hpp"

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The paper's formulation: points carry position, velocity, strain and stress and may move through the grid; momenta
/// are extrapolated to the nodes every step; velocities are updated with the nodes' accelerations (FLIP); strains are
/// updated half before and half after the momenta (update strain average), the second time from re-extrapolated
/// momenta.
///
/// Nodes gather from the points of the cells around them in a fixed order: no result depends on the number of threads.
/// Around the boundary nodes of a periodic box lie the cells of the opposite side, whose points differ in velocity by
/// the affine motion of the load.
class Classical final : public DynamicSolver {
 public:
  Classical(DynamicProblem problem, int threads);

  void set_velocities(const VelocityField& velocity) override;
  [[nodiscard]] Vector<2> momentum() const override;
  [[nodiscard]] Energy energy() const override;
  [[nodiscard]] PointFields fields() const override;
  [[nodiscard]] Footprint footprint() const override;

 private:
  struct Point {
    Vector<2> position;
    Vector<2> velocity;
    Vector<2> displacement;          ///< [m], summed up apart from the position, which would round it off
    Vector<2> local;                 ///< position relative to the centre of its cell, in cell sides
    std::array<double, 3> strain;    ///< as the stress sees it: xx, yy, engineering xy
    std::array<double, 3> deviator;  ///< stress deviator xx, yy, xy [Pa]
    double pressure;                 ///< tension positive [Pa]
    double mass;                     ///< per unit thickness [kg/m]
    std::size_t history;             ///< first value in `history_`
    std::size_t lattice;             ///< place in PointFields
    int cell;
    MaterialIndex material;
  };
  struct Node {
    double mass;
    Vector<2> momentum;
    Vector<2> force;
    Vector<2> velocity;
    Vector<2> acceleration;
  };
  /// A material over half a step.
  struct MaterialHalfStep {
    double bulk;
    double shear;
    std::vector<TermStep> bulk_terms;
    std::vector<TermStep> shear_terms;
  };

  void take_steps(std::int64_t first, int steps, Averages* averages) override;
  [[nodiscard]] Vector<2> most_moved() const override;
  void save_arrays(StateWriter& state, const std::string& group) const override;
  void restore_arrays(const StateReader& state, const std::string& group) override;

  // One step, in this order.
  void locate_points(std::int64_t step);
  void extrapolate_momenta(std::int64_t step);
  void update_strains();
  void find_forces(std::int64_t step);
  void update_momenta(std::int64_t step);
  void update_points();

  void sort_points();
  void update_stress(Point& point, const std::array<double, 3>& strain_step);
  [[nodiscard]] double mean_volumetric_step(int cell) const;
  [[nodiscard]] std::array<double, 3> strain_step(const Point& point) const;
  void bring_back(Point& point, std::int64_t step) const;
  [[nodiscard]] Vector<2> load_velocity(int node_column, int node_row, std::int64_t step) const;
  [[nodiscard]] Averages averages() const;
  [[nodiscard]] std::array<std::size_t, 4> nodes_of(int cell) const noexcept;
  template <class Visit>
  void for_points_around(int node_column, int node_row, Visit&& visit) const;
  template <class Action>
  void for_nodes(Action&& action);

  int threads_;
  std::vector<MaterialHalfStep> materials_;
  std::vector<Point> points_;            ///< sorted by cell
  std::vector<std::size_t> cell_begin_;  ///< first point of each cell, and the end
  std::vector<double> mean_stress_;      ///< mean in-plane stress of the points of the cell [Pa]
  std::vector<Node> nodes_;
  std::vector<double> history_;
  double initial_area_ = 0.0;
};

}  // namespace breccia::dynamics
