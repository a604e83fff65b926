#pragma once

#include <utility>

#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// A displacement of the nodes, u = a E x + w, in units of the cell side: the amplitude a of the macroscopic part, the
/// affine motion under the unit strain E of a load, and the fluctuation w of the nodes (theory, Eq. 16). With mixed
/// cells it also has the strains of the phases (MixedCell).
class Displacement {
 public:
  Displacement(double macroscopic, NodalVector fluctuation, NodalVector phase_strains)
      : macroscopic_(macroscopic), fluctuation_(std::move(fluctuation)), phase_strains_(std::move(phase_strains)) {}

  /// A displacement of the same nodes that is zero.
  [[nodiscard]] Displacement zero() const;
  [[nodiscard]] Displacement copy() const;
  /// The fluctuation, to be shared with another displacement; it must not be changed.
  [[nodiscard]] NodalVector shared_fluctuation() const { return fluctuation_.shared(); }

  /// Amplitude a of the macroscopic part [-].
  [[nodiscard]] double macroscopic() const noexcept { return macroscopic_; }
  void set_macroscopic(double amplitude) noexcept { macroscopic_ = amplitude; }
  /// Fluctuation w.
  [[nodiscard]] Vec fluctuation() const noexcept { return fluctuation_.get(); }
  /// Gives the fluctuation away, to free its memory, or takes another one.
  [[nodiscard]] NodalVector take_fluctuation() noexcept { return std::move(fluctuation_); }
  void set_fluctuation(NodalVector fluctuation) noexcept { fluctuation_ = std::move(fluctuation); }
  /// Strains of the phases of the mixed cells of each process, cell by cell.
  [[nodiscard]] Vec phase_strains() const noexcept { return phase_strains_.get(); }

  /// this += factor * other
  void add(double factor, const Displacement& other);
  /// this *= factor
  void scale(double factor);
  void set_zero();

 private:
  double macroscopic_;
  NodalVector fluctuation_;
  NodalVector phase_strains_;
};

/// Forces that do work on a displacement are stored like one: the force F conjugate to the amplitude a in place of the
/// macroscopic part, the nodal forces f conjugate to w in place of the fluctuation, and likewise those conjugate to the
/// strains of the phases.
using Forces = Displacement;

/// Scalar product of nodal forces and of forces on strains of phases; held components are zero.
[[nodiscard]] double product(const Forces& a, const Forces& b);

/// Work of forces on a displacement, a F + w' f plus the work on the strains of phases; the same on all processes.
[[nodiscard]] double work(const Forces& forces, const Displacement& displacement);

}  // namespace breccia::quasistatic
