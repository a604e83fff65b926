#pragma once

#include <span>
#include <type_traits>

#include "breccia/discretisation/discretisation.hpp"

#include "discretisation/gaps/owners.hpp"
#include "discretisation/gaps/phase_shares.hpp"

namespace breccia::gaps {

class FaceTable;
class CubeFaces;

/// What decides the cells of a grid.
template <int dim>
struct GapGeometry {
  using Faces = std::conditional_t<dim == 2, FaceTable, CubeFaces>;

  const ParticleImages<dim>& images;
  const Owners<dim>& owners;
  const Faces& faces;
  PhaseIndex matrix = 0;
  std::span<const ParticlePhases> particles;  ///< by particle

  /// The phases of a particle.
  [[nodiscard]] const ParticlePhases& phases(ImageIndex image) const noexcept {
    return particles[images.particle(image)];
  }
  /// The phase at the surface of a particle.
  [[nodiscard]] PhaseIndex phase_at_surface(ImageIndex image) const noexcept {
    return phases(image).coating_thickness > 0.0 ? phases(image).coating : phases(image).phase;
  }
  /// A particle with a share of the cell that has this lowest corner.
  [[nodiscard]] ParticleShare with_share(ImageIndex image, double share, const Vector<dim>& corner) const {
    constexpr double of_rounding = 1e-9;
    const auto& of_image = phases(image);
    if (of_image.coating_thickness == 0.0) return {of_image, share, 1.0};
    const double all = images.content(image, corner);
    return {of_image, share, all > of_rounding ? images.content_of_core(image, corner) / all : 0.0};
  }
};

}  // namespace breccia::gaps
