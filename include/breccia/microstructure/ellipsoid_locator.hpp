#pragma once

#include <memory>

#include "breccia/microstructure/ellipsoid_box.hpp"
#include "breccia/microstructure/particle_locator.hpp"

namespace breccia {

/// Tells for any place of a box which ellipsoid it is in, or which one is near. The ellipsoids must not overlap.
class EllipsoidLocator {
 public:
  explicit EllipsoidLocator(EllipsoidBox box);
  EllipsoidLocator(EllipsoidLocator&&) noexcept;
  EllipsoidLocator& operator=(EllipsoidLocator&&) noexcept;
  EllipsoidLocator(const EllipsoidLocator&) = delete;
  EllipsoidLocator& operator=(const EllipsoidLocator&) = delete;
  ~EllipsoidLocator();

  [[nodiscard]] const EllipsoidBox& box() const noexcept;
  /// What is at a position in the box [m].
  [[nodiscard]] ParticlePlace at(const Vector<3>& position) const;

 private:
  struct Search;

  std::unique_ptr<Search> search_;
};

}  // namespace breccia
