// Random composites of spheres in a matrix that relaxes keep the bounds of Hashin and Shtrikman at real Laplace
// variables, where their moduli s M~(s) are those of elastic composites (examples/space/hashin_shtrikman.py has twenty
// with mixed cells).
//
// In a periodic box the bounds hold for K and for the mean of G over all directions, wherever the spheres are: the
// variational principle, with a uniform polarisation of each phase and averaged over the rotations of the load, depends
// on the fractions alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/discretisation/point_fields.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/reduced/sampling.hpp"

namespace breccia {
namespace {

using Random = std::mt19937_64;

/// A random number between two values, uniform in its logarithm, which is the same with every standard library.
double over_decades(double low, double high, Random& random) {
  const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
  return low * std::pow(high / low, share);
}

constexpr TimeWindow spectrum_times = {1e-6, 1.0};

/// A box of two to five equal spheres that fill 10 to 40 % of it.
Microstructure<3> random_spheres(Random& random) {
  PackingRequest request;
  request.side = 1.0;
  request.walls = Walls::periodic;
  request.seed = random();
  request.minimum_gap = 0.02;
  const auto count = 2 + random() % 4;
  const double fraction = over_decades(0.1, 0.4, random);
  request.diameters.assign(count, std::cbrt(6.0 * fraction / (std::numbers::pi * static_cast<double>(count))));
  return {request.side, request.walls, pack<3>(request).balls};
}

/// A matrix of three terms and a sphere that is elastic, and softer or stiffer.
std::vector<Material> random_materials(Random& random) {
  const double unrelaxed = over_decades(1e5, 1e8, random), contrast = over_decades(0.1, 1e3, random);
  std::vector<MaxwellTerm> terms;
  terms.reserve(3);
  for (int i = 0; i < 3; ++i) {
    terms.push_back(
        {over_decades(spectrum_times.begin, spectrum_times.end, random), unrelaxed * over_decades(0.01, 1.0, random)});
  }
  const PronySeries shear(unrelaxed * over_decades(1e-3, 0.1, random), std::move(terms));
  return {{"matrix", 1.0, PronySeries(unrelaxed * over_decades(1.0, 100.0, random)), shear},
          {"sphere", 1.0, PronySeries(3.0 * contrast * unrelaxed), PronySeries(contrast * unrelaxed)}};
}

/// The box after a cyclic change of the axes: z takes the place of x, x that of y and y that of z.
Microstructure<3> turned(Microstructure<3> box) {
  for (auto& sphere : box.particles) std::rotate(sphere.centre.begin(), sphere.centre.end() - 1, sphere.centre.end());
  return box;
}

/// Volume of the spheres in a box of side 1.
double volume_of(const Microstructure<3>& box) {
  double volume = 0.0;
  for (const auto& sphere : box.particles) volume += ball_volume<3>(sphere.diameter);
  return volume;
}

/// The Carson modulus s M~(s) [Pa].
double carson(const PronySeries& series, double s) {
  double modulus = series.equilibrium();
  for (const auto& [time, stiffness] : series.terms()) modulus += stiffness * s * time / (1.0 + s * time);
  return modulus;
}

constexpr int cells = 8;

Discretisation<3> mixed_cells_of(const Microstructure<3>& box) {
  const std::vector<PhaseIndex> spheres(box.particles.size(), 1);
  return discretise_mixed(box, cells, 0, std::span<const PhaseIndex>(spheres), 2);
}

/// A discretisation in which each cell has the phase that fills most of it: a composite of two phases, for which finite
/// elements give moduli that are too high.
Discretisation<3> voxels_of(const Microstructure<3>& box) {
  const auto mixed = mixed_cells_of(box);
  Discretisation<3> voxels(mixed.grid());
  const auto phases = zero_cell_fields(mixed).phase;
  voxels.grid().for_each_cell([&](const Index<3>& cell) { voxels.fill(cell, phases[voxels.grid().cell_index(cell)]); });
  return voxels;
}

/// The relaxation moduli of a periodic box under some loads.
std::vector<PronySeries> relaxation_moduli(const Discretisation<3>& box, const std::vector<Material>& materials,
                                           std::span<const Load> loads) {
  const QuasistaticProblem<3> problem = {.discretisation = box, .materials = materials, .boundary = Boundary::periodic};
  const auto found = sample_responses(problem, loads, matrix_path(0, carson_path(materials.front(), spectrum_times)));
  std::vector<PronySeries> series;
  for (const auto& response : found.responses) {
    series.push_back(relaxation_modulus(creep_compliance(response, materials.front())));
  }
  return series;
}

struct Bounds {
  double lower = 0.0, upper = 0.0;  ///< [Pa]
};

/// The mean 1 / <1 / (M + extra)> - extra over two phases.
double mean_with(double extra, const std::array<double, 2>& fractions, const std::array<double, 2>& moduli) {
  return 1.0 / (fractions[0] / (moduli[0] + extra) + fractions[1] / (moduli[1] + extra)) - extra;
}

Bounds of_bulk(const std::array<double, 2>& fractions, const std::array<double, 2>& bulk,
               const std::array<double, 2>& shear) {
  const auto [soft, stiff] = std::ranges::minmax(shear);
  return {mean_with(4.0 / 3.0 * soft, fractions, bulk), mean_with(4.0 / 3.0 * stiff, fractions, bulk)};
}

Bounds of_shear(const std::array<double, 2>& fractions, const std::array<double, 2>& bulk,
                const std::array<double, 2>& shear) {
  const auto extra = [](double k, double g) { return g / 6.0 * (9.0 * k + 8.0 * g) / (k + 2.0 * g); };
  const auto [soft, stiff] = std::ranges::minmax(shear);
  const auto [compressible, incompressible] = std::ranges::minmax(bulk);
  return {mean_with(extra(compressible, soft), fractions, shear),
          mean_with(extra(incompressible, stiff), fractions, shear)};
}

/// The relaxation moduli from which K and the mean of G over all directions follow.
std::vector<PronySeries> relaxation_moduli(const Discretisation<3>& box, const Discretisation<3>& turned_box,
                                           const std::vector<Material>& materials) {
  constexpr std::array loads = {Load::bulk,     Load::shear,          Load::shear_yz,
                                Load::shear_zx, Load::diagonal_shear, Load::diagonal_shear_yz};
  auto moduli = relaxation_moduli(box, materials, loads);
  // The shear of zz - xx is that of xx - yy after the turn.
  moduli.push_back(relaxation_moduli(turned_box, materials, std::array{Load::diagonal_shear}).front());
  return moduli;
}

/// K and the mean of G over all directions at a real Laplace variable, or their bounds.
struct Isotropic {
  double bulk, shear;  ///< [Pa]
};

Isotropic carson(const std::vector<PronySeries>& moduli, double s) {
  const auto at = [&](std::size_t load) { return carson(moduli[load], s); };
  return {at(0), (at(1) + at(2) + at(3) + 2.0 / 3.0 * (at(4) + at(5) + at(6))) / 5.0};
}

/// The lower (first) and upper (second) bounds at a Laplace variable.
std::array<Isotropic, 2> bounds(double filled, const std::vector<Material>& materials, double s) {
  const std::array fractions = {1.0 - filled, filled};
  const std::array bulks = {carson(materials[0].bulk, s), carson(materials[1].bulk, s)};
  const std::array shears = {carson(materials[0].shear, s), carson(materials[1].shear, s)};
  const auto bulk = of_bulk(fractions, bulks, shears), shear = of_shear(fractions, bulks, shears);
  return {Isotropic{bulk.lower, shear.lower}, Isotropic{bulk.upper, shear.upper}};
}

// Moduli with voxels are too high, by up to 10 % on such a coarse grid, so that they must be above the lower bounds.
// Moduli with mixed cells, which are too soft where the contrast is small, must be below the upper bounds.
TEST(HashinShtrikman, BoundsHoldAtRealLaplaceVariables) {
  constexpr double of_basis = 1e-4;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto box = random_spheres(random);
    const auto materials = random_materials(random);
    const auto voxels = voxels_of(box), mixed = mixed_cells_of(box);
    const auto stiff = relaxation_moduli(voxels, voxels_of(turned(box)), materials),
               soft = relaxation_moduli(mixed, mixed_cells_of(turned(box)), materials);
    const double of_voxels = voxels.fractions(2).at(1), of_spheres = volume_of(box);
    for (const double s : {0.1, 1e3, 1e7}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", s " << s);
      const auto least = bounds(of_voxels, materials, s)[0], most = bounds(of_spheres, materials, s)[1];
      const auto above = carson(stiff, s), below = carson(soft, s);
      EXPECT_GE(above.bulk / least.bulk, 1.0 - of_basis);
      EXPECT_GE(above.shear / least.shear, 1.0 - of_basis);
      EXPECT_LE(below.bulk / most.bulk, 1.0 + of_basis);
      EXPECT_LE(below.shear / most.shear, 1.0 + of_basis);
    }
  }
}

}  // namespace
}  // namespace breccia
