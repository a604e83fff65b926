#include "discretisation/gaps/plane/cell_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

constexpr double rounding = 1e-9;

/// The particles that share a cell.
std::vector<ImageIndex> particles_in(const GapGeometry<2>& geometry, const CellPlace& place) {
  std::vector<ImageIndex> particles;
  for (const auto image : geometry.images.near(place.centre())) {
    if (share_of(geometry, place, image) > rounding) particles.push_back(image);
  }
  return particles;
}

/// Whether the cell lies beside a channel.
bool is_beside_chain(const GapGeometry<2>& geometry, const CellPlace& place) {
  bool is_beside = false;
  for_each_index(Index<2>{-1, -1}, Index<2>{2, 2}, [&](const Index<2>& step) {
    const Index<2> other = {place.cell()[0] + step[0], place.cell()[1] + step[1]};
    is_beside = is_beside || (geometry.images.has_cell(other) && CellPlace(geometry, other).is_in_chain());
  });
  return is_beside;
}

/// Whether a node in binder belongs to a particle, or a node to walls.
bool has_owned_binder(const GapGeometry<2>& geometry, const CellPlace& place) {
  for (int node = 0; node < CellShape<2>::nodes; ++node) {
    const auto owner = place.owner(node);
    if (owner == walls || (owner != no_image && geometry.owners.is_in_binder(place.node(node)))) return true;
  }
  return false;
}

/// The share of binder, for the deviators, of a cell that the surface of one particle crosses: the geometric mean of
/// two shares. One is its area. With the other one, at most 1, the cell has the work of a constant stress if its free
/// nodes move in proportion to their distances from the particle, as in a layer that is sheared (theory, section 2).
double share_of_layer(const GapGeometry<2>& geometry, const CellPlace& place, ImageIndex image, double binder) {
  Eigen::Vector4d distances;
  for (int node = 0; node < CellShape<2>::nodes; ++node) {
    const auto at = place.node(node);
    const Vector<2> point = {static_cast<double>(at[0]), static_cast<double>(at[1])};
    distances[node] = std::max(geometry.images.distance(image, point), 0.0);
  }
  if (distances.minCoeff() > 0.0 || distances.maxCoeff() <= rounding) return binder;
  const double lower = distances[1] - distances[0], upper = distances[3] - distances[2];
  const double left = distances[2] - distances[0], right = distances[3] - distances[1];
  // The mean over the points of the cell, at 1/4 and 3/4, of the square of a value that is linear from side to side.
  const auto mean_square = [](double from, double to) { return 0.3125 * (from * from + to * to) + 0.375 * from * to; };
  const double mean = std::hypot(0.5 * (lower + upper), 0.5 * (left + right));
  const double of_work = (mean_square(lower, upper) + mean_square(left, right)) / std::max(mean, rounding);
  return std::sqrt(binder * std::min(of_work, 1.0));
}

/// Binder of channels that lies in cells beside them counts for the channels.
double binder_outside(const CellPlace& place, const Vector<2>& across) {
  double outside = 0.0;
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    const double along = across[1 - CellPlace::normal(face)];
    outside += 0.5 * along * along * place.face(face).binder_outside;
  }
  return outside;
}

/// Beside the end of a gap a cell is softer, since the flow turns there.
double at_end_of_gap(const GapGeometry<2>& geometry, const CellPlace& place, const Vector<2>& across) {
  constexpr double most = 0.25;
  double largest = 0.0;
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    if (!is_end_of_gap(geometry.owners, place.face_place(face))) continue;
    const double normal = across[CellPlace::normal(face)];
    largest = std::max(largest, normal * normal);
  }
  return 1.0 + most * largest;
}

}  // namespace

double share_of(const GapGeometry<2>& geometry, const CellPlace& place, ImageIndex image) {
  return image == walls ? 0.0 : geometry.images.content(image, place.corner());
}

CellShares shares_of_channel(const GapGeometry<2>& geometry, const CellPlace& place, const Channel& channel) {
  const auto first = place.owner(0), second = place.second_owner();
  const bool is_even = place.nodes_of(first) == place.nodes_of(second);
  const double of_sliding = is_even ? 1.0 : 0.625, least_slenderness = 1e-3;
  std::vector<ParticleShare> particles;
  for (const auto image : {first, second}) {
    if (image == walls) continue;
    particles.push_back(geometry.with_share(image, share_of(geometry, place, image) + rounding, place.corner()));
  }
  return in_series(geometry.matrix, particles,
                   {channel.area, of_sliding / std::max(channel.slenderness, least_slenderness)});
}

SharesOutsideChannels shares_of_cell(const GapGeometry<2>& geometry, const CellPlace& place) {
  const auto images = particles_in(geometry, place);
  std::vector<ParticleShare> particles;
  particles.reserve(images.size() + 1);
  for (const auto image : images) {
    particles.push_back(geometry.with_share(image, share_of(geometry, place, image), place.corner()));
  }
  if (place.has_one_owner() && place.owner(0) != walls && is_beside_chain(geometry, place)) {
    return {
        in_series(geometry.matrix, std::array{geometry.with_share(place.owner(0), 1.0, place.corner())}, {0.0, 0.0})};
  }
  double in_particles = 0.0;
  for (const auto& one : particles) in_particles += one.share;
  const double binder = std::max(1.0 - in_particles, 0.0);
  if (binder <= rounding) {
    auto filled = in_series(geometry.matrix, particles, {0.0, 0.0});
    const bool is_one_phase = filled.mixture.size() == 1;
    return {std::move(filled), is_one_phase};
  }
  VolumeAndShear shares(binder, binder);
  if (particles.size() == 1 && !has_owned_binder(geometry, place)) {
    shares[1] = share_of_layer(geometry, place, images.front(), binder);
  }
  const auto nearest = geometry.images.nearest_two(place.centre());
  if (nearest.second != no_image) {
    const auto across = geometry.images.across(nearest.first, nearest.second, place.centre());
    shares += binder_outside(place, across);
    shares[1] *= place.has_free_node() ? at_end_of_gap(geometry, place, across) : 1.0;
  }
  shares = shares.max(0.0).min(3.0);
  const bool is_binder = particles.empty() && (shares == 1.0).all();
  if (particles.empty() && shares.minCoeff() < 1.0) {
    const auto image = nearest.first != walls ? nearest.first : nearest.second;
    particles.push_back(geometry.with_share(image, rounding, place.corner()));
  }
  return {in_series(geometry.matrix, particles, shares), is_binder};
}

}  // namespace breccia::gaps
