#include "breccia/microstructure/random_sites.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <random>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "microstructure/level_grid.hpp"
#include "microstructure/periodic_images.hpp"
#include "microstructure/tessellation/site_weights.hpp"
#include "microstructure/uniform.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {

/// Volume fraction of the balls that are placed first: well below what random sequential addition reaches (0.547 and
/// 0.384 for equal balls).
template <int dim>
constexpr double first_fraction = dim == 2 ? 0.4 : 0.25;
constexpr int most_attempts = 10'000;     // largest number of attempts to place a ball
constexpr double ball_shrinkage = 0.9;    // factor of the diameters, if a ball does not fit
constexpr double rough_tolerance = 0.01;  // relative tolerance of volumes in the steps that only need the centroids

void require_meaning(const RandomTessellationRequest& request) {
  if (!(request.side > 0.0) || !std::isfinite(request.side)) {
    throw InputError(fmt::format("tessellation: the side of the box must be positive, got {} m", request.side));
  }
  if (request.diameters.empty() || request.diameters.size() > most_particles) {
    throw InputError(
        fmt::format("tessellation: it needs from 1 to {} grains, got {}", most_particles, request.diameters.size()));
  }
  for (const double diameter : request.diameters) {
    if (diameter > 0.0 && std::isfinite(diameter)) continue;
    throw InputError(fmt::format("tessellation: a diameter must be positive and finite, got {} m", diameter));
  }
  if (request.centring_steps < 0) {
    throw InputError(
        fmt::format("tessellation: the number of centring steps must not be negative, got {}", request.centring_steps));
  }
}

/// Volumes of balls with these diameters [m^dim].
template <int dim>
std::vector<double> ball_volumes(const std::vector<double>& diameters) {
  std::vector<double> volumes(diameters.size());
  std::ranges::transform(diameters, volumes.begin(), ball_volume<dim>);
  return volumes;
}

/// Balls at random positions, the largest first, none of which touches another (random sequential addition). Their
/// weights are the squares of their radii [m], so each ball lies in its own cell. Nothing if a ball does not fit.
template <int dim>
std::optional<LaguerreSites<dim>> place_balls(double side, Walls walls, const std::vector<double>& radii,
                                              std::mt19937_64& engine) {
  LaguerreSites<dim> result{side, walls, std::vector<Site<dim>>(radii.size())};
  LevelGrid<dim> grid(side, walls, radii);
  const PeriodicImages<dim> images(side);
  std::vector<std::uint32_t> order(radii.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::uint32_t ball) { return radii[ball]; });
  const auto overlaps = [&](const Vector<dim>& point, double radius) {
    bool found = false;
    grid.visit_near(point, radius, [&](std::uint32_t other, auto image) {
      const auto seen = result.sites[other].position + images.shift(image);
      found = found || norm(seen - point) < radius + radii[other];
    });
    return found;
  };
  for (const std::uint32_t ball : order) {
    auto& [point, weight] = result.sites[ball];
    weight = radii[ball] * radii[ball];
    int attempts = 0;
    do {
      if (attempts++ == most_attempts) return std::nullopt;
      for (double& x : point) x = side * uniform(engine);
    } while (overlaps(point, radii[ball]));
    grid.insert(ball, point);
  }
  return result;
}

/// Sites whose cells all have positive volumes of about the wanted size.
template <int dim>
LaguerreSites<dim> first_sites(const RandomTessellationRequest& request) {
  const auto volumes = ball_volumes<dim>(request.diameters);
  const double total = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  double scale = request.side * std::pow(first_fraction<dim> / total, 1.0 / dim);
  std::mt19937_64 engine(request.seed);
  for (;; scale *= ball_shrinkage) {
    std::vector<double> radii;
    radii.reserve(request.diameters.size());
    for (const double diameter : request.diameters) radii.push_back(0.5 * scale * diameter);
    if (auto sites = place_balls<dim>(request.side, request.walls, radii, engine)) return *std::move(sites);
  }
}

template <int dim>
void set_weights(LaguerreSites<dim>& sites, const std::vector<double>& volumes, double tolerance) {
  const auto fitted = weights_for_volumes<dim>(sites, volumes, tolerance);
  for (std::size_t site = 0; site < sites.sites.size(); ++site) sites.sites[site].weight = fitted.weights[site];
}

/// Moves every site to the centroid of its cell. The new weight is the square of the distance to the nearest face: the
/// ball of this radius lies in the old cell, so it overlaps no other one and lies in the new cell, which has a volume.
template <int dim>
void move_to_centroids(LaguerreSites<dim>& sites) {
  const Tessellation<dim> tessellation(sites);
  for (std::size_t number = 0; number < sites.sites.size(); ++number) {
    const auto& cell = tessellation.cell(number);
    const Vector<dim> centroid = moments(cell).centroid;
    double radius = sites.side;
    for (const auto& face : cell.half_spaces()) radius = std::min(radius, -face.height(centroid));
    auto& site = sites.sites[number];
    for (std::size_t axis = 0; axis < dim; ++axis) {
      const double moved = site.position[axis] + centroid[axis];
      site.position[axis] =
          sites.walls == Walls::periodic ? wrapped(moved, sites.side) : std::clamp(moved, 0.0, sites.side);
    }
    site.weight = radius * radius;
  }
}

}  // namespace

template <int dim>
LaguerreSites<dim> random_sites(const RandomTessellationRequest& request) {
  require_meaning(request);
  const auto volumes = ball_volumes<dim>(request.diameters);
  auto sites = first_sites<dim>(request);
  for (int step = 0; step < request.centring_steps; ++step) {
    set_weights(sites, volumes, rough_tolerance);
    move_to_centroids(sites);
  }
  set_weights(sites, volumes, request.tolerance);
  return sites;
}

template LaguerreSites<2> random_sites<2>(const RandomTessellationRequest&);
template LaguerreSites<3> random_sites<3>(const RandomTessellationRequest&);

}  // namespace breccia
