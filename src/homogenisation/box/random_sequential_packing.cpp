#include "homogenisation/box/random_sequential_packing.hpp"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sequential.hpp"

#include "homogenisation/box/drawn_particles.hpp"
#include "homogenisation/box/simplest_box.hpp"
#include "io/display.hpp"
#include "study/filler_shapes.hpp"
#include "study/filler_sizes.hpp"
#include "study/gap.hpp"

namespace breccia {
namespace {

template <int dim>
using SequentialRequest = std::conditional_t<dim == 2, RandomSequentialRequest, EllipsoidSequentialRequest>;

/// The distances that particles of a filler keep from others and from hard walls [m].
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
std::string message_on(const Stage& stage, const Request& request, const PackingError& error) {
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

ParticleToPlace to_place(const Filler& filler, double diameter, const Distances& distances, RandomSequentialRequest*) {
  return {.shape = shape_of(filler, diameter),
          .angle = filler.shape ? filler.shape->angle : std::nullopt,
          .shell = distances.shell,
          .wall_distance = distances.wall};
}

EllipsoidToPlace to_place(const Filler& filler, double diameter, const Distances& distances,
                          EllipsoidSequentialRequest*) {
  return {.axes = axes_of(filler, diameter), .shell = distances.shell, .wall_distance = distances.wall};
}

/// The particles of a stage, with their shapes, coatings and gaps. They keep the whole gap to a wall, too: the boundary
/// there is as rigid as a particle.
template <int dim>
SequentialRequest<dim> request_of(const Stage& stage, const RandomSequentialPacking<dim>& method,
                                  const DrawnParticles& drawn) {
  SequentialRequest<dim> request = {.side = stage.side, .walls = method.walls, .particles = {}, .seed = method.seed};
  for (std::size_t particle = 0; particle < drawn.diameters.size(); ++particle) {
    const auto& filler = stage.fillers[drawn.fillers[particle]];
    request.particles.push_back(to_place(filler, drawn.diameters[particle], distances_of(stage, filler), &request));
  }
  return request;
}

Particle placed_at(const ParticleToPlace& particle, const Pose& pose) {
  return {particle.shape, pose};
}
Ellipsoid placed_at(const EllipsoidToPlace& particle, const EllipsoidPose& pose) {
  return {pose.centre, particle.axes, turned(pose.quaternion)};
}

}  // namespace

template <int dim>
PlacedBox<dim> placed(const Stage& stage, const RandomSequentialPacking<dim>& method, PackingRunner& runner) {
  auto drawn = draw_particles<dim>(stage);
  const auto request = request_of(stage, method, drawn);
  if (stage.fillers.size() == 1) drawn.fillers.clear();
  try {
    SequentialRun<SequentialRequest<dim>> run(request);
    runner.run(run);
    const auto poses = run.poses();
    ShapedParticles<dim> box = {stage.side, method.walls, {}, std::move(drawn.fillers), {}};
    for (std::size_t particle = 0; particle < poses.size(); ++particle) {
      box.particles.push_back(placed_at(request.particles[particle], poses[particle]));
    }
    box.coatings = coatings_of(stage, box.fillers, box.particles.size());
    return {.box = simplest_box(std::move(box)),
            .size_deviations = std::move(drawn.size_deviations),
            .events = run.progress().events};
  } catch (const PackingError& error) {
    throw NumericalError(message_on(stage, request, error));
  }
}

template PlacedBox<2> placed(const Stage&, const RandomSequentialPacking<2>&, PackingRunner&);
template PlacedBox<3> placed(const Stage&, const RandomSequentialPacking<3>&, PackingRunner&);

}  // namespace breccia
