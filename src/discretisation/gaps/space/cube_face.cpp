#include "discretisation/gaps/space/cube_face.hpp"

#include <algorithm>
#include <limits>

#include "discretisation/gaps/change_of_owner.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

constexpr std::size_t nodes_of_cube_face = 4;

Vector<3> point_at(const Index<3>& node) noexcept {
  return {static_cast<double>(node[0]), static_cast<double>(node[1]), static_cast<double>(node[2])};
}

/// Half of Gauss' rule with four points on [0, 1]; the other half is its mirror image.
struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 2> gauss_rule = {
    {{0.0694318442029737, 0.1739274225687269}, {0.3300094782075719, 0.3260725774312731}}};

/// The face itself and what it needs to find the binder on it.
class CubeCrossing {
 public:
  CubeCrossing(const ParticleImages<3>& images, const Owners<3>& owners, const CubeFacePlace& place)
      : images_(images), owners_(owners), place_(place), owner_() {
    for (std::size_t node = 0; node < nodes_of_cube_face; ++node) owner_[node] = owners.of(place.node(node));
  }

  [[nodiscard]] CubeFace face() const {
    const auto free = std::ranges::count(owner_, no_image);
    const bool has_one_owner = std::ranges::count(owner_, owner_.front()) == nodes_of_cube_face;
    CubeFace face;
    if (has_one_owner && free == 0) return face;
    if (free == 0) {
      face.flux = flux_through_face(changes());
      face.conductance = conductance_across();
    } else {
      if (!(gap_at(place_.centre()) < widest_gap)) return face;
      if (!has_one_owner) face.flux = flux_by_edges();
      face.conductance = conductance_of_pieces();
    }
    constexpr double least_conductance = 1e-14;
    if (face.conductance <= least_conductance) face.conductance = 0.0;
    return face;
  }

 private:
  /// Width of the gap between two particles at a point; infinite where it is not between two.
  [[nodiscard]] double gap_at(const Vector<3>& point) const {
    const auto nearest = images_.nearest_two(point);
    return is_between(nearest, point) ? nearest.gap() : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool is_between(const NearestTwo& nearest, const Vector<3>& point) const {
    return nearest.second != no_image &&
           dot(images_.normal(nearest.first, point), images_.normal(nearest.second, point)) < 0.0;
  }

  /// The direction across the binder at a point: across the gap between two particles, or away from the nearest one.
  [[nodiscard]] Vector<3> across_at(const Vector<3>& point) const {
    const auto nearest = images_.nearest_two(point);
    if (nearest.first == no_image) return {};
    if (is_between(nearest, point)) return images_.across(nearest.first, nearest.second, point);
    return images_.normal(nearest.first, point);
  }
  /// How much lines along each axis of the face see of the width of the binder at a point: the shares of the squares of
  /// the direction across it.
  [[nodiscard]] std::array<double, 2> shares_of_axes(const Vector<3>& point) const {
    constexpr double least = 1e-12;
    const auto across = across_at(point);
    const double first = across[place_.axis(0)], second = across[place_.axis(1)];
    const double both = first * first + second * second + 2.0 * least;
    return {(first * first + least) / both, (second * second + least) / both};
  }

  [[nodiscard]] ChangesOfOwner changes() const {
    ChangesOfOwner changes;
    for_edges([&](std::size_t from, std::size_t, std::size_t along) {
      changes[edge_from(from, along)] = change_on_edge(images_, owners_, place_.node(from), place_.axis(along));
    });
    return changes;
  }

  /// Calls action(lower node, upper node, axis of the face) for the edges of the face.
  template <class Action>
  static void for_edges(const Action& action) {
    for (std::size_t along = 0; along < 2; ++along) {
      const std::size_t step = std::size_t{1} << along, other = std::size_t{2} >> along;
      for (const std::size_t from : {std::size_t{0}, other}) action(from, from | step, along);
    }
  }

  /// The mean of the fluxes through the four edges, each as wide as the face (Eqs. 42d and 42e of the theory): the
  /// displacement follows the particles of its nodes up to their surfaces, or to the change of owner, and is linear
  /// between. Edges along both axes count as shares_of_axes(), so that a layer of binder along an edge is not counted
  /// as wide as the face.
  [[nodiscard]] FaceFlux flux_by_edges() const {
    FaceFlux flux;
    const auto shares = shares_of_axes(place_.centre());
    for_edges([&](std::size_t lower, std::size_t upper, std::size_t along) {
      const auto [begin, end] = ends_of_particles(lower, upper, along);
      const double half = 0.25 * shares[along];
      flux.of_nodes[lower] += half * (begin + end);
      flux.of_nodes[upper] += half * (2.0 - begin - end);
      if (owner_[lower] == owner_[upper]) return;
      if (owner_[lower] != no_image) flux.of_slopes[lower][along] += half * begin * end;
      if (owner_[upper] != no_image) flux.of_slopes[upper][along] -= half * (1.0 - begin) * (1.0 - end);
    });
    return flux;
  }

  /// Where the particles of the nodes of an edge end; 0 or 1 for a free node. Between nodes of one owner, or of none,
  /// the displacement is linear all along the edge.
  [[nodiscard]] Interval ends_of_particles(std::size_t lower, std::size_t upper, std::size_t along) const {
    constexpr Interval whole = {0.0, 1.0};
    if (owner_[lower] == owner_[upper]) return whole;
    if (const auto change = change_on_edge(images_, owners_, place_.node(lower), place_.axis(along))) {
      return {*change, *change};
    }
    const auto binder = images_.binder_on({point_at(place_.node(lower)), place_.axis(along)});
    if (binder.empty()) return whole;
    return {owner_[lower] == no_image ? 0.0 : binder.front().begin,
            owner_[upper] == no_image ? 1.0 : binder.back().end};
  }

  /// Calls action(line, weight) for lines across the face along both of its axes.
  template <class Action>
  void for_lines(const Action& action) const {
    for (std::size_t along = 0; along < 2; ++along) {
      for (const auto& [place, weight] : gauss_rule) {
        action(place_.line(along, place), weight);
        action(place_.line(along, 1.0 - place), weight);
      }
    }
  }

  /// Conductance of the binder between particles that own all nodes, whose surfaces may lie beyond the face.
  [[nodiscard]] double conductance_across() const {
    constexpr Interval around = {-2.0, 3.0};
    double conductance = 0.0;
    for_lines([&](const GridLine<3>& line, double weight) {
      for (const auto& piece : images_.binder_on(line, around)) {
        if (piece.end <= 0.0 || piece.begin >= 1.0) continue;
        const auto nearest = images_.nearest_two(line.at(0.5 * (piece.begin + piece.end)));
        const double across = std::min(piece.length(), nearest.gap());
        conductance += weight * std::min(piece.length(), 1.0) * across * across / 12.0;
      }
    });
    return conductance;
  }

  /// Conductance of the pieces of binder on a face with free nodes: the integral of h^2 / 12 over the binder, with h
  /// the part of its width on the face, by lines along both axes, which count as shares_of_axes().
  [[nodiscard]] double conductance_of_pieces() const {
    // At the end of a gap the flow turns into the face.
    const double part_of_normal = is_end_of_gap() ? 0.5 : 0.0;
    double conductance = 0.0;
    for_lines([&](const GridLine<3>& line, double weight) {
      for (const auto& piece : images_.binder_on(line)) {
        const auto point = line.at(0.5 * (piece.begin + piece.end));
        const auto nearest = images_.nearest_two(point);
        const bool is_in_gap = is_between(nearest, point);
        const double along = is_in_gap ? share_across(nearest, point, line.axis, part_of_normal) : 1.0;
        const double share = is_in_gap ? shares_of_axes(point)[place_.axis(0) == line.axis ? 0 : 1] : 0.5;
        const double across = std::min(piece.length() * along, nearest.gap());
        conductance += share * weight * piece.length() * across * across / 12.0;
      }
    });
    return conductance;
  }

  /// The share of a piece of binder along an axis of the face that is across the gap: the cosine of their angle, with a
  /// part of the square of that of the normal of the face.
  [[nodiscard]] double share_across(const NearestTwo& nearest, const Vector<3>& point, std::size_t axis,
                                    double part_of_normal) const {
    const auto across = images_.across(nearest.first, nearest.second, point);
    const double along = across[axis], normal = across[place_.normal];
    return std::sqrt(along * along + part_of_normal * normal * normal);
  }

  /// Whether a narrow gap ends on the face: a node in binder that belongs to a particle is beside a free one.
  [[nodiscard]] bool is_end_of_gap() const {
    bool is_end = false;
    const auto ends = [&](std::size_t owned, std::size_t other) {
      return owner_[owned] != no_image && owners_.is_in_binder(place_.node(owned)) && owner_[other] == no_image;
    };
    for_edges([&](std::size_t lower, std::size_t upper, std::size_t) {
      is_end = is_end || ends(lower, upper) || ends(upper, lower);
    });
    return is_end;
  }

  const ParticleImages<3>& images_;
  const Owners<3>& owners_;
  const CubeFacePlace& place_;
  std::array<ImageIndex, nodes_of_cube_face> owner_;
};

}  // namespace

Vector<3> CubeFacePlace::centre() const noexcept {
  auto point = point_at(first_node);
  for (std::size_t along = 0; along < 2; ++along) point[axis(along)] += 0.5;
  return point;
}

GridLine<3> CubeFacePlace::line(std::size_t along, double place) const noexcept {
  auto origin = point_at(first_node);
  origin[axis(1 - along)] += place;
  return {origin, axis(along)};
}

CubeFace make_face(const ParticleImages<3>& images, const Owners<3>& owners, const CubeFacePlace& place) {
  return CubeCrossing(images, owners, place).face();
}

std::optional<double> change_on_edge(const ParticleImages<3>& images, const Owners<3>& owners, const Index<3>& node,
                                     std::size_t axis) {
  constexpr double least = 1e-6;
  auto other = node;
  ++other[axis];
  const auto first = owners.of(node), second = owners.of(other);
  if (first == second || first == no_image || second == no_image) return std::nullopt;
  return std::clamp(change_of_owner(images, first, second, {point_at(node), axis}), least, 1.0 - least);
}

}  // namespace breccia::gaps
