#include "homogenisation/box/stage_microstructure_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/box/microstructure_measures.hpp"
#include "homogenisation/box/shaped_state.hpp"
#include "study/filler_shapes.hpp"

namespace breccia {

namespace {

constexpr const char* name_of_film = "/film_m";
constexpr const char* name_of_film_shares = "/site_film_share";

std::string name_of_size_deviation(std::size_t filler) {
  return fmt::format("/size_deviation/{}", filler);
}

/// The filler numbers of so many particles; empty where all belong to the first filler. Throws FileError where a number
/// does not belong to any filler.
std::vector<std::size_t> read_fillers(const StateReader& state, const Stage& stage, std::size_t particles) {
  std::vector<std::size_t> read;
  if (!state.has("/filler")) return read;
  for (const double number : state.numbers("/filler", particles)) {
    const bool is_filler =
        number >= 0.0 && number < static_cast<double>(stage.fillers.size()) && number == std::floor(number);
    if (!is_filler) throw FileError("a checkpoint of a packing: expected particles of the fillers of its stage");
    read.push_back(static_cast<std::size_t>(number));
  }
  return read;
}

constexpr const char* refusal_of_grains = "a checkpoint of a packing: expected grains and films in a box";
constexpr const char* name_of_weights = "/site_weight_m2";
constexpr std::array names_of_site_axes = {"/site_x_m", "/site_y_m", "/site_z_m"};

constexpr std::array names_of_axes = {"/x_m", "/y_m", "/z_m"};

void save_sides(StateWriter& state, double side, Walls walls) {
  state.write("/side_m", side);
  state.write("/walls", static_cast<std::int64_t>(walls));
}

void save_fillers(StateWriter& state, const std::vector<std::size_t>& fillers) {
  if (!fillers.empty()) state.write("/filler", std::vector<double>(fillers.begin(), fillers.end()));
}

/// Writes a box: a visitor of its content. The pixels of an image are not written, since the stage has them.
struct SaveContent {
  StateWriter& state;

  template <int dim>
  void operator()(const Microstructure<dim>& microstructure) const {
    const auto& [side, walls, balls, fillers] = microstructure;
    save_sides(state, side, walls);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
      std::vector<double> along;
      along.reserve(balls.size());
      for (const auto& ball : balls) along.push_back(ball.centre[axis]);
      state.write(names_of_axes[axis], along);
    }
    std::vector<double> diameters;
    diameters.reserve(balls.size());
    for (const auto& ball : balls) diameters.push_back(ball.diameter);
    state.write("/diameter_m", diameters);
    save_fillers(state, fillers);
  }
  void operator()(const ParticleBox& box) const {
    save_sides(state, box.side, box.walls);
    save_particles(state, box.particles);
    save_fillers(state, box.fillers);
  }
  void operator()(const EllipsoidBox& box) const {
    save_sides(state, box.side, box.walls);
    save_ellipsoids(state, box.particles);
    save_fillers(state, box.fillers);
  }
  template <int dim>
  void operator()(const Grains<dim>& grains) const {
    const auto& sites = grains.sites.sites;
    save_sides(state, grains.sites.side, grains.sites.walls);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
      std::vector<double> along;
      along.reserve(sites.size());
      for (const auto& site : sites) along.push_back(site.position[axis]);
      state.write(names_of_site_axes[axis], along);
    }
    std::vector<double> weights;
    weights.reserve(sites.size());
    for (const auto& site : sites) weights.push_back(site.weight);
    state.write(name_of_weights, weights);
    if (!grains.sites.film_shares.empty()) state.write(name_of_film_shares, grains.sites.film_shares);
    state.write(name_of_film, grains.statistics.film);
  }
  template <int dim>
  void operator()(const SharedImage<dim>& image) const {
    save_sides(state, box_of(*image)[0], image->walls);
  }
};

/// Reads the side [m] and the walls of a box. Throws FileError where the state has none.
std::pair<double, Walls> read_sides(const StateReader& state, const char* content) {
  const double side = state.number("/side_m");
  const auto walls = static_cast<Walls>(state.integer("/walls"));
  const bool has_walls = walls == Walls::hard || walls == Walls::periodic;
  if (has_walls && side > 0.0 && std::isfinite(side)) return {side, walls};
  throw FileError(fmt::format("a checkpoint of a packing: expected {} in a box", content));
}

template <int dim>
Microstructure<dim> read_balls(const StateReader& state, const Stage& stage) {
  constexpr auto balls = dim == 2 ? "discs" : "spheres";
  const auto [side, walls] = read_sides(state, balls);
  Microstructure<dim> read = {side, walls, {}};
  for (const double diameter : state.numbers("/diameter_m")) read.particles.push_back({{}, diameter});
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    const auto along = state.numbers(names_of_axes[axis], read.particles.size());
    for (std::size_t i = 0; i < along.size(); ++i) read.particles[i].centre[axis] = along[i];
  }
  const auto is_in_box = [&read](const Ball<dim>& ball) {
    const auto is_within = [&read](double value) { return value >= 0.0 && value <= read.side; };
    return std::ranges::all_of(ball.centre, is_within) && is_within(ball.diameter) && ball.diameter > 0.0;
  };
  if (!std::ranges::all_of(read.particles, is_in_box)) {
    throw FileError(fmt::format("a checkpoint of a packing: expected {} in a box", balls));
  }
  read.fillers = read_fillers(state, stage, read.particles.size());
  return read;
}

/// Reads particles of other shapes than discs or spheres.
template <int dim>
ShapedParticles<dim> read_shaped(const StateReader& state, const Stage& stage) {
  const auto [side, walls] = read_sides(state, "particles");
  ShapedParticles<dim> box = {side, walls};
  if constexpr (dim == 2) {
    box.particles = read_particles(state);
  } else {
    box.particles = read_ellipsoids(state);
  }
  box.fillers = read_fillers(state, stage, box.particles.size());
  box.coatings = coatings_of(stage, box.fillers, box.particles.size());
  return box;
}

template <int dim>
Grains<dim> read_grains(const StateReader& state, const Stage& stage) {
  const auto [side, walls] = read_sides(state, "grains and films");
  const auto* const method = stage.packed_by<LaguerrePacking<dim>>();
  const auto wall_film = method == nullptr ? WallFilm::half : method->wall_film;
  Grains<dim> grains = {{side, walls, {}, wall_film}, {.film = state.number(name_of_film)}};
  if (!(grains.statistics.film >= 0.0 && std::isfinite(grains.statistics.film))) throw FileError(refusal_of_grains);
  auto& sites = grains.sites.sites;
  for (const double weight : state.numbers(name_of_weights)) sites.push_back({{}, weight});
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    const auto along = state.numbers(names_of_site_axes[axis], sites.size());
    for (std::size_t site = 0; site < along.size(); ++site) sites[site].position[axis] = along[site];
  }
  if (state.has(name_of_film_shares)) grains.sites.film_shares = state.numbers(name_of_film_shares, sites.size());
  if (!mistakes(grains.sites).empty()) throw FileError(refusal_of_grains);
  return grains;
}

template <int dim>
Box<dim> read_box(const StateReader& state, const Stage& stage) {
  if (const auto* pixels = stage.packed_by<ImagePacking<dim>>()) return pixels->image;
  if (state.has(name_of_film)) return read_grains<dim>(state, stage);
  if (dim == 2 ? has_particles(state) : has_ellipsoids(state)) return read_shaped<dim>(state, stage);
  return read_balls<dim>(state, stage);
}

}  // namespace

void save(StateWriter& state, const StageMicrostructure& microstructure) {
  visit_nested(SaveContent{state}, microstructure.box);
  for (std::size_t number = 0; number < microstructure.fillers.size(); ++number) {
    const auto deviation = microstructure.fillers[number].size_deviation;
    if (deviation) state.write(name_of_size_deviation(number), *deviation);
  }
  state.write("/events", static_cast<std::int64_t>(microstructure.events));
  state.write(packing_seconds_name, microstructure.seconds);
}

StageMicrostructure read_stage_microstructure(const StateReader& state, const Stage& stage) {
  StageMicrostructure result;
  if (stage.dimensions() == 3) {
    result.box = read_box<3>(state, stage);
  } else {
    result.box = read_box<2>(state, stage);
  }
  result.fillers.resize(stage.fillers.size());
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto name = name_of_size_deviation(number);
    if (state.has(name)) result.fillers[number].size_deviation = state.number(name);
  }
  result.events = static_cast<std::uint64_t>(state.integer("/events"));
  result.seconds = state.number(packing_seconds_name);
  measure(stage, result);
  return result;
}

}  // namespace breccia
