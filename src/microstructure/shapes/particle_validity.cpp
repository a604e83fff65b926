#include "microstructure/shapes/particle_validity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/mistake_list.hpp"
#include "microstructure/shapes/particle_pairs.hpp"

namespace breccia {
namespace {

constexpr double roundoff = 1e-12;  // tolerance as a share of a diameter or of the side

std::string name(const ParticleBox& box, std::size_t number) {
  const auto& [shape, pose] = box.particles[number];
  return fmt::format("particle {} ({} at {:.6g} m, {:.6g} m)", number + 1, in_words(shape), pose.centre()[0],
                     pose.centre()[1]);
}

bool has_size(const Shape& shape) {
  const auto* ellipse = std::get_if<Ellipse>(&shape);
  const auto is_length = [](double axis) { return axis > 0.0 && std::isfinite(axis); };
  return ellipse == nullptr || std::ranges::all_of(ellipse->axes, is_length);
}

/// Distance between a particle with its coating and the nearest wall [m].
double room(const ParticleBox& box, std::size_t number) {
  const ParticleBox alone = {box.side, Walls::hard, {box.particles[number]}};
  return smallest_wall_gap(alone) - box.coating_of(number);
}

/// The mistakes in single particles.
std::vector<std::string> mistakes_of_particles(const ParticleBox& box) {
  const auto is_outside = [&](double x) { return !(x >= 0.0 && x <= box.side); };
  std::vector<std::string> mistakes;
  for (std::size_t number = 0; number < box.particles.size(); ++number) {
    const auto& particle = box.particles[number];
    if (!has_size(particle.shape)) {
      mistakes.push_back(fmt::format("{}: its axes must be positive and finite", name(box, number)));
    } else if (std::ranges::any_of(particle.pose.centre(), is_outside)) {
      mistakes.push_back(fmt::format("{}: the centre is outside the box", name(box, number)));
    } else if (box.walls == Walls::hard && room(box, number) < -roundoff * box.side) {
      mistakes.push_back(fmt::format("{}: crosses a wall by {:.3g} m", name(box, number), -room(box, number)));
    } else if (box.walls == Walls::periodic &&
               (gap_to_own_images(particle, box.side) - 2.0 * box.coating_of(number) < -roundoff * box.side ||
                circumradius(particle.shape) + box.coating_of(number) > box.side)) {
      mistakes.push_back(fmt::format("{}: overlaps its own periodic image", name(box, number)));
    }
  }
  return mistakes;
}

/// A message for each pair of particles that overlap, in the order of their numbers.
std::vector<std::string> overlaps(const ParticleBox& box) {
  struct Overlap {
    std::pair<std::uint32_t, std::uint32_t> pair;
    double depth = 0.0;
  };
  std::vector<Overlap> found;
  const double thickest = box.coatings.empty() ? 0.0 : std::ranges::max(box.coatings);
  visit_particle_pairs(box, 2.0 * thickest, [&](std::uint32_t one, std::uint32_t other, double width) {
    const double depth = box.coating_of(one) + box.coating_of(other) - width;
    const double larger = std::max(circumradius(box.particles[one].shape), circumradius(box.particles[other].shape));
    if (depth > roundoff * larger) found.push_back({std::minmax(one, other), depth});
  });
  std::ranges::sort(found, {}, &Overlap::pair);
  std::vector<std::string> mistakes;
  mistakes.reserve(found.size());
  for (const auto& [pair, depth] : found) {
    mistakes.push_back(
        fmt::format("{} and {} overlap by {:.3g} m", name(box, pair.first), name(box, pair.second), depth));
  }
  return mistakes;
}

}  // namespace

void require_valid(const ParticleBox& box) {
  if (!(box.side > 0.0) || !std::isfinite(box.side)) {
    throw InputError(fmt::format("microstructure: the side of the box must be positive, got {} m", box.side));
  }
  auto mistakes = mistakes_of_particles(box);
  if (mistakes.empty()) mistakes = overlaps(box);
  require_no_mistakes(mistakes, box.side, "particles");
}

}  // namespace breccia
