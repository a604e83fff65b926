// Tests of grains that fill a box, separated by thin films of a soft binder: mixed cells and points against conforming
// elements.

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/quasistatic/apparent_moduli.hpp"

#include "discretisation/labels.hpp"
#include "microstructure/tessellation/grain_locator.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

const std::string references = BRECCIA_REFERENCE_DIRECTORY;

constexpr double film = 2.4 / 256.0;  ///< thickness of the films in a box of side 1
constexpr PhaseIndex binder = 0, grain = 1;

Labelling<2> voronoi_grains() {
  const auto table = read_csv(references + "/voronoi_sites_25.csv", {});
  LaguerreSites<2> sites = {.side = 1.0, .walls = Walls::periodic, .sites = {}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    sites.sites.push_back({{table.numbers("x_m")[row], table.numbers("y_m")[row]}, table.numbers("weight_m2")[row]});
  }
  const auto locator = std::make_shared<GrainLocator<2>>(Tessellation<2>(sites), film);
  return [locator](const Vector<2>& position) -> PhaseAt {
    const auto found = locator->at(position);
    return {found.is_in_grain() ? grain : binder, std::abs(found.depth)};
  };
}

/// Shear moduli along the axes and the diagonals, and K + G/3 [MPa], for a shear modulus of the binder [MPa].
std::vector<double> moduli(const Discretisation<2>& discretisation, double binder_shear) {
  const Material hmx = {"hmx", 1850.0, PronySeries(13.4e9), PronySeries(5.84e9)};
  const Material soft = {"binder", 1480.0, PronySeries(3.6e9), PronySeries(1e6 * binder_shear)};
  auto moduli = apparent_moduli<2>({.discretisation = discretisation,
                                    .materials = {soft, hmx},
                                    .boundary = Boundary::periodic,
                                    .linear = {.tolerance = 1e-8, .threads = 1}},
                                   std::array{Load::shear, Load::diagonal_shear, Load::bulk});
  for (double& modulus : moduli) modulus *= 1e-6;
  return moduli;
}

/// The moduli [MPa] by conforming elements.
std::vector<double> reference(double binder_shear) {
  const auto table = read_csv(references + "/voronoi_films.csv", {"load"});
  std::vector<double> moduli;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.numbers("binder_shear_MPa")[row] == binder_shear) moduli.push_back(table.numbers("modulus_MPa")[row]);
  }
  return moduli;
}

TEST(ThinFilms, OfTwoMixedCellsAndAHalfAreWithinFivePerCent) {
  const auto discretisation = discretise_mixed({{256, 256}, 1.0 / 256}, voronoi_grains(), 2);
  EXPECT_NEAR(discretisation.fractions(2)[grain], 0.9111, 1e-4);
  for (const double shear : {100.0, 1.0}) {
    const auto found = moduli(discretisation, shear), expected = reference(shear);
    EXPECT_NEAR(found[0] / expected[0], 1.0, 0.05) << shear;
    EXPECT_NEAR(found[1] / expected[1], 1.0, 0.052) << shear;
    EXPECT_NEAR(found[2] / expected[2], 1.0, 1e-3) << shear;
  }
}

// One cell across a film lets the binder slide, but not be squeezed out.
TEST(ThinFilms, OfOneMixedCellCanSlide) {
  const auto discretisation = discretise_mixed({{128, 128}, 1.0 / 128}, voronoi_grains(), 2);
  const auto sliding = moduli(discretisation, 30.0), squeezed = moduli(discretisation, 0.7);
  EXPECT_NEAR(sliding[0] / reference(30.0)[0], 1.0, 0.08);
  EXPECT_NEAR(sliding[1] / reference(30.0)[1], 1.0, 0.08);
  EXPECT_GT(squeezed[0] / reference(0.7)[0], 2.0);
}

// The expected values were computed with another program.
TEST(ThinFilms, OfPointsAreBridged) {
  constexpr std::array<double, 2> shears = {10.0, 1.0}, found_before = {3834.0, 3814.0};
  const auto discretisation = discretise<2>({{128, 128}, 1.0 / 128}, voronoi_grains());
  for (std::size_t i = 0; i < shears.size(); ++i) {
    EXPECT_NEAR(moduli(discretisation, shears[i])[0] / found_before[i], 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace breccia
