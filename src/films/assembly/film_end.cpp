#include "films/assembly/film_end.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace breccia::films {
namespace {

/// An end of a film at a junction, and the direction [rad] in which the film leaves it.
struct FilmEnd {
  double direction;
  std::size_t film, end;
};

std::vector<std::vector<FilmEnd>> ends_at_junctions(const FilmNetwork& network) {
  std::vector<std::vector<FilmEnd>> ends(network.junctions.size());
  for (std::size_t film = 0; film < network.films.size(); ++film) {
    const auto& [sides, along, normal, thickness, junctions, segments] = network.films[film];
    ends[junctions[0]].push_back({std::atan2(along.y(), along.x()), film, 0});
    ends[junctions[1]].push_back({std::atan2(-along.y(), -along.x()), film, 1});
  }
  for (auto& at_junction : ends) std::ranges::sort(at_junction, {}, &FilmEnd::direction);
  return ends;
}

/// The angle [degrees] from one direction counter-clockwise to another.
double angle_between(const FilmEnd& from, const FilmEnd& to) {
  constexpr double turn = 2.0 * std::numbers::pi, half_a_turn_in_degrees = 180.0;
  const double angle = to.direction - from.direction;
  return (angle < 0.0 ? angle + turn : angle) * half_a_turn_in_degrees / std::numbers::pi;
}

}  // namespace

// The polynomial was fitted by tests/reference/film_end.py to the solutions of Stokes flow in 28 junctions with angles
// from 75 to 170 degrees; its error is less than 0.005.
double end_length(const std::array<double, 2>& angles) {
  constexpr double even = 120.0, least = -0.25, most = 0.3;
  const double mean = std::clamp(0.5 * (angles[0] + angles[1]) / even - 1.0, least, most);
  const double apart = (angles[0] - angles[1]) / even;
  return 0.2319 - 0.3735 * mean + 0.6698 * mean * mean - 0.1618 * apart * apart + 2.0580 * mean * mean * mean +
         0.4723 * mean * apart * apart;
}

std::vector<std::array<double, 2>> end_lengths(const FilmNetwork& network) {
  constexpr double even = 120.0;
  const double of_even_angles = end_length({even, even});
  std::vector<std::array<double, 2>> lengths(network.films.size(), {of_even_angles, of_even_angles});
  for (const auto& ends : ends_at_junctions(network)) {
    if (ends.size() != 3) continue;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const auto &one = ends[k], &next = ends[(k + 1) % ends.size()], &last = ends[(k + 2) % ends.size()];
      lengths[one.film][one.end] = end_length({angle_between(last, one), angle_between(one, next)});
    }
  }
  return lengths;
}

}  // namespace breccia::films
