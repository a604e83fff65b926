#include "microstructure/tessellation/grain_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/tessellation/site_tree.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

template <int dim>
GrainLocator<dim>::GrainLocator(const Tessellation<dim>& tessellation, double film)
    : least_half_film_(0.5 * film), tree_(std::make_unique<SiteTree<dim>>(tessellation.sites())) {
  if (!(film >= 0.0) || !std::isfinite(film)) {
    throw InputError(
        fmt::format("tessellation: the thickness of the film must be finite and not negative, got {} m", film));
  }
  first_face_.push_back(0);
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto& half_spaces = tessellation.cell(site).half_spaces();
    for (std::size_t number = 0; number < half_spaces.size(); ++number) {
      const auto& face = half_spaces[number];
      if (!tessellation.recedes(face)) continue;
      faces_.push_back({face.normal, face.offset, tessellation.half_film(site, face, film), number});
      least_half_film_ = std::min(least_half_film_, faces_.back().half_film);
    }
    first_face_.push_back(faces_.size());
  }
}

template <int dim>
GrainLocator<dim>::GrainLocator(GrainLocator&&) noexcept = default;
template <int dim>
GrainLocator<dim>& GrainLocator<dim>::operator=(GrainLocator&&) noexcept = default;
template <int dim>
GrainLocator<dim>::~GrainLocator() = default;

// Only the faces of the cell matter. A ball around the point that reaches the nearest face is within the convex cell,
// so
// it does not cross the plane of any other site: no such plane is nearer (theory, Eq. 49). In a film, at the distance
// d < t/2 from its face, the cell's own grain is at least t/2 - d away. Another grain is at least half of the thinnest
// film behind a face that is no nearer than the nearest of this cell.
template <int dim>
LocatedGrain GrainLocator<dim>::at(const Vector<dim>& position) const {
  const auto [site, point] = tree_->owner(position);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double nearest = infinity, depth = infinity;  // distances from the nearest face, and into the grain
  std::size_t nearest_film = 0;
  for (std::size_t k = first_face_[site]; k < first_face_[site + 1]; ++k) {
    const auto& face = faces_[k];
    const double distance = std::max(0.0, face.offset - dot(face.normal, point));
    nearest = std::min(nearest, distance);
    if (distance - face.half_film >= depth) continue;
    depth = distance - face.half_film;
    nearest_film = face.number;
  }
  if (depth >= 0.0) return {site, depth, nearest_film};
  return {site, std::max(depth, -(nearest + least_half_film_)), nearest_film};
}

template class GrainLocator<2>;
template class GrainLocator<3>;

}  // namespace breccia
