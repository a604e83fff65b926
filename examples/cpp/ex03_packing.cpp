// Example 3: a random packing of discs from a lognormal distribution of their sizes.

#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/report/microstructure_picture.hpp"

int main() {
  // Half of the area of the particles is in particles below 20 um; none is smaller than 8 um or larger than 50 um.
  const auto sizes = breccia::SizeDistribution::lognormal_mixture({{.weight = 1.0, .median = 20e-6, .sigma = 0.5}})
                         .truncated(8e-6, 50e-6);
  constexpr double side = 300e-6, fraction = 0.6;

  // Which diameters are in the box does not depend on chance, where the discs are depends on the seed alone.
  breccia::PackingRequest request;
  request.side = side;
  request.walls = breccia::Walls::periodic;
  request.diameters = breccia::draw_diameters<2>(sizes, fraction, side);
  request.minimum_gap = 1e-6;
  request.seed = 7;
  const breccia::Microstructure<2> box = {side, request.walls, breccia::pack<2>(request).balls};
  breccia::require_valid(box);  // no disc overlaps another one

  const double reached = breccia::volume_fraction(box), gap = breccia::smallest_gap(box);
  fmt::print("{} discs, {:.2f} % of the box\n", box.particles.size(), 100.0 * reached);
  fmt::print("smallest gap: {:.2f} um\n", gap / 1e-6);
  fmt::print("interface: {:.1f} mm per mm^2\n", breccia::specific_surface(box) / 1e3);

  fmt::print("\nshare of the area in discs of each size\n{:>14}  {:>8}  {:>8}\n", "diameter [um]", "in box", "asked");
  const std::vector<double> edges = {8e-6, 12e-6, 18e-6, 27e-6, 50e-6};
  const auto drawn = breccia::size_histogram<2>(box, edges);
  for (std::size_t bin = 0; bin < drawn.size(); ++bin) {
    const double asked = sizes.cumulative(edges[bin + 1]) - sizes.cumulative(edges[bin]);
    fmt::print("{:>6.0f} .. {:>4.0f}  {:>6.1f} %  {:>6.1f} %\n", edges[bin] / 1e-6, edges[bin + 1] / 1e-6,
               100.0 * drawn[bin], 100.0 * asked);
  }

  std::ofstream("ex03_packing.svg") << breccia::microstructure_picture(box);
  fmt::print("\nA picture is in ex03_packing.svg\n");

  // The area is what was asked for to within one disc, the largest at most, and all gaps are kept.
  const double largest_disc = std::numbers::pi / 4.0 * 50e-6 * 50e-6 / (side * side);
  const bool is_right = std::abs(reached - fraction) < largest_disc && gap > (1.0 - 1e-9) * request.minimum_gap;
  fmt::print("Fraction and gaps are those that were asked for: {}\n", is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}
