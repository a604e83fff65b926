#include "discretisation/gaps/plane/face.hpp"

#include <algorithm>
#include <cmath>

#include "discretisation/gaps/change_of_owner.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

constexpr double rounding_of_place = 1e-9;
/// Number of faces on either side that a piece of binder is followed to.
constexpr int most_steps = 3;

/// The face itself and what it needs to find binder on its line.
class Crossing {
 public:
  Crossing(const ParticleImages<2>& images, const Owners<2>& owners, const FacePlace& place)
      : images_(images), owners_(owners), place_(place), line_(place.line()), binder_(images.binder_on(line_)) {}

  [[nodiscard]] Face face() const {
    if (binder_.empty()) return {};
    Face face = {.is_cross = is_owned(0) && is_owned(1) && owner(0) != owner(1)};
    if (is_on_side()) {
      if (face.is_cross) face.split = split();
      return face;
    }
    face.binder_outside = binder_outside();
    if (face.is_cross) {
      face.split = split();
      const double first = face.split, second = 1.0 - face.split;
      face.of_nodes = {first, second};
      face.of_slopes = {0.5 * first * first, -0.5 * second * second};
      face.has_slope = {owner(0) != walls, owner(1) != walls};
      face.conductance = conductance_across(face.split);
    } else {
      if (owner(0) != owner(1)) follow_particles(face);
      face.conductance = conductance_of_pieces();
    }
    if (face.conductance <= least_conductance) face.conductance = 0.0;
    return face;
  }

 private:
  static constexpr double least_conductance = 1e-14;

  [[nodiscard]] ImageIndex owner(int steps) const noexcept { return owners_.of(place_.node(steps)); }
  [[nodiscard]] bool is_owned(int steps) const noexcept { return owner(steps) != no_image; }
  [[nodiscard]] bool is_in_binder(int steps) const noexcept { return owners_.is_in_binder(place_.node(steps)); }
  /// Whether the face is a piece of a side of a box that is not periodic. Its flux is the mean of its nodes, and
  /// nothing flows through it.
  [[nodiscard]] bool is_on_side() const noexcept {
    const int height = place_.first_node[place_.normal()];
    return !images_.is_periodic() && (height == 0 || height == images_.cells());
  }
  /// The pieces of binder on the face that begins at a node of the line.
  [[nodiscard]] std::vector<Interval> binder_of(int steps) const {
    return steps == 0 ? binder_ : images_.binder_on(FacePlace{place_.node(steps), place_.along}.line());
  }

  /// Length of the binder from a node of the face outwards, as far as nodes belong to its particle.
  [[nodiscard]] double binder_behind(int node, int direction) const {
    double length = 0.0;
    for (int steps = node, count = 0; count < most_steps; steps += direction, ++count) {
      if (!is_in_binder(steps) || owner(steps + direction) != owner(node)) break;
      const auto binder = binder_of(direction < 0 ? steps - 1 : steps);
      if (binder.empty()) break;
      const double piece = direction < 0 ? binder.back().length() : binder.front().length();
      length += piece;
      if (piece < 1.0 - rounding_of_place) break;
    }
    return length;
  }

  [[nodiscard]] double binder_outside() const {
    if (is_owned(0) && owner(0) == owner(1)) {
      double on_face = 0.0;
      for (const auto& piece : binder_) on_face += piece.length();
      return -on_face;
    }
    return (is_owned(0) ? binder_behind(0, -1) : 0.0) + (is_owned(1) ? binder_behind(1, 1) : 0.0);
  }

  [[nodiscard]] double split() const { return change_of_owner(images_, owner(0), owner(1), line_); }

  /// Conductance of the binder between two particles, whose surfaces may lie beyond the ends of the face.
  [[nodiscard]] double conductance_across(double split) const {
    constexpr double least_slope = 0.3;
    const auto point = line_.at(split);
    const double gap = images_.distance(owner(0), point) + images_.distance(owner(1), point);
    const double slope = std::max(std::abs(images_.across(owner(0), owner(1), point)[place_.along]), least_slope);
    const auto before = images_.chord(owner(0), line_), behind = images_.chord(owner(1), line_);
    double begin = before && before->end <= split ? before->end : split - 0.5 * gap / slope;
    double end = behind && behind->begin >= split ? behind->begin : split + 0.5 * gap / slope;
    for (int steps = 0; steps >= -most_steps && begin <= steps; --steps) {
      if (!is_owned(steps)) {
        begin = steps;
        break;
      }
    }
    for (int steps = 1; steps <= most_steps + 1 && end >= steps; ++steps) {
      if (!is_owned(steps)) {
        end = steps;
        break;
      }
    }
    const auto in_box = images_.inside(line_);
    const double width = std::max(std::min(end, in_box.end) - std::max(begin, in_box.begin), 0.0);
    const double across = std::min(width, gap);
    return width * across * across / 12.0;
  }

  /// Conductance of the pieces of binder on a face that no two particles share. A piece is as wide as its binder goes
  /// on past nodes that a particle owns; one that goes on to another particle's node belongs to that cross face.
  [[nodiscard]] double conductance_of_pieces() const {
    const bool is_end = is_end_of_gap(owners_, place_);
    double conductance = 0.0;
    for (const auto& piece : binder_) {
      double begin = piece.begin, end = piece.end;
      if (goes_on_to_cross_face(begin, 0, -1) || goes_on_to_cross_face(end, 1, 1)) continue;
      const auto point = line_.at(0.5 * (piece.begin + piece.end));
      const auto nearest = images_.nearest_two(point);
      const double across = std::min(is_end ? end - begin : (end - begin) * along_gap(nearest, point), nearest.gap());
      conductance += (is_end ? at_end_of_gap(nearest, point) : 1.0) * piece.length() * across * across / 12.0;
    }
    return conductance;
  }

  /// Follows binder from a node of the face, and moves the end of the piece. Returns whether it meets a cross face.
  [[nodiscard]] bool goes_on_to_cross_face(double& end_of_piece, int node, int direction) const {
    for (int steps = node; end_of_piece == steps && is_owned(steps); steps += direction) {
      if (std::abs(steps - node) > most_steps) break;
      const auto binder = binder_of(direction < 0 ? steps - 1 : steps);
      if (binder.empty()) break;
      const auto& piece = direction < 0 ? binder.back() : binder.front();
      if (direction < 0 ? piece.end < 1.0 : piece.begin > 0.0) break;
      const auto next = owner(steps + direction);
      if (next != no_image && next != owner(steps)) return true;
      end_of_piece = direction < 0 ? steps - 1 + piece.begin : steps + piece.end;
    }
    return false;
  }

  /// The component along the face of the direction across the gap; the mean of all directions where the point is not
  /// between two particles.
  [[nodiscard]] double along_gap(const NearestTwo& nearest, const Vector<2>& point) const {
    const bool is_between = nearest.second != no_image &&
                            dot(images_.normal(nearest.first, point), images_.normal(nearest.second, point)) < 0.0;
    if (!is_between) return std::sqrt(0.5);
    return std::abs(images_.across(nearest.first, nearest.second, point)[place_.along]);
  }

  /// The whole flow of a gap turns at its end, across the gap, and takes the flow there with it.
  [[nodiscard]] double at_end_of_gap(const NearestTwo& nearest, const Vector<2>& point) const {
    constexpr double most = 10.0;
    if (nearest.second == no_image) return 1.0;
    const double across = images_.across(nearest.first, nearest.second, point)[place_.normal()];
    return 1.0 + most * std::max(0.0, 2.0 * across * across - 1.0);
  }

  /// The flux through a face on which a particle ends: it follows the particle up to its surface.
  void follow_particles(Face& face) const {
    double begin = 0.0, end = 1.0;
    if (is_owned(0) && !is_in_binder(0)) begin = binder_.front().begin;
    if (is_owned(1) && !is_in_binder(1)) end = binder_.back().end;
    face.has_slope = {begin > rounding_of_place, end < 1.0 - rounding_of_place};
    const double before = 0.5 * end, behind = 0.5 * (1.0 - begin);  // weights of the displacements at both surfaces
    face.of_nodes = {0.5 * begin + before, 0.5 * (1.0 - end) + behind};
    face.of_slopes = {before * begin, -behind * (1.0 - end)};
  }

  const ParticleImages<2>& images_;
  const Owners<2>& owners_;
  const FacePlace& place_;
  GridLine<2> line_;
  std::vector<Interval> binder_;
};

}  // namespace

bool is_end_of_gap(const Owners<2>& owners, const FacePlace& place) {
  const auto first = place.node(0), second = place.node(1);
  const auto ends_at = [&](const Index<2>& owned, const Index<2>& free) {
    return !owners.is_free(owned) && owners.is_in_binder(owned) && owners.is_free(free);
  };
  return ends_at(first, second) || ends_at(second, first);
}

Face make_face(const ParticleImages<2>& images, const Owners<2>& owners, const FacePlace& place) {
  return Crossing(images, owners, place).face();
}

}  // namespace breccia::gaps
