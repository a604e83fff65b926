// Prints, to the last bit, the results of runs of the total-lagrangian formulation under each boundary. The first
// process prints the results of all, and the other processes only print that they ran.

#include <array>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/parallel/ordered_values.hpp"

#include "discretisation/mixed_cells.hpp"
#include "dynamics/dynamic_solver.hpp"
#include "materials.hpp"
#include "parallel/session.hpp"

namespace breccia {
namespace {

constexpr Strain<2> load_of(const DynamicProblem<2>& /*problem*/) {
  return {.xx = 0.1, .yy = -0.2, .xy = 0.5};
}
constexpr Strain<3> load_of(const DynamicProblem<3>& /*problem*/) {
  return {.xx = 0.1, .yy = -0.2, .zz = 0.3, .yz = -0.4, .zx = 0.35, .xy = 0.5};
}

template <int dim, class Quantity>
std::string bits_of(const SymmetricTensor<dim, Quantity>& tensor) {
  std::string bits;
  for (int i = 0; i < tensor_components<dim>; ++i) bits += fmt::format("{:a} ", component(tensor, i));
  return bits;
}

template <int dim>
std::string bits_of(DynamicProblem<dim> problem, Boundary boundary, Volumetric volumetric) {
  problem.boundary = boundary;
  problem.volumetric = volumetric;
  problem.load = load_of(problem);
  for (int i = 0; i < tensor_components<dim>; ++i) component(problem.traction, i) = 2.0 * component(problem.load, i);
  problem.ramp = StrainRamp(1e-3);
  problem.time_step = 0.9 * stable_time_step(problem.discretisation, problem.materials, volumetric, 1.0);
  const auto grid = problem.discretisation.grid();
  const auto run = make_dynamic_solver(Formulation::total_lagrangian, std::move(problem));
  std::vector<Averages<dim>> averages;
  run->advance(150, averages);
  run->advance(50, averages);
  auto bits = fmt::format("momentum {:a}\n", fmt::join(run->momentum(), " "));
  for (const auto& [stress, strain] : averages) bits += bits_of(stress) + bits_of(strain) + "\n";
  // Each process has the fields of its own cells.
  const auto fields = run->fields();
  const auto indices = places_of_timed_fields(grid, fields.cells);
  const auto all = [&](const auto& own) {
    return parallel::collect(std::span(own), indices, 0, size_of_timed_fields(grid));
  };
  const auto phase = all(fields.phase);
  const auto displacement = all(fields.displacement);
  const auto strain = all(fields.strain);
  const auto stress = all(fields.stress);
  for (std::size_t p = 0; p < stress.size(); ++p) {
    bits += fmt::format("{} {:a} {:a} {:a}\n", phase[p], fmt::join(displacement[p], " "), strain[p].back(),
                        stress[p].back());
  }
  return bits;
}

/// Prints the results under every boundary.
template <int dim>
std::string bits_of(const DynamicProblem<dim>& points, const DynamicProblem<dim>& mixed) {
  std::string all;
  for (const auto boundary : {Boundary::displacement, Boundary::traction, Boundary::periodic}) {
    for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
      all += bits_of(points, boundary, volumetric);
    }
    all += bits_of(mixed, boundary, Volumetric::averaged);
  }
  return all;
}

void print() {
  using testing_materials::relaxing;
  using testing_materials::stiff;
  const DynamicProblem<2> points{testing_materials::disc_in_box(21), {relaxing, stiff}};
  constexpr std::array<PhaseIndex, 1> disc = {1};
  const auto box = discretise_mixed<2>({1.0, Walls::hard, {Disc{{0.45, 0.52}, 0.61}}}, 21, 0, disc, 2);
  const DynamicProblem<2> mixed{box, with_mixtures(box, {relaxing, stiff})};
  const DynamicProblem<3> points_of_cube{testing_materials::sphere_in_box(9), {relaxing, stiff}};
  const auto all =
      bits_of(points, mixed) + bits_of(points_of_cube, testing_materials::mixed_sphere_in_box(9, {relaxing, stiff}));
  if (parallel::rank() == 0) {
    fmt::print("{}", all);
  } else {
    fmt::print(stderr, "process {} of {}\n", parallel::rank(), parallel::ranks());
  }
}

}  // namespace
}  // namespace breccia

int main() {
  breccia::print();
  breccia::parallel::stop();
}
