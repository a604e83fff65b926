#include "films/mesh/film_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia::films {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// An edge of the cell of a grain.
struct EdgeOf {
  std::size_t grain;
  std::size_t edge;
};

/// The pairs of cell edges that face each other, and the junction at the end of each edge.
class EdgePairs {
 public:
  explicit EdgePairs(std::vector<GrainPolygon>& grains) : grains_(grains) {
    number_edges();
    drop_single_edges();
    number_edges();
    for (const auto& grain : grains_) end_junction.emplace_back(grain.edges.size(), none);
  }

  [[nodiscard]] const CellEdge& operator()(const EdgeOf& at) const { return grains_[at.grain].edges[at.edge]; }

  /// The edge of the neighbour that faces this one.
  [[nodiscard]] EdgeOf opposite(const EdgeOf& at) const {
    const auto& edge = (*this)(at);
    return {*edge.neighbour, number_.at(key(*edge.neighbour, at.grain, -edge.image))};
  }

  /// Whether a face of the edge is left on either side after the erosion.
  [[nodiscard]] bool is_alive(const EdgeOf& at) const {
    return (*this)(at).face || ((*this)(at).neighbour && (*this)(opposite(at)).face);
  }

  /// The next edge of the cell that is alive.
  [[nodiscard]] EdgeOf next_alive(EdgeOf at) const {
    do {
      at.edge = (at.edge + 1) % grains_[at.grain].edges.size();
    } while (!is_alive(at));
    return at;
  }

  std::vector<std::vector<std::size_t>> end_junction;  ///< numbers by grain and edge

 private:
  using Key = std::tuple<std::size_t, std::size_t, int, int>;
  static Key key(std::size_t grain, std::size_t neighbour, const Eigen::Vector2i& image) {
    return {grain, neighbour, image.x(), image.y()};
  }

  void number_edges() {
    number_.clear();
    for (std::size_t g = 0; g < grains_.size(); ++g) {
      for (std::size_t e = 0; e < grains_[g].edges.size(); ++e) {
        const auto& edge = grains_[g].edges[e];
        if (edge.neighbour) number_[key(g, *edge.neighbour, edge.image)] = e;
      }
    }
  }

  /// Removes edges without an opposite edge: where four cells meet at a point, roundoff may leave one of them an edge
  /// of no length that no other cell has.
  void drop_single_edges() {
    for (std::size_t g = 0; g < grains_.size(); ++g) {
      std::erase_if(grains_[g].edges, [&](const CellEdge& edge) {
        return edge.neighbour && !edge.face && !number_.contains(key(*edge.neighbour, g, -edge.image));
      });
    }
  }

  std::vector<GrainPolygon>& grains_;
  std::map<Key, std::size_t> number_;
};

/// Traces the junction at the end of an edge: clockwise from cell to cell, back to this edge or to a wall.
Junction trace(EdgePairs& edges, const std::vector<GrainPolygon>& grains, const EdgeOf& start, std::size_t number) {
  Junction junction;
  EdgeOf at = start;
  Eigen::Vector2i image = Eigen::Vector2i::Zero();
  do {
    edges.end_junction[at.grain][at.edge] = number;
    junction.corners.push_back({at.grain, grains[at.grain].corner_after(at.edge), image});
    const auto leaving = edges.next_alive(at);
    const auto& edge = edges(leaving);
    if (!edge.neighbour) {
      junction.is_at_wall = true;
      break;
    }
    image += edge.image;
    at = edges.opposite(leaving);
  } while (at.grain != start.grain || at.edge != start.edge);
  std::ranges::reverse(junction.corners);
  return junction;
}

std::vector<Junction> trace_junctions(EdgePairs& edges, const std::vector<GrainPolygon>& grains) {
  std::vector<Junction> junctions;
  const auto trace_from_all = [&](const auto& is_start) {
    for (std::size_t g = 0; g < grains.size(); ++g) {
      for (std::size_t e = 0; e < grains[g].edges.size(); ++e) {
        const EdgeOf at{g, e};
        if (edges.end_junction[g][e] != none || !edges.is_alive(at) || !is_start(at)) continue;
        junctions.push_back(trace(edges, grains, at, junctions.size()));
      }
    }
  };
  // Traces from the walls come first, so that no trace starts in the middle of a junction at a wall. No junction is in
  // a corner of the box.
  trace_from_all([&](const EdgeOf& at) { return !edges(at).neighbour && edges(edges.next_alive(at)).neighbour; });
  trace_from_all([&](const EdgeOf& at) { return edges(at).neighbour.has_value(); });
  return junctions;
}

FilmSide side_of(const GrainPolygon& grain, std::size_t g, std::size_t edge, const Eigen::Vector2i& image) {
  return {{g, grain.corner_before(edge), image}, {g, grain.corner_after(edge), image}, grain.edges[edge].face};
}

/// Makes the films. Each begins with the edge of it that comes first, or with the only edge that has a face.
std::vector<Film> find_films(const EdgePairs& edges, const FilmNetwork& network) {
  std::vector<Film> films;
  const auto& grains = network.grains;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    for (std::size_t e = 0; e < grains[g].edges.size(); ++e) {
      const auto& edge = grains[g].edges[e];
      if (!edge.neighbour || !edge.face) continue;
      const auto beyond = edges.opposite({g, e});
      const bool is_second = std::pair(beyond.grain, beyond.edge) < std::pair(g, e);
      if (edges(beyond).face && is_second) continue;
      auto across = side_of(grains[beyond.grain], beyond.grain, beyond.edge, edge.image);
      std::swap(across.begin, across.end);
      const auto along = side_of(grains[g], g, e, Eigen::Vector2i::Zero());
      const Eigen::Vector2d distance = network.position(across.begin) - network.position(along.begin);
      films.push_back({.sides = {along, across},
                       .direction = {-edge.normal.y(), edge.normal.x()},
                       .normal = edge.normal,
                       .thickness = distance.dot(edge.normal),
                       .junctions = {edges.end_junction[beyond.grain][beyond.edge], edges.end_junction[g][e]},
                       .segments = 1});
    }
  }
  return films;
}

int segments_of(double length, double longest) {
  return std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
}

/// Sets the numbers of elements, which are equal on both sides of a film; faces along walls have their own. A film that
/// a wall cuts has shorter elements, because pressure and motion change most there.
void set_segments(FilmNetwork& network, double face_share) {
  const auto longest = [&](std::size_t grain) { return face_share * std::sqrt(area(network.grains[grain].corners)); };
  for (std::size_t g = 0; g < network.grains.size(); ++g) {
    const auto& corners = network.grains[g].corners;
    auto& segments = network.segments.emplace_back();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      segments.push_back(segments_of((corners[network.grains[g].next_corner(c)] - corners[c]).norm(), longest(g)));
    }
  }
  constexpr double at_walls = 0.5;
  for (std::size_t f = 0; f < network.films.size(); ++f) {
    auto& film = network.films[f];
    double length = 0.0, element = std::numeric_limits<double>::infinity();
    for (const auto& side : film.sides) {
      length = std::max(length, (network.position(side.end) - network.position(side.begin)).norm());
      element = std::min(element, longest(side.begin.grain));
    }
    if (network.ends_at_wall(f, 0) || network.ends_at_wall(f, 1)) element *= at_walls;
    film.segments = segments_of(length, element);
    for (const auto& side : film.sides) {
      if (side.face) network.segments[side.begin.grain][*side.face] = film.segments;
    }
  }
}

}  // namespace

FilmNetwork film_network(const Tessellation<2>& tessellation, double thickness, double face_share) {
  FilmNetwork network;
  std::vector<std::size_t> empty;
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    network.grains.push_back(grain_polygon(tessellation, site, thickness));
    if (network.grains.back().corners.empty()) empty.push_back(site);
  }
  if (!empty.empty()) {
    throw InputError(fmt::format("films: a film of {} m leaves nothing of the grains of the sites {}",
                                 thickness * tessellation.side(), fmt::join(empty, ", ")));
  }
  EdgePairs edges(network.grains);
  network.junctions = trace_junctions(edges, network.grains);
  network.films = find_films(edges, network);
  set_segments(network, face_share);
  return network;
}

}  // namespace breccia::films
