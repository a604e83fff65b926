#include "breccia/microstructure/validity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "microstructure/close_pairs.hpp"
#include "microstructure/mistake_list.hpp"

namespace breccia {

namespace {

constexpr double roundoff = 1e-12;  // tolerance as a share of a diameter or of the side

template <int dim>
constexpr const char* ball_word = dim == 2 ? "disc" : "sphere";

template <int dim>
std::string name(std::size_t number, const Ball<dim>& ball) {
  return fmt::format("{} {} (diameter {:.6g} m at {:.6g} m)", ball_word<dim>, number + 1, ball.diameter,
                     fmt::join(ball.centre, " m, "));
}

bool is_inside(double coordinate, double side) {
  return coordinate >= 0.0 && coordinate <= side;
}

/// Distance of a ball's surface from the nearest side of the box [m]; negative where it crosses the side.
template <int dim>
double distance_from_sides(const Ball<dim>& ball, double side) {
  double smallest = side;
  for (const double x : ball.centre) smallest = std::min({smallest, x, side - x});
  return smallest - 0.5 * ball.diameter;
}

/// The mistakes in a single ball.
template <int dim>
std::vector<std::string> mistakes_of_balls(const Microstructure<dim>& microstructure) {
  const double side = microstructure.side;
  std::vector<std::string> mistakes;
  for (std::size_t k = 0; k < microstructure.particles.size(); ++k) {
    const auto& ball = microstructure.particles[k];
    const double room = distance_from_sides(ball, side);
    if (!(ball.diameter > 0.0) || !std::isfinite(ball.diameter)) {
      mistakes.push_back(fmt::format("{}: the diameter must be positive and finite", name(k, ball)));
    } else if (!std::ranges::all_of(ball.centre, [side](double x) { return is_inside(x, side); })) {
      mistakes.push_back(fmt::format("{}: the centre is outside the box", name(k, ball)));
    } else if (microstructure.walls == Walls::hard && room < -roundoff * side) {
      mistakes.push_back(fmt::format("{}: crosses a wall by {:.3g} m", name(k, ball), -room));
    } else if (microstructure.walls == Walls::periodic && ball.diameter > (1.0 + roundoff) * side) {
      mistakes.push_back(fmt::format("{}: overlaps its own periodic image", name(k, ball)));
    }
  }
  return mistakes;
}

/// A message for each pair of balls that overlap, in the order of their numbers.
template <int dim>
std::vector<std::string> overlaps(const Microstructure<dim>& microstructure) {
  struct Overlap {
    std::pair<std::uint32_t, std::uint32_t> pair;
    double depth = 0.0;
  };
  const auto& balls = microstructure.particles;
  std::vector<Overlap> found;
  visit_close_pairs<dim>(microstructure.side, microstructure.walls, balls, 0.0,
                         [&](std::uint32_t ball, std::uint32_t other, double gap) {
                           if (-gap <= roundoff * std::max(balls[ball].diameter, balls[other].diameter)) return;
                           found.push_back({std::minmax({ball, other}), -gap});
                         });
  std::ranges::sort(found, {}, &Overlap::pair);
  std::vector<std::string> mistakes;
  mistakes.reserve(found.size());
  for (const auto& [pair, depth] : found) {
    mistakes.push_back(fmt::format("{} and {} overlap by {:.3g} m", name(pair.first, balls[pair.first]),
                                   name(pair.second, balls[pair.second]), depth));
  }
  return mistakes;
}

}  // namespace

template <int dim>
void require_valid(const Microstructure<dim>& microstructure) {
  if (!(microstructure.side > 0.0) || !std::isfinite(microstructure.side)) {
    throw InputError(
        fmt::format("microstructure: the side of the box must be positive, got {} m", microstructure.side));
  }
  auto mistakes = mistakes_of_balls(microstructure);
  if (mistakes.empty()) mistakes = overlaps(microstructure);
  require_no_mistakes(mistakes, microstructure.side, fmt::format("{}s", ball_word<dim>));
}

template void require_valid(const Microstructure<2>&);
template void require_valid(const Microstructure<3>&);

}  // namespace breccia
