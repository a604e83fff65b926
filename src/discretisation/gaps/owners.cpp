#include "discretisation/gaps/owners.hpp"

#include <algorithm>
#include <cmath>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Eq. 42c of the theory: whether a gap is so narrow that its nodes belong to particles: up to 1.4 cells along an axis,
/// somewhat more where it is oblique.
bool is_narrow(const ParticleImages& images, const NearestTwo& nearest, const Vector<2>& point) {
  constexpr double widest = 1.4, of_a_diagonal = 0.8409;  // 2^(-1/4)
  if (nearest.second == no_image || nearest.gap() >= widest / of_a_diagonal) return false;
  // Behind a particle that lies before another one there is no gap.
  if (dot(images.normal(nearest.first, point), images.normal(nearest.second, point)) > 0.0) return false;
  const auto across = images.across(nearest.first, nearest.second, point);
  return nearest.gap() < widest / std::sqrt(std::max(std::abs(across[0]), std::abs(across[1])));
}

}  // namespace

Owners::Owners(const ParticleImages& images) {
  const int margin = images.margin();
  range_ = {{-margin, -margin}, {images.cells() + margin + 1, images.cells() + margin + 1}};
  nodes_.reserve(static_cast<std::size_t>(range_.size()[0]) * static_cast<std::size_t>(range_.size()[1]));
  for_each_index(range_.begin, range_.end, [&](const Index<2>& node) {
    const Vector<2> point = {static_cast<double>(node[0]), static_cast<double>(node[1])};
    const auto nearest = images.nearest_two(point);
    constexpr double least = 1e-9;
    const bool is_in_binder = nearest.to_first > least;
    const bool is_owned = !is_in_binder || is_narrow(images, nearest, point);
    nodes_.push_back({is_owned ? nearest.first : no_image, is_in_binder});
  });
}

}  // namespace breccia::gaps
