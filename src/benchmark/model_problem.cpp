#include "benchmark/model_problem.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "breccia/discretisation/phases.hpp"
#include "breccia/microstructure/packing.hpp"

#include "discretisation/mixed_cells.hpp"

namespace breccia::benchmark {
namespace {

constexpr int particles = 200;

template <int dim>
double diameter() {
  return dim == 2 ? std::sqrt(0.65 * 4.0 / (std::numbers::pi * particles))
                  : std::cbrt(0.4 * 6.0 / (std::numbers::pi * particles));
}

/// Discs or spheres in a box of side 1 m.
template <int dim>
Microstructure<dim> packed_box() {
  PackingRequest request;
  request.side = 1.0;
  request.diameters.assign(particles, diameter<dim>());
  request.minimum_gap = 0.005;
  return {1.0, Walls::hard, pack<dim>(request).balls};
}

}  // namespace

template <int dim>
DynamicProblem<dim> model_problem(int cells, int terms, Mixing mixing) {
  static const auto box = packed_box<dim>();
  std::vector<MaxwellTerm> spectrum;
  spectrum.reserve(static_cast<std::size_t>(terms));
  for (int k = 0; k < terms; ++k) spectrum.push_back({1e-3 * std::pow(10.0, k), 1e8});
  static const Phases phases({"matrix", "filler"});
  const auto matrix = phases.index_of("matrix"), filler = phases.index_of("filler");
  const std::vector<PhaseIndex> fillers(box.particles.size(), filler);
  auto discretisation = has_mixed_cells(mixing) ? discretise_mixed(box, cells, matrix, fillers, phases.size())
                                                : discretise<dim>(box, cells, matrix, fillers);
  auto materials = with_mixtures(
      discretisation, phases.materials({{"matrix", {"binder", 1480.0, PronySeries(3.6e9), PronySeries(1e7, spectrum)}},
                                        {"filler", {"filler", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)}}}));
  DynamicProblem<dim> problem{std::move(discretisation), std::move(materials)};
  problem.load = unit_strain<dim>(Load::shear);
  problem.ramp = StrainRamp(1e-3);
  constexpr double courant = 0.9;
  problem.time_step =
      courant * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.mass_scaling);
  return problem;
}

template DynamicProblem<2> model_problem(int, int, Mixing);
template DynamicProblem<3> model_problem(int, int, Mixing);

}  // namespace breccia::benchmark
