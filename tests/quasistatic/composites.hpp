#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "breccia/discretisation/load.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia::test {

inline constexpr std::array shear_and_bulk = {Load::shear, Load::bulk};

/// The model composite of the paper (its Fig. 2 and Table 1) with n x n cells.
inline QuasistaticProblem<2> model_composite(int n, Volumetric volumetric, Boundary boundary) {
  Microstructure<2> box = {6e-3, Walls::hard, {}};
  for (const double x : {1.5e-3, 4.5e-3}) {
    for (const double y : {1.5e-3, 4.5e-3}) box.particles.push_back({{x, y}, 2e-3});
  }
  return {.discretisation = discretise(box, n, 0, 1),
          .materials = {{"binder", 1000.0, PronySeries(1e6), PronySeries(0.0, {{10e-3, 0.5e6}})},
                        {"particle", 1500.0, PronySeries(50e6), PronySeries(18.8e6)}},
          .volumetric = volumetric,
          .boundary = boundary};
}

/// The times [s] in which random_composite relaxes.
inline constexpr TimeWindow relaxation_window = {1e-7, 1e-3};

/// Twelve discs in a box.
inline Microstructure<2> random_discs(std::uint64_t seed) {
  PackingRequest request;
  request.side = 50e-6;
  request.diameters.assign(12, 11e-6);
  request.minimum_gap = 1e-6;
  request.seed = seed;
  return {request.side, Walls::hard, pack<2>(request).balls};
}

/// The discs of random_discs(), which are stiff, in a binder with a spectrum like that of an elastomer, which is nearly
/// incompressible when it has relaxed.
inline QuasistaticProblem<2> random_composite(int n, std::uint64_t seed, Boundary boundary) {
  const auto box = random_discs(seed);
  const PronySeries shear(0.2e6, {{1e-7, 300e6}, {1e-6, 80e6}, {1e-5, 20e6}, {1e-4, 4e6}, {1e-3, 1e6}});
  return {.discretisation = discretise(box, n, 0, 1),
          .materials = {{"binder", 1480.0, PronySeries(3.6e9), shear},
                        {"hmx", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)}},
          .boundary = boundary};
}

/// A box of one material.
inline QuasistaticProblem<2> homogeneous(const Material& material, Boundary boundary) {
  return {.discretisation = Discretisation<2>(Grid<2>{{6, 5}, 1e-3}), .materials = {material}, .boundary = boundary};
}

inline std::vector<double> logarithmic(double first, double last, int per_decade) {
  std::vector<double> values;
  const auto count = static_cast<int>(std::lround(per_decade * std::log10(last / first)));
  for (int i = 0; i <= count; ++i) values.push_back(first * std::pow(10.0, static_cast<double>(i) / per_decade));
  return values;
}

inline constexpr std::array boundaries = {Boundary::displacement, Boundary::traction, Boundary::periodic};

}  // namespace breccia::test
