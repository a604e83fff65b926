#include "homogenisation/box/shaped_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr const char* name_of_corner_counts = "/particle_corners";  // number of corners; 0 for an ellipse
constexpr const char* name_of_ellipsoids = "/ellipsoids";           // numbers of the ellipsoids, one after the other
constexpr const char* refusal = "a checkpoint of a packing: expected ellipses and polygons in a box";

/// Two numbers each of the shapes: the axes of an ellipse, or the corners of a polygon.
std::vector<Vector<2>> numbers_of(const Shape& shape) {
  if (const auto* ellipse = std::get_if<Ellipse>(&shape)) return {ellipse->axes};
  const auto corners = std::get<ConvexPolygon>(shape).corners();
  return {corners.begin(), corners.end()};
}

bool is_length(double length) {
  return length > 0.0 && std::isfinite(length);
}

Shape shape_of(std::vector<Vector<2>> numbers, bool is_ellipse) {
  if (!is_ellipse) return ConvexPolygon(std::move(numbers));
  const auto& [first, second] = numbers.front();
  if (!is_length(first) || !is_length(second)) throw FileError(refusal);
  return Ellipse{numbers.front()};
}

}  // namespace

void save_particles(StateWriter& state, const std::vector<Particle>& particles) {
  std::vector<double> x, y, angles, corners, first, second;
  for (const auto& [shape, pose] : particles) {
    x.push_back(pose.centre()[0]);
    y.push_back(pose.centre()[1]);
    angles.push_back(pose.angle());
    const auto numbers = numbers_of(shape);
    corners.push_back(std::holds_alternative<Ellipse>(shape) ? 0.0 : static_cast<double>(numbers.size()));
    for (const auto& [one, other] : numbers) {
      first.push_back(one);
      second.push_back(other);
    }
  }
  state.write("/particle_x_m", x);
  state.write("/particle_y_m", y);
  state.write("/particle_angle_rad", angles);
  state.write(name_of_corner_counts, corners);
  state.write("/particle_shape_x_m", first);
  state.write("/particle_shape_y_m", second);
}

bool has_particles(const StateReader& state) {
  return state.has(name_of_corner_counts);
}

std::vector<Particle> read_particles(const StateReader& state) {
  const auto corners = state.numbers(name_of_corner_counts);
  const auto x = state.numbers("/particle_x_m", corners.size()), y = state.numbers("/particle_y_m", corners.size());
  const auto angles = state.numbers("/particle_angle_rad", corners.size());
  const auto first = state.numbers("/particle_shape_x_m");
  const auto second = state.numbers("/particle_shape_y_m", first.size());
  std::vector<Particle> particles;
  std::size_t next = 0;
  for (std::size_t particle = 0; particle < corners.size(); ++particle) {
    const bool is_ellipse = corners[particle] == 0.0;
    const double count = is_ellipse ? 1.0 : corners[particle];
    const bool is_count = count >= 1.0 && count <= static_cast<double>(first.size() - next);
    if (!is_count || !std::isfinite(x[particle] + y[particle] + angles[particle])) throw FileError(refusal);
    std::vector<Vector<2>> numbers;
    for (const auto end = next + static_cast<std::size_t>(count); next < end; ++next) {
      numbers.push_back({first[next], second[next]});
    }
    try {
      particles.push_back(
          {shape_of(std::move(numbers), is_ellipse), Pose({x[particle], y[particle]}, angles[particle])});
    } catch (const InputError&) {
      throw FileError(refusal);
    }
  }
  return particles;
}

namespace {

constexpr std::size_t numbers_of_an_ellipsoid = 15;

/// Centre, axes and directions of the axes.
std::array<Vector<3>*, 5> vectors_of(Ellipsoid& ellipsoid) {
  auto& [centre, half_axes, directions] = ellipsoid;
  return {&centre, &half_axes, &directions[0], &directions[1], &directions[2]};
}

}  // namespace

void save_ellipsoids(StateWriter& state, const std::vector<Ellipsoid>& ellipsoids) {
  std::vector<double> numbers;
  for (auto ellipsoid : ellipsoids) {
    for (const auto* vector : vectors_of(ellipsoid)) numbers.insert(numbers.end(), vector->begin(), vector->end());
  }
  state.write(name_of_ellipsoids, numbers);
}

bool has_ellipsoids(const StateReader& state) {
  return state.has(name_of_ellipsoids);
}

std::vector<Ellipsoid> read_ellipsoids(const StateReader& state) {
  const auto numbers = state.numbers(name_of_ellipsoids);
  const bool are_finite = std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  if (numbers.size() % numbers_of_an_ellipsoid != 0 || !are_finite) throw FileError(refusal);
  std::vector<Ellipsoid> ellipsoids(numbers.size() / numbers_of_an_ellipsoid);
  auto next = numbers.begin();
  for (auto& ellipsoid : ellipsoids) {
    for (auto* vector : vectors_of(ellipsoid)) {
      for (double& number : *vector) number = *next++;
    }
    if (!std::ranges::all_of(ellipsoid.axes, is_length)) throw FileError(refusal);
  }
  return ellipsoids;
}

}  // namespace breccia
