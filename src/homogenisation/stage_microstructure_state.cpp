#include "breccia/homogenisation/stage_microstructure_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/study/filler_shapes.hpp"

#include "microstructure_measures.hpp"
#include "shaped_state.hpp"

namespace breccia {

namespace {

constexpr const char* name_of_film = "/film_m";
constexpr const char* name_of_film_shares = "/site_film_share";

std::string name_of_size_deviation(std::size_t filler) {
  return fmt::format("/size_deviation/{}", filler);
}

/// The numbers of the fillers of particles. Throws FileError where one is that of no filler.
std::vector<std::size_t> filler_numbers(const std::vector<double>& numbers, std::size_t fillers) {
  std::vector<std::size_t> read;
  for (const double number : numbers) {
    const bool is_filler = number >= 0.0 && number < static_cast<double>(fillers) && number == std::floor(number);
    if (!is_filler) throw FileError("a checkpoint of a packing: expected particles of the fillers of its stage");
    read.push_back(static_cast<std::size_t>(number));
  }
  return read;
}

constexpr const char* refusal_of_grains = "a checkpoint of a packing: expected grains and films in a box";
constexpr const char* name_of_weights = "/site_weight_m2";
constexpr std::array names_of_site_axes = {"/site_x_m", "/site_y_m", "/site_z_m"};

template <int dim>
void save_sites(StateWriter& state, const LaguerreSites<dim>& grains) {
  const auto& sites = grains.sites;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    std::vector<double> along;
    for (const auto& site : sites) along.push_back(site.position[axis]);
    state.write(names_of_site_axes[axis], along);
  }
  std::vector<double> weights;
  for (const auto& site : sites) weights.push_back(site.weight);
  state.write(name_of_weights, weights);
  if (!grains.film_shares.empty()) state.write(name_of_film_shares, grains.film_shares);
}

template <int dim>
LaguerreSites<dim> read_sites(const StateReader& state, double side, Walls walls, WallFilm wall_film) {
  LaguerreSites<dim> read = {side, walls, {}, wall_film};
  for (const double weight : state.numbers(name_of_weights)) read.sites.push_back({{}, weight});
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    const auto along = state.numbers(names_of_site_axes[axis], read.sites.size());
    for (std::size_t site = 0; site < along.size(); ++site) read.sites[site].position[axis] = along[site];
  }
  if (state.has(name_of_film_shares)) read.film_shares = state.numbers(name_of_film_shares, read.sites.size());
  if (!mistakes(read).empty()) throw FileError(refusal_of_grains);
  return read;
}

void save_grains(StateWriter& state, const StageGrains& grains) {
  if (grains.sites_in_space) {
    save_sites(state, *grains.sites_in_space);
  } else {
    save_sites(state, grains.sites);
  }
  state.write(name_of_film, grains.film);
}

StageGrains read_grains(const StateReader& state, const Stage& stage, double side, Walls walls) {
  const auto wall_film = stage.grains() == nullptr ? WallFilm::half : stage.grains()->wall_film;
  StageGrains grains = {.sites = {side, walls, {}, wall_film}, .film = state.number(name_of_film)};
  if (!(grains.film >= 0.0 && std::isfinite(grains.film))) throw FileError(refusal_of_grains);
  if (stage.dimensions == 3) {
    grains.sites_in_space = read_sites<3>(state, side, walls, wall_film);
  } else {
    grains.sites = read_sites<2>(state, side, walls, wall_film);
  }
  return grains;
}

/// Particles of other shapes than discs or spheres.
template <class Box>
Box read_box(const StateReader& state, const Stage& stage, Box box) {
  if (state.has("/filler")) {
    box.fillers = filler_numbers(state.numbers("/filler", box.particles.size()), stage.fillers.size());
  }
  box.coatings = coatings_of(stage, box.fillers, box.particles.size());
  return box;
}

constexpr std::array names_of_axes = {"/x_m", "/y_m", "/z_m"};

void save_fillers(StateWriter& state, const std::vector<std::size_t>& fillers) {
  if (!fillers.empty()) state.write("/filler", std::vector<double>(fillers.begin(), fillers.end()));
}

template <int dim>
void save_balls(StateWriter& state, const Microstructure<dim>& microstructure) {
  const auto& [side, walls, balls, fillers] = microstructure;
  state.write("/side_m", side);
  state.write("/walls", static_cast<std::int64_t>(walls));
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    std::vector<double> along;
    for (const auto& ball : balls) along.push_back(ball.centre[axis]);
    state.write(names_of_axes[axis], along);
  }
  std::vector<double> diameters;
  for (const auto& ball : balls) diameters.push_back(ball.diameter);
  state.write("/diameter_m", diameters);
  save_fillers(state, fillers);
}

template <int dim>
Microstructure<dim> read_balls(const StateReader& state, const Stage& stage) {
  Microstructure<dim> microstructure;
  auto& [side, walls, balls, fillers] = microstructure;
  side = state.number("/side_m");
  walls = static_cast<Walls>(state.integer("/walls"));
  const auto diameters = state.numbers("/diameter_m");
  for (const double diameter : diameters) balls.push_back({{}, diameter});
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    const auto along = state.numbers(names_of_axes[axis], balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) balls[i].centre[axis] = along[i];
  }
  const auto is_in_box = [side = side](const Ball<dim>& ball) {
    const auto is_within = [side](double value) { return value >= 0.0 && value <= side; };
    return std::ranges::all_of(ball.centre, is_within) && is_within(ball.diameter) && ball.diameter > 0.0;
  };
  const bool has_walls = walls == Walls::hard || walls == Walls::periodic;
  if (!has_walls || !(side > 0.0 && std::isfinite(side)) || !std::ranges::all_of(balls, is_in_box)) {
    throw FileError(fmt::format("a checkpoint of a packing: expected {} in a box", dim == 2 ? "discs" : "spheres"));
  }
  if (state.has("/filler") && !has_particles(state) && !has_ellipsoids(state)) {
    fillers = filler_numbers(state.numbers("/filler", balls.size()), stage.fillers.size());
  }
  return microstructure;
}

}  // namespace

void save(StateWriter& state, const StageMicrostructure& microstructure) {
  if (microstructure.spheres) {
    save_balls(state, *microstructure.spheres);
  } else {
    save_balls(state, microstructure.microstructure);
  }
  if (microstructure.grains) save_grains(state, *microstructure.grains);
  if (microstructure.shaped) {
    save_particles(state, microstructure.shaped->particles);
    save_fillers(state, microstructure.shaped->fillers);
  }
  if (microstructure.ellipsoids) {
    save_ellipsoids(state, microstructure.ellipsoids->particles);
    save_fillers(state, microstructure.ellipsoids->fillers);
  }
  for (std::size_t number = 0; number < microstructure.fillers.size(); ++number) {
    const auto deviation = microstructure.fillers[number].size_deviation;
    if (deviation) state.write(name_of_size_deviation(number), *deviation);
  }
  state.write("/events", static_cast<std::int64_t>(microstructure.events));
  state.write(packing_seconds_name, microstructure.seconds);
}

StageMicrostructure read_stage_microstructure(const StateReader& state, const Stage& stage) {
  StageMicrostructure result;
  const bool has_grains = state.has(name_of_film), are_ellipsoids = has_ellipsoids(state);
  if (stage.dimensions == 3 && !has_grains && !are_ellipsoids && !stage.has_image()) {
    result.spheres = read_balls<3>(state, stage);
    result.microstructure = {result.spheres->side, result.spheres->walls, {}};
  } else {
    result.microstructure = read_balls<2>(state, stage);
  }
  const auto side = result.microstructure.side;
  const auto walls = result.microstructure.walls;
  if (has_particles(state)) result.shaped = read_box<ParticleBox>(state, stage, {side, walls, read_particles(state)});
  if (are_ellipsoids) {
    result.ellipsoids = read_box<EllipsoidBox>(state, stage, {side, walls, read_ellipsoids(state)});
  }
  if (has_grains) result.grains = read_grains(state, stage, side, walls);
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
