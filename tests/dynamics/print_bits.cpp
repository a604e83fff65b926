// Prints, to the last bit, what runs of the total-lagrangian formulation give under each boundary: the first process
// speaks for all, and the others only say that they were there.

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/discretisation/mixed_cells.hpp"
#include "breccia/dynamics/dynamic_solver.hpp"
#include "breccia/parallel/session.hpp"

#include "materials.hpp"

namespace breccia {
namespace {

std::string bits_of(DynamicProblem<2> problem, Boundary boundary, Volumetric volumetric) {
  problem.boundary = boundary;
  problem.volumetric = volumetric;
  problem.load = {.xx = 0.1, .yy = -0.2, .xy = 0.5};
  problem.traction = {.xx = 0.2, .yy = -0.4, .xy = 1.0};
  problem.ramp = StrainRamp(1e-3);
  problem.time_step = 0.9 * stable_time_step(problem.discretisation, problem.materials, volumetric, 1.0);
  const auto run = make_dynamic_solver(Formulation::total_lagrangian, std::move(problem));
  std::vector<Averages<2>> averages;
  run->advance(150, averages);
  run->advance(50, averages);
  const auto momentum = run->momentum();
  auto bits = fmt::format("momentum {:a} {:a}\n", momentum[0], momentum[1]);
  for (const auto& [stress, strain] : averages) {
    bits += fmt::format("{:a} {:a} {:a} {:a} {:a} {:a}\n", stress.xx, stress.yy, stress.xy, strain.xx, strain.yy,
                        strain.xy);
  }
  const auto fields = run->fields();
  for (std::size_t p = 0; p < fields.stress.size(); ++p) {
    bits += fmt::format("{} {:a} {:a} {:a} {:a}\n", fields.phase[p], fields.displacement[p][0],
                        fields.displacement[p][1], fields.strain[p][2], fields.stress[p][3]);
  }
  return bits;
}

void print() {
  using testing_materials::relaxing;
  using testing_materials::stiff;
  const DynamicProblem<2> points{testing_materials::disc_in_box(21), {relaxing, stiff}};
  constexpr std::array<PhaseIndex, 1> disc = {1};
  const auto box = discretise_mixed<2>({1.0, Walls::hard, {Disc{{0.45, 0.52}, 0.61}}}, 21, 0, disc, 2);
  const DynamicProblem<2> mixed{box, with_mixtures(box, {relaxing, stiff})};
  std::string all;
  for (const auto boundary : {Boundary::displacement, Boundary::traction, Boundary::periodic}) {
    for (const auto volumetric : {Volumetric::averaged, Volumetric::standard}) {
      all += bits_of(points, boundary, volumetric);
    }
    all += bits_of(mixed, boundary, Volumetric::averaged);
  }
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
