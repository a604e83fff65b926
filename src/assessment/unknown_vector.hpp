#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/unknown.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// A component of the vector of unknowns: a number of a material, a term of a spectrum, or the factor by which a
/// composite differs from its model.
struct UnknownComponent {
  std::string name = {};    ///< "hmx.shear", "binder.spectrum at 1 us", "model of pbx"
  std::size_t unknown = 0;  ///< index of the unknown
  std::size_t term = 0;     ///< index of the term of a spectrum
  std::string unit = {};    ///< SI unit; empty without one
  Distribution prior = {};
};

/// All unknowns of a calibration as one vector of scores (Distribution), which a priori are standard normal, but for
/// those of spectra.
class UnknownVector {
 public:
  /// Throws InputError, with a line for each mistake: an unknown that is named twice, one of a material that is not
  /// known, or a change that the material does not have (changed).
  UnknownVector(std::vector<Unknown> unknowns, std::vector<ShiftedMaterial> materials);

  [[nodiscard]] const std::vector<UnknownComponent>& components() const noexcept { return components_; }
  [[nodiscard]] Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(components_.size()); }
  /// The materials with their unknowns at these scores, in the order of the known ones.
  [[nodiscard]] std::vector<ShiftedMaterial> materials_at(const Eigen::VectorXd& scores) const;
  /// One of the materials with its unknowns at these scores.
  [[nodiscard]] ShiftedMaterial material_at(std::size_t material, const Eigen::VectorXd& scores) const;
  /// The index of the material that a component changes.
  [[nodiscard]] std::size_t index_of_material(std::size_t component) const {
    return material_of_unknown_[components_[component].unknown];
  }
  /// Whether a component is a term of a spectrum.
  [[nodiscard]] bool is_of_spectrum(std::size_t component) const {
    return std::holds_alternative<UnknownSpectrum>(unknowns_[components_[component].unknown]);
  }
  /// The standard deviations of the scores a priori: 1, and for the n terms of a spectrum the root of n, so that their
  /// mean has 1 however many they are.
  [[nodiscard]] Eigen::VectorXd prior_deviations() const;
  /// The curvature of the logarithms of the moduli of all spectra over the logarithm of the time, as a matrix by which
  /// the scores are multiplied: its square is the integral of the squared curvature. Without rows where no spectrum has
  /// three terms.
  [[nodiscard]] Eigen::MatrixXd curvature() const;

 private:
  std::vector<Unknown> unknowns_;
  std::vector<ShiftedMaterial> materials_;
  std::vector<std::size_t> material_of_unknown_;
  std::vector<UnknownComponent> components_;
};

}  // namespace breccia
