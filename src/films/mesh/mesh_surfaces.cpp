#include "films/mesh/mesh_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace breccia::films {
namespace {

template <int dim>
using Facet = std::array<std::size_t, std::size_t{dim}>;

/// The corners of an element that make up each of its facets, as MeshSurface has them.
template <int dim>
constexpr auto facets_of_element = [] {
  if constexpr (dim == 2) {
    return std::to_array<std::array<std::size_t, 2>>({{0, 1}, {1, 2}, {2, 0}});
  } else {
    return std::to_array<std::array<std::size_t, 3>>({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  }
}();

/// The facets of one element alone.
template <int dim>
std::vector<Facet<dim>> facets_on_surface(const ConformingMesh<dim>& mesh) {
  std::map<Facet<dim>, std::pair<Facet<dim>, int>> found;  // by the sorted nodes
  for (const auto& element : mesh.elements) {
    for (const auto& corners : facets_of_element<dim>) {
      Facet<dim> facet{};
      for (std::size_t k = 0; k < facet.size(); ++k) facet[k] = element.nodes[corners[k]];
      auto sorted = facet;
      std::ranges::sort(sorted);
      ++found.try_emplace(sorted, facet, 0).first->second.second;
    }
  }
  std::vector<Facet<dim>> facets;
  for (const auto& [sorted, counted] : found) {
    if (counted.second == 1) facets.push_back(counted.first);
  }
  return facets;
}

template <int dim>
Index<dim> difference(Index<dim> one, const Index<dim>& other) {
  for (std::size_t axis = 0; axis < one.size(); ++axis) one[axis] -= other[axis];
  return one;
}

/// Finds the surfaces facet by facet.
template <int dim>
class SurfaceFinder {
 public:
  SurfaceFinder(ConformingMesh<dim>& mesh, const std::vector<NodeImage<dim>>& images) : mesh_(mesh), images_(images) {}

  void find() {
    for (const auto& facet : facets_on_surface(mesh_)) at_[place_of(facet)].push_back(facet);
    for (const auto& [place, facets] : at_) {
      if (facets.size() == 2) {
        add_pair(facets[0], facets[1]);
      } else {
        for (const auto& facet : facets) add_single(facet);
      }
    }
    for (auto& [key, surface] : surfaces_) {
      numbers_[key] = mesh_.surfaces.size();
      mesh_.surfaces.push_back(std::move(surface));
    }
    for (const auto& [displacement, nodes] : pairs_) add_opposites(displacement, nodes);
  }

 private:
  using NodePairs = std::set<std::array<std::size_t, 2>>;
  using Key = std::pair<Beyond, Index<dim>>;
  /// The nodes of a facet, in an order that all its images have, by number and image relative to the first one.
  using Place = std::array<std::pair<std::size_t, Index<dim>>, std::size_t{dim}>;

  [[nodiscard]] Facet<dim> in_order(Facet<dim> facet) const {
    std::ranges::sort(facet, {},
                      [&](std::size_t node) { return std::tuple(images_[node].number, images_[node].image); });
    return facet;
  }

  [[nodiscard]] Place place_of(const Facet<dim>& facet) const {
    const auto sorted = in_order(facet);
    Place place;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      const auto& node = images_[sorted[k]];
      place[k] = {node.number, difference<dim>(node.image, images_[sorted[0]].image)};
    }
    return place;
  }

  void add(const Key& key, const Facet<dim>& facet) {
    auto& surface = surfaces_[key];
    surface.beyond = key.first;
    surface.direction = key.second;
    surface.facets.push_back(facet);
  }

  /// Adds two facets, one of which is the other one displaced.
  void add_pair(const Facet<dim>& one, const Facet<dim>& other) {
    const auto first = in_order(one), second = in_order(other);
    // The image of the mesh that has the first facet where the second one is here.
    const auto forward = difference<dim>(images_[second[0]].image, images_[first[0]].image);
    const auto backward = difference<dim>({}, forward);
    add({Beyond::image, backward}, one);
    add({Beyond::image, forward}, other);
    const bool is_forward = backward < forward;
    for (std::size_t k = 0; k < first.size(); ++k) {
      pairs_[is_forward ? forward : backward].insert(is_forward ? std::array{first[k], second[k]}
                                                                : std::array{second[k], first[k]});
    }
  }

  /// The outward direction of the wall on which a facet lies; nothing for a facet elsewhere.
  [[nodiscard]] std::optional<Index<dim>> wall_at(const Facet<dim>& facet) const {
    constexpr double tolerance = 1e-9;  // in sides of the box
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      for (const int outward : {-1, 1}) {
        const double wall = outward < 0 ? 0.0 : mesh_.side;
        const auto is_on_wall = [&](std::size_t node) {
          return std::abs(mesh_.nodes[node][axis] - wall) < tolerance * mesh_.side;
        };
        if (!std::ranges::all_of(facet, is_on_wall)) continue;
        Index<dim> direction{};
        direction[axis] = outward;
        return direction;
      }
    }
    return std::nullopt;
  }

  void add_single(const Facet<dim>& facet) {
    const auto direction = mesh_.walls == Walls::hard ? wall_at(facet) : std::nullopt;
    if (direction) {
      add({Beyond::wall, *direction}, facet);
    } else {
      add({Beyond::gap, {}}, facet);
    }
  }

  void add_opposites(const Index<dim>& displacement, const NodePairs& nodes) {
    const auto backward = difference<dim>({}, displacement);
    mesh_.opposites.push_back({numbers_.at({Beyond::image, backward}),
                               numbers_.at({Beyond::image, displacement}),
                               displacement,
                               {nodes.begin(), nodes.end()}});
  }

  ConformingMesh<dim>& mesh_;
  const std::vector<NodeImage<dim>>& images_;
  std::map<Place, std::vector<Facet<dim>>> at_;
  std::map<Key, MeshSurface<dim>> surfaces_;
  std::map<Key, std::size_t> numbers_;  ///< numbers of the surfaces
  std::map<Index<dim>, NodePairs> pairs_;
};

}  // namespace

template <int dim>
void find_surfaces(ConformingMesh<dim>& mesh, const std::vector<NodeImage<dim>>& images) {
  SurfaceFinder<dim>(mesh, images).find();
}

template void find_surfaces(ConformingMesh<2>&, const std::vector<NodeImage<2>>&);
template void find_surfaces(ConformingMesh<3>&, const std::vector<NodeImage<3>>&);

}  // namespace breccia::films
