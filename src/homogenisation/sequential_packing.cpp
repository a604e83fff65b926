#include "sequential_packing.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "breccia/io/display.hpp"
#include "breccia/study/filler_shapes.hpp"
#include "breccia/study/filler_sizes.hpp"
#include "breccia/study/gap.hpp"

namespace breccia {

namespace {

/// What keeps particles of a filler apart from others and from hard walls [m].
struct Distances {
  double shell = 0.0;
  double wall = 0.0;
};

Distances distances_of(const Stage& stage, const Filler& filler) {
  const double smallest_gap = std::ranges::min(stage.fillers, {}, &Filler::gap).gap;
  const double coating = filler.coating_thickness();
  return {coating + 0.5 * filler.gap, coating + 0.5 * (filler.gap + smallest_gap)};
}

double diameter_of(const ParticleToPlace& particle) {
  return equivalent_diameter(particle.shape);
}
double diameter_of(const EllipsoidToPlace& particle) {
  return equivalent_diameter(Ellipsoid{{}, particle.axes});
}
double length_of(const ParticleToPlace& particle) {
  return 2.0 * circumradius(particle.shape);
}
double length_of(const EllipsoidToPlace& particle) {
  return std::ranges::max(particle.axes);
}

template <class Request>
std::string message_on_request(const Stage& stage, const Request& request, const PackingError& error) {
  const auto size = [](const auto& particle) { return diameter_of(particle); };
  const double largest = size(std::ranges::max(request.particles, {}, size));
  if (error.obstacle() == PackingObstacle::size) {
    const auto length = [](const auto& particle) { return length_of(particle); };
    const double longest = length(std::ranges::max(request.particles, {}, length));
    return fmt::format(
        "a particle {} long that keeps a gap of {} does not fit into a box of {}; expected smaller particles",
        display(longest, "m"), gaps_in_words(stage), display(stage.side, "m"));
  }
  const double smallest = size(std::ranges::min(request.particles, {}, size));
  const auto sizes = smallest == largest ? display(largest, "m")
                                         : fmt::format("{} to {}", display(smallest, "m"), display(largest, "m"));
  const auto asked = fraction_asked_of(stage);
  return fmt::format(
      "{} particles of {} (diameters of {}){} with a gap of {} jam: with their coatings and half of the gap around "
      "each they are stuck at {:.1f} % of the box; expected a smaller fraction or gap, or a wider range of sizes",
      request.particles.size(), sizes, Request::dim == 3 ? "balls of equal volume" : "discs of equal area",
      asked ? fmt::format(" at a fraction of {:.6g}", *asked) : "", gaps_in_words(stage),
      100.0 * error.attainable_fraction());
}

}  // namespace

RandomSequentialRequest sequential_request(const Stage& stage, const RandomSequentialPacking& method,
                                           const DrawnParticles& drawn) {
  RandomSequentialRequest request = {.side = stage.side, .walls = method.walls, .particles = {}, .seed = method.seed};
  for (std::size_t particle = 0; particle < drawn.diameters.size(); ++particle) {
    const auto& filler = stage.fillers[drawn.fillers[particle]];
    const auto [shell, wall] = distances_of(stage, filler);
    request.particles.push_back({.shape = shape_of(filler, drawn.diameters[particle]),
                                 .angle = filler.shape ? filler.shape->angle : std::nullopt,
                                 .shell = shell,
                                 .wall_distance = wall});
  }
  return request;
}

EllipsoidSequentialRequest ellipsoid_request(const Stage& stage, const RandomSequentialPacking& method,
                                             const DrawnParticles& drawn) {
  EllipsoidSequentialRequest request = {
      .side = stage.side, .walls = method.walls, .particles = {}, .seed = method.seed};
  for (std::size_t particle = 0; particle < drawn.diameters.size(); ++particle) {
    const auto& filler = stage.fillers[drawn.fillers[particle]];
    const auto [shell, wall] = distances_of(stage, filler);
    request.particles.push_back(
        {.axes = axes_of(filler, drawn.diameters[particle]), .shell = shell, .wall_distance = wall});
  }
  return request;
}

ParticleBox packed_box(const Stage& stage, const RandomSequentialRequest& request, const std::vector<Pose>& poses,
                       std::vector<std::size_t> fillers) {
  if (stage.fillers.size() == 1) fillers.clear();
  ParticleBox box = {stage.side, request.walls, {}, std::move(fillers), {}};
  for (std::size_t particle = 0; particle < poses.size(); ++particle) {
    box.particles.push_back({request.particles[particle].shape, poses[particle]});
  }
  box.coatings = coatings_of(stage, box.fillers, box.particles.size());
  return box;
}

EllipsoidBox packed_ellipsoids(const Stage& stage, const EllipsoidSequentialRequest& request,
                               const std::vector<EllipsoidPose>& poses, std::vector<std::size_t> fillers) {
  if (stage.fillers.size() == 1) fillers.clear();
  EllipsoidBox box = {stage.side, request.walls, {}, std::move(fillers), {}};
  for (std::size_t particle = 0; particle < poses.size(); ++particle) {
    const auto& [centre, quaternion] = poses[particle];
    box.particles.push_back({centre, request.particles[particle].axes, turned(quaternion)});
  }
  box.coatings = coatings_of(stage, box.fillers, box.particles.size());
  return box;
}

std::string message_on(const Stage& stage, const RandomSequentialRequest& request, const PackingError& error) {
  return message_on_request(stage, request, error);
}

std::string message_on(const Stage& stage, const EllipsoidSequentialRequest& request, const PackingError& error) {
  return message_on_request(stage, request, error);
}

}  // namespace breccia
