#include "discretisation/gaps/owners.hpp"

#include <algorithm>
#include <cmath>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// The widest gap whose nodes belong to particles (Eq. 42c of the theory, docs/gaps-in-space.md), across an axis and
/// across a diagonal.
template <int dim>
constexpr double widest = dim == 2 ? 1.4 : 1.2;
template <int dim>
constexpr double widest_of_all = dim == 2 ? 1.4 / 0.8409 : 1.2 / 0.5773;

/// Whether a gap is so narrow that its nodes belong to particles; where it is oblique it may be somewhat wider.
template <int dim>
bool is_narrow(const ParticleImages<dim>& images, const NearestTwo& nearest, const Vector<dim>& point) {
  if (nearest.second == no_image || nearest.gap() >= widest_of_all<dim>) return false;
  // Behind a particle that lies before another one there is no gap.
  if (dot(images.normal(nearest.first, point), images.normal(nearest.second, point)) > 0.0) return false;
  double largest = 0.0;
  for (const double part : images.across(nearest.first, nearest.second, point)) {
    largest = std::max(largest, std::abs(part));
  }
  return nearest.gap() < widest<dim> / (dim == 2 ? std::sqrt(largest) : largest);
}

}  // namespace

template <int dim>
Owners<dim>::Owners(const ParticleImages<dim>& images) {
  range_.begin.fill(-images.margin());
  range_.end.fill(images.cells() + images.margin() + 1);
  std::size_t size = 1;
  for (const int along : range_.size()) size *= static_cast<std::size_t>(along);
  nodes_.reserve(size);
  std::vector<ImageIndex> nearest_to;
  nearest_to.reserve(size);
  for_each_index(range_.begin, range_.end, [&](const Index<dim>& node) {
    Vector<dim> point{};
    for (std::size_t axis = 0; axis < dim; ++axis) point[axis] = node[axis];
    const auto nearest = images.nearest_two(point);
    constexpr double least = 1e-9;
    const bool is_in_binder = nearest.to_first > least;
    const bool is_owned = !is_in_binder || is_narrow<dim>(images, nearest, point);
    nodes_.push_back({is_owned ? nearest.first : no_image, is_in_binder});
    nearest_to.push_back(nearest.first);
  });
  if (!images.is_periodic()) return;
  // At the limit of narrow gaps rounding decides; all images of a node follow the one in the box.
  for_each_index(range_.begin, range_.end, [&](const Index<dim>& node) {
    auto in_box = node;
    for (int& place : in_box) place = (place % images.cells() + images.cells()) % images.cells();
    const auto& original = nodes_[range_.place_of(in_box)];
    const auto place = range_.place_of(node);
    nodes_[place] = {original.owner != no_image ? nearest_to[place] : no_image, original.is_in_binder};
  });
}

template class Owners<2>;
template class Owners<3>;

}  // namespace breccia::gaps
