#include "breccia/microstructure/ellipsoid_box.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/mistake_list.hpp"
#include "microstructure/near_pairs.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {
namespace {

constexpr double share_of_roundoff = 1e-12;  // tolerance as a share of an axis or of the side

Ellipsoid moved_to(const Ellipsoid& ellipsoid, const Vector<3>& centre) {
  auto moved = ellipsoid;
  moved.centre = centre;
  return moved;
}

/// Calls visit(particle, other, gap) for every pair of particles whose coated surfaces are nearer than `reach` [m],
/// once for each image in a periodic box. The gap is that between the coatings.
template <class Visit>
void visit_ellipsoid_pairs(const EllipsoidBox& box, double reach, Visit&& visit) {
  std::vector<Vector<3>> centres;
  std::vector<double> radii;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    centres.push_back(box.particles[particle].centre);
    radii.push_back(circumradius(box.particles[particle]) + box.coating_of(particle));
  }
  visit_near_pairs<3>(box.side, box.walls, centres, radii, reach,
                      [&](std::uint32_t number, std::uint32_t behind, const Vector<3>& seen) {
                        const double coatings = box.coating_of(number) + box.coating_of(behind);
                        if (norm(seen - centres[number]) - radii[number] - radii[behind] >= reach) return;
                        const auto& one = box.particles[number];
                        const double width = gap(one, moved_to(box.particles[behind], seen)) - coatings;
                        if (width < reach) visit(number, behind, width);
                      });
}

/// Smallest distance between a particle with its coating and its own images [m].
double gap_to_own_images(const EllipsoidBox& box, std::size_t number) {
  const auto& particle = box.particles[number];
  double smallest = std::numeric_limits<double>::infinity();
  for_each_index(Index<3>{-1, -1, -1}, Index<3>{2, 2, 2}, [&](const Index<3>& image) {
    if (image == Index<3>{}) return;
    auto centre = particle.centre;
    for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] += image[axis] * box.side;
    smallest = std::min(smallest, gap(particle, moved_to(particle, centre)));
  });
  return smallest - 2.0 * box.coating_of(number);
}

/// Distance between a particle with its coating and the nearest side of the box [m]; negative where it crosses one.
double room(const EllipsoidBox& box, std::size_t number) {
  const auto& particle = box.particles[number];
  const auto reach = extent(particle);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = particle.centre[axis];
    smallest = std::min({smallest, x - reach[axis], box.side - x - reach[axis]});
  }
  return smallest - box.coating_of(number);
}

bool are_perpendicular(const AxisDirections& directions) {
  constexpr double tolerance = 1e-9;
  for (std::size_t one = 0; one < 3; ++one) {
    for (std::size_t other = 0; other <= one; ++other) {
      const double wanted = one == other ? 1.0 : 0.0;
      if (!(std::abs(dot(directions[one], directions[other]) - wanted) <= tolerance)) return false;
    }
  }
  return true;
}

std::string name(const EllipsoidBox& box, std::size_t number) {
  const auto& [centre, axes, directions] = box.particles[number];
  return fmt::format("particle {} (ellipsoid of {:.6g} m x {:.6g} m x {:.6g} m at {:.6g} m, {:.6g} m, {:.6g} m)",
                     number + 1, axes[0], axes[1], axes[2], centre[0], centre[1], centre[2]);
}

/// The mistake in a single particle; empty if there is none.
std::string mistake_of(const EllipsoidBox& box, std::size_t number) {
  const auto& [centre, axes, directions] = box.particles[number];
  const auto is_length = [](double axis) { return axis > 0.0 && std::isfinite(axis); };
  const auto is_inside = [&](double x) { return x >= 0.0 && x <= box.side; };
  const double roundoff = share_of_roundoff * box.side;
  if (!std::ranges::all_of(axes, is_length)) return "its axes must be positive and finite";
  if (!are_perpendicular(directions)) {
    return "the directions of its axes must be of length 1 and perpendicular to each other";
  }
  if (!std::ranges::all_of(centre, is_inside)) return "the centre is outside the box";
  if (box.walls == Walls::hard) {
    const double distance = room(box, number);
    return distance < -roundoff ? fmt::format("crosses a wall by {:.3g} m", -distance) : "";
  }
  const bool is_too_large = circumradius(box.particles[number]) + box.coating_of(number) > box.side;
  return is_too_large || gap_to_own_images(box, number) < -roundoff ? "overlaps its own periodic image" : "";
}

/// Particles that overlap, in the order of their numbers.
std::vector<std::string> overlaps_of_ellipsoids(const EllipsoidBox& box) {
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, double>> found;
  visit_ellipsoid_pairs(box, 0.0, [&](std::uint32_t one, std::uint32_t other, double width) {
    const double larger = std::max(circumradius(box.particles[one]), circumradius(box.particles[other]));
    if (-width > share_of_roundoff * larger) found.emplace_back(std::minmax(one, other), -width);
  });
  std::ranges::sort(found);
  std::vector<std::string> mistakes;
  mistakes.reserve(found.size());
  for (const auto& [pair, depth] : found) {
    mistakes.push_back(
        fmt::format("{} and {} overlap by {:.3g} m", name(box, pair.first), name(box, pair.second), depth));
  }
  return mistakes;
}

}  // namespace

double volume_fraction(const EllipsoidBox& box) {
  double sum = 0.0;
  for (const auto& particle : box.particles) sum += volume(particle);
  return sum / times_power<3>(1.0, box.side);
}

double coating_fraction(const EllipsoidBox& box) {
  double sum = 0.0;
  for (std::size_t number = 0; number < box.particles.size(); ++number) {
    sum += coating_volume(box.particles[number], box.coating_of(number));
  }
  return sum / times_power<3>(1.0, box.side);
}

std::optional<Microstructure<3>> as_balls(const EllipsoidBox& box) {
  Microstructure<3> balls = {box.side, box.walls, {}, box.fillers};
  for (const auto& [centre, axes, directions] : box.particles) {
    if (axes[0] != axes[1] || axes[0] != axes[2]) return std::nullopt;
    balls.particles.push_back({centre, axes[0]});
  }
  return balls;
}

double specific_surface(const EllipsoidBox& box) {
  double sum = 0.0;
  for (const auto& particle : box.particles) sum += surface(particle);
  return sum / times_power<3>(1.0, box.side);
}

double smallest_gap(const EllipsoidBox& box) {
  double smallest = std::numeric_limits<double>::infinity();
  if (box.walls == Walls::periodic) {
    for (std::size_t number = 0; number < box.particles.size(); ++number) {
      smallest = std::min(smallest, gap_to_own_images(box, number));
    }
  }
  if (box.particles.size() < 2) return smallest;
  const double diagonal = std::numbers::sqrt3 * box.side;
  double reach = 0.1 * box.side / std::cbrt(static_cast<double>(box.particles.size()));
  bool is_found = false;
  for (; !is_found && reach < 4.0 * diagonal; reach *= 4.0) {
    visit_ellipsoid_pairs(box, reach, [&](std::uint32_t, std::uint32_t, double width) {
      is_found = true;
      smallest = std::min(smallest, width);
    });
  }
  return smallest;
}

double smallest_wall_gap(const EllipsoidBox& box) {
  double smallest = std::numeric_limits<double>::infinity();
  if (box.walls == Walls::periodic) return smallest;
  for (std::size_t number = 0; number < box.particles.size(); ++number) {
    smallest = std::min(smallest, room(box, number));
  }
  return smallest;
}

double smallest_side_distance(const EllipsoidBox& box) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t number = 0; number < box.particles.size(); ++number) {
    smallest = std::min(smallest, room(box, number) + box.coating_of(number));
  }
  return smallest;
}

void require_valid(const EllipsoidBox& box) {
  if (!(box.side > 0.0) || !std::isfinite(box.side)) {
    throw InputError(fmt::format("microstructure: the side of the box must be positive, got {} m", box.side));
  }
  std::vector<std::string> mistakes;
  for (std::size_t number = 0; number < box.particles.size(); ++number) {
    const auto mistake = mistake_of(box, number);
    if (!mistake.empty()) mistakes.push_back(fmt::format("{}: {}", name(box, number), mistake));
  }
  if (mistakes.empty()) mistakes = overlaps_of_ellipsoids(box);
  require_no_mistakes(mistakes, box.side, "particles");
}

}  // namespace breccia
