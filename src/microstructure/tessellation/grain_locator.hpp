#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// The grain or film at a point of a tessellation.
struct LocatedGrain {
  std::uint32_t site = 0;  ///< site of the cell that contains the point
  /// Depth of the point inside its grain [m]: the distance from the nearest film. In the film it is negative, and no
  /// grain is nearer than -depth.
  double depth = 0.0;
  std::size_t face = 0;  ///< number of the face with the nearest film among ConvexCell::half_spaces()
  [[nodiscard]] bool is_in_grain() const noexcept { return depth >= 0.0; }
};

template <int dim>
class SiteTree;

/// Finds the grain that contains any point of a tessellation, unless the point is in the film. Instantiated for 2 and 3
/// dimensions.
template <int dim>
class GrainLocator {
 public:
  /// `film` is the thickness of the film [m], which the shares of the sites scale. Throws InputError if it is negative
  /// or not finite. The tessellation need not outlive the locator.
  GrainLocator(const Tessellation<dim>& tessellation, double film);
  GrainLocator(GrainLocator&&) noexcept;
  GrainLocator& operator=(GrainLocator&&) noexcept;
  GrainLocator(const GrainLocator&) = delete;
  GrainLocator& operator=(const GrainLocator&) = delete;
  ~GrainLocator();

  /// The grain or film at a position [m]. A periodic tessellation continues beyond the box; with hard walls a position
  /// outside is in the film.
  [[nodiscard]] LocatedGrain at(const Vector<dim>& position) const;

 private:
  struct Face {
    Vector<dim> normal;
    double offset;
    double half_film;
    std::size_t number;
  };

  double least_half_film_;
  std::unique_ptr<SiteTree<dim>> tree_;
  std::vector<std::size_t> first_face_;  // first face of each cell, followed by the number of all faces
  std::vector<Face> faces_;              // faces, relative to the site of their cell
};

extern template class GrainLocator<2>;
extern template class GrainLocator<3>;

}  // namespace breccia
