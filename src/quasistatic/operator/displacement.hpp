#pragma once

#include <utility>

#include "operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// A displacement of the nodes, u = a E x + w, in units of the cell side: the amplitude a of the macroscopic part, the
/// affine motion under the unit strain E of a load, and the fluctuation w of the nodes (theory, Eq. 16).
class Displacement {
 public:
  Displacement(double macroscopic, NodalVector fluctuation)
      : macroscopic_(macroscopic), fluctuation_(std::move(fluctuation)) {}

  /// A displacement of the same nodes that is zero.
  [[nodiscard]] Displacement zero() const;
  [[nodiscard]] Displacement copy() const;

  /// Amplitude a of the macroscopic part [-].
  [[nodiscard]] double macroscopic() const noexcept { return macroscopic_; }
  void set_macroscopic(double amplitude) noexcept { macroscopic_ = amplitude; }
  /// Fluctuation w.
  [[nodiscard]] Vec fluctuation() const noexcept { return fluctuation_.get(); }

  /// this += factor * other
  void add(double factor, const Displacement& other);
  /// this *= factor
  void scale(double factor);
  void set_zero();

 private:
  double macroscopic_;
  NodalVector fluctuation_;
};

/// Forces that do work on a displacement are stored like one: the force F conjugate to the amplitude a in place of the
/// macroscopic part, the nodal forces f conjugate to w in place of the fluctuation.
using Forces = Displacement;

/// Work of forces on a displacement, a F + w' f; the same on all processes.
[[nodiscard]] double work(const Forces& forces, const Displacement& displacement);

}  // namespace breccia::quasistatic
