#include "model_problem.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "breccia/discretisation/mixed_cells.hpp"
#include "breccia/discretisation/phases.hpp"
#include "breccia/microstructure/packing.hpp"

namespace breccia::benchmark {
namespace {

/// Discs in a box of side 1 m.
Microstructure<2> packed_box() {
  constexpr int discs = 200;
  PackingRequest request;
  request.side = 1.0;
  request.diameters.assign(discs, std::sqrt(0.65 * 4.0 / (std::numbers::pi * discs)));
  request.minimum_gap = 0.005;
  return {1.0, Walls::hard, pack<2>(request).balls};
}

}  // namespace

DynamicProblem<2> model_problem(int cells, int terms, Mixing mixing) {
  static const auto box = packed_box();
  std::vector<MaxwellTerm> spectrum;
  spectrum.reserve(static_cast<std::size_t>(terms));
  for (int k = 0; k < terms; ++k) spectrum.push_back({1e-3 * std::pow(10.0, k), 1e8});
  static const Phases phases({"matrix", "filler"});
  const auto matrix = phases.index_of("matrix"), filler = phases.index_of("filler");
  const std::vector<PhaseIndex> discs(box.particles.size(), filler);
  auto discretisation = mixing == Mixing::series ? discretise_mixed(box, cells, matrix, discs, phases.size())
                                                 : discretise<2>(box, cells, matrix, discs);
  auto materials = with_mixtures(
      discretisation, phases.materials({{"matrix", {"binder", 1480.0, PronySeries(3.6e9), PronySeries(1e7, spectrum)}},
                                        {"filler", {"filler", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)}}}));
  DynamicProblem<2> problem{std::move(discretisation), std::move(materials)};
  problem.load = {.xy = 0.5};
  problem.ramp = StrainRamp(1e-3);
  constexpr double courant = 0.9;
  problem.time_step =
      courant * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.density_factor);
  return problem;
}

}  // namespace breccia::benchmark
