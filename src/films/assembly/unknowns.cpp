#include "films/assembly/unknowns.hpp"

#include <cmath>
#include <numeric>

namespace breccia::films {

Unknowns::Unknowns(const FilmNetwork& network, const std::vector<GrainMesh>& meshes, Boundary boundary,
                   const std::vector<bool>& is_on_springs) {
  for (std::size_t g = 0; g < network.grains.size(); ++g) {
    displacements_.emplace_back(2 * meshes[g].nodes.size(), 0);
    boundary_nodes_.push_back(meshes[g].boundary_nodes);
    auto& first = first_nodes_.emplace_back();
    std::size_t node = 0;
    for (const int segments : network.segments[g]) {
      first.push_back(node);
      node += 2 * static_cast<std::size_t>(segments);
    }
  }
  if (boundary == Boundary::displacement) {
    hold_walls(network);
  } else {
    hold_translations();
    if (boundary == Boundary::traction) hold_rotation(meshes);
  }
  for (auto& of_grain : displacements_) {
    for (int& number : of_grain) {
      if (number != held) number = count_++;
    }
  }
  pressures_ = static_cast<int>(network.junctions.size());
  for (const auto& film : network.films) {
    first_flows_.push_back(count_);
    first_pressures_.push_back(pressures_);
    count_ += 2 * film.segments;
    pressures_ += 2 * film.segments - 1;
  }
  for (std::size_t film = 0; film < network.films.size(); ++film) {
    auto& of_film = slips_.emplace_back(std::array{held, held});
    if (boundary != Boundary::traction) continue;
    for (std::size_t end = 0; end < of_film.size(); ++end) {
      if (network.ends_at_wall(film, end)) of_film[end] = count_++;
    }
  }
  for (std::size_t film = 0; film < network.films.size(); ++film) {
    first_jumps_.push_back(is_on_springs[film] ? count_ : held);
    if (is_on_springs[film]) count_ += 2 * (2 * network.films[film].segments + 1);
  }
}

void Unknowns::hold_walls(const FilmNetwork& network) {
  for (std::size_t g = 0; g < network.grains.size(); ++g) {
    for (const auto& edge : network.grains[g].edges) {
      if (edge.neighbour || !edge.face) continue;
      for (int past = 0; past <= 2 * network.segments[g][*edge.face]; ++past) {
        const auto first = 2 * node(g, *edge.face, past);
        displacements_[g][first] = displacements_[g][first + 1] = held;
      }
    }
  }
}

/// Holds the first node.
void Unknowns::hold_translations() {
  displacements_[0][0] = displacements_[0][1] = held;
}

/// Holds the second displacement component of the node that is farthest from the first one along the first axis.
void Unknowns::hold_rotation(const std::vector<GrainMesh>& meshes) {
  double farthest = 0.0;
  int* rotated = nullptr;
  for (std::size_t g = 0; g < meshes.size(); ++g) {
    for (std::size_t n = 0; n < meshes[g].boundary_nodes; ++n) {
      const double distance = std::abs(meshes[g].nodes[n].x() - meshes[0].nodes[0].x());
      if (distance <= farthest) continue;
      farthest = distance;
      farthest_held_ = meshes[g].nodes[n];
      rotated = &displacements_[g][2 * n + 1];
    }
  }
  *rotated = held;
}

std::vector<int> Unknowns::jumps(std::size_t film, int element) const {
  if (first_jumps_[film] == held) return {};
  constexpr std::size_t nodes = 3;
  std::vector<int> numbers(2 * nodes);
  std::iota(numbers.begin(), numbers.end(), first_jumps_[film] + 4 * element);
  return numbers;
}

std::array<int, 3> Unknowns::pressures(const FilmNetwork& network, std::size_t film, int element) const noexcept {
  const auto& [begin, end] = network.films[film].junctions;
  const int last = 2 * network.films[film].segments;
  std::array<int, 3> numbers{};
  for (int k = 0; k < 3; ++k) {
    const int index = 2 * element + k;
    auto& number = numbers[static_cast<std::size_t>(k)];
    number = first_pressures_[film] + index - 1;
    if (index == 0) number = static_cast<int>(begin);
    if (index == last) number = static_cast<int>(end);
  }
  return numbers;
}

}  // namespace breccia::films
