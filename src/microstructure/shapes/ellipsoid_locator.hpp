#pragma once

#include <memory>

#include "breccia/microstructure/ellipsoid_box.hpp"

#include "microstructure/shapes/particle_locator.hpp"

namespace breccia {

/// Finds the ellipsoid that contains any point of a box, or one that is near it. The ellipsoids must not overlap.
class EllipsoidLocator {
 public:
  explicit EllipsoidLocator(EllipsoidBox box);
  EllipsoidLocator(EllipsoidLocator&&) noexcept;
  EllipsoidLocator& operator=(EllipsoidLocator&&) noexcept;
  EllipsoidLocator(const EllipsoidLocator&) = delete;
  EllipsoidLocator& operator=(const EllipsoidLocator&) = delete;
  ~EllipsoidLocator();

  [[nodiscard]] const EllipsoidBox& box() const noexcept;
  /// The ellipsoid at a position in the box [m].
  [[nodiscard]] LocatedParticle at(const Vector<3>& position) const;

 private:
  struct Search;

  std::unique_ptr<Search> search_;
};

}  // namespace breccia
