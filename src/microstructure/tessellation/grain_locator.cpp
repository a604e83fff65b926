#include "breccia/microstructure/grain_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "site_tree.hpp"
#include "vector_algebra.hpp"

namespace breccia {

template <int dim>
GrainLocator<dim>::GrainLocator(const Tessellation<dim>& tessellation, double film)
    : film_(film), tree_(std::make_unique<SiteTree<dim>>(tessellation.sites())) {
  if (!(film >= 0.0) || !std::isfinite(film)) {
    throw InputError(
        fmt::format("tessellation: the thickness of the film must be finite and not negative, got {} m", film));
  }
  first_face_.push_back(0);
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    for (const auto& face : tessellation.cell(site).half_spaces()) {
      if (tessellation.recedes(face)) faces_.push_back({face.normal, face.offset});
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

// The faces of the cell are enough. A ball around the place that reaches the nearest face is within the convex cell, so
// it does not cross the plane of any other site: no such plane is nearer (theory, Eq. 49). In the film, at the distance
// d < t/2 from the nearest face, the cell's own grain is at least t/2 - d away, and another grain t/2 + d: it lies t/2
// behind a plane that is d away or more.
template <int dim>
GrainPlace GrainLocator<dim>::at(const Vector<dim>& position) const {
  const auto [site, place] = tree_->owner(position);
  double distance = std::numeric_limits<double>::infinity();  // from the nearest face
  for (std::size_t face = first_face_[site]; face < first_face_[site + 1]; ++face) {
    distance = std::min(distance, faces_[face].offset - dot(faces_[face].normal, place));
  }
  return {site, std::max(0.0, distance) - 0.5 * film_};
}

template class GrainLocator<2>;
template class GrainLocator<3>;

}  // namespace breccia
