#include "microstructure/shapes/ellipsoid_locator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "microstructure/level_grid.hpp"
#include "microstructure/periodic_images.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

/// Radii of balls around the particles with their coatings [m].
std::vector<double> coated_radii(const EllipsoidBox& box) {
  std::vector<double> radii;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    radii.push_back(circumradius(box.particles[particle]) + box.coating_of(particle));
  }
  return radii;
}

/// A lower bound of the distance of a point from an ellipsoid that takes no search [m]: the point is on the surface of
/// the ellipsoid scaled by a factor q, whose planes of support are (q - 1) h(n) farther out than those of the ellipsoid
/// itself.
double lower_bound_of_distance(const Ellipsoid& ellipsoid, const Vector<3>& point) {
  const auto apart = point - ellipsoid.centre;
  double square = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = 2.0 * dot(ellipsoid.directions[axis], apart) / ellipsoid.axes[axis];
    square += length * length;
  }
  return 0.5 * (std::sqrt(square) - 1.0) * std::ranges::min(ellipsoid.axes);
}

}  // namespace

struct EllipsoidLocator::Search {
  explicit Search(EllipsoidBox particles)
      : box(std::move(particles)),
        radii(coated_radii(box)),
        reach(0.5 * box.side / std::cbrt(1.0 + static_cast<double>(box.particles.size()))),
        grid(box.side, box.walls, radii),
        images(box.side) {
    for (std::uint32_t particle = 0; particle < radii.size(); ++particle) {
      grid.insert(particle, box.particles[particle].centre);
    }
  }

  EllipsoidBox box;
  std::vector<double> radii;
  double reach;  // distance beyond which a particle need not be found
  LevelGrid<3> grid;
  PeriodicImages<3> images;
};

EllipsoidLocator::EllipsoidLocator(EllipsoidBox box) : search_(std::make_unique<Search>(std::move(box))) {}
EllipsoidLocator::EllipsoidLocator(EllipsoidLocator&&) noexcept = default;
EllipsoidLocator& EllipsoidLocator::operator=(EllipsoidLocator&&) noexcept = default;
EllipsoidLocator::~EllipsoidLocator() = default;

const EllipsoidBox& EllipsoidLocator::box() const noexcept {
  return search_->box;
}

LocatedParticle EllipsoidLocator::at(const Vector<3>& position) const {
  const auto& search = *search_;
  LocatedParticle nearest = {{}, search.reach};
  double coated = search.reach;  // distance from the coating of the nearest particle
  search.grid.visit_near(position, search.reach, [&](std::uint32_t number, std::uint32_t image) {
    if (nearest.distance < 0.0) return;  // no other particle is at this point
    auto particle = search.box.particles[number];
    particle.centre += search.images.shift(image);
    if (norm(position - particle.centre) - search.radii[number] >= coated) return;
    const double coating = search.box.coating_of(number);
    constexpr double rounding = 1e-12;
    if (lower_bound_of_distance(particle, position) - coating >= coated * (1.0 + rounding)) return;
    const double distance = signed_distance(particle, position);
    if (distance - coating >= coated) return;
    coated = distance - coating;
    nearest = {number, distance};
  });
  return nearest;
}

}  // namespace breccia
