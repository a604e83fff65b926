#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/observation.hpp"

#include "assessment/observed_value.hpp"
#include "assessment/predictive_model.hpp"
#include "assessment/unknown_vector.hpp"

namespace breccia {

/// The predictions of what was observed as functions of the scores of all unknowns: those of the materials, then a
/// factor for each composite whose model is not exact. Composites share the unknowns of the materials by their names.
/// A prediction takes the moduli of the composite at complex Laplace variables, by the correspondence principle; no
/// series is fitted.
class ObservedModel final : public PredictiveModel {
 public:
  /// Throws InputError: as UnknownVector; for a composite without a measurement or the tests that one needs, or of
  /// another definition of a shared material; for a value that is not positive.
  ObservedModel(std::vector<ObservedComposite> composites, const std::vector<Unknown>& unknowns,
                std::vector<Observation> observations);

  [[nodiscard]] const std::vector<ObservedComposite>& composites() const noexcept { return composites_; }
  [[nodiscard]] const std::vector<Observation>& observations() const noexcept override { return observations_; }
  [[nodiscard]] const UnknownVector& unknowns() const noexcept { return unknowns_; }
  [[nodiscard]] const std::vector<UnknownComponent>& components() const noexcept override { return components_; }
  [[nodiscard]] Eigen::VectorXd predictions(const Eigen::VectorXd& scores) const override;
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& scores) const override;

 private:
  /// A composite at one temperature.
  struct State {
    std::size_t composite = 0;
    std::optional<double> temperature = {};
  };
  /// A state at a Laplace variable.
  struct Point {
    std::size_t state = 0;
    std::complex<double> variable = {};  ///< [1/s]
    bool has_bulk = false;               ///< whether the bulk modulus is needed there
  };
  /// The function of an observation, and the points of its Laplace variables.
  struct Plan {
    ObservedValue observed;
    std::vector<std::size_t> points;
  };
  /// The shear and the bulk modulus at a point, with their derivatives by the moduli of materials.
  struct PointModuli {
    ModulusAndGradient shear = {}, bulk = {};
  };
  using MaterialsOfStates = std::vector<std::vector<ShiftedMaterial>>;

  [[nodiscard]] std::size_t state_of(const Observation& observation);
  [[nodiscard]] std::size_t point_of(const Observation& observation, std::complex<double> variable);
  [[nodiscard]] MaterialsOfStates materials_of_states(const Eigen::VectorXd& scores) const;
  /// Number of threads that gain from the points.
  [[nodiscard]] int threads() const;
  [[nodiscard]] std::vector<PointModuli> moduli_at_points(const Eigen::VectorXd& scores) const;
  [[nodiscard]] PointModuli moduli_at(const Point& point, const std::vector<ShiftedMaterial>& materials) const;
  [[nodiscard]] Eigen::VectorXd predictions_from(const std::vector<PointModuli>& moduli,
                                                 const Eigen::VectorXd& scores) const;
  [[nodiscard]] std::vector<ComplexModuli> differences(const ShiftedMaterial& more, const ShiftedMaterial& less) const;
  [[nodiscard]] Eigen::VectorXd changes(const std::vector<PointModuli>& moduli, const std::string& material,
                                        const std::vector<ComplexModuli>& differences) const;
  [[nodiscard]] double factor(std::size_t observation, const Eigen::VectorXd& scores) const;

  std::vector<ObservedComposite> composites_;
  std::vector<Observation> observations_;
  UnknownVector unknowns_;
  std::vector<UnknownComponent> components_;
  std::vector<std::optional<std::size_t>> factors_;  ///< component of the factor of each composite
  std::vector<State> states_;
  std::vector<Point> points_;
  std::vector<Plan> plans_;
};

}  // namespace breccia
