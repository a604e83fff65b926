#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/law_fit.hpp"

#include "viscoelasticity/law_values.hpp"

namespace breccia {

/// The parameters of a law during a search.
struct LawState {
  Eigen::VectorXd values;  ///< in the order of parameters_of(), in SI units
  std::vector<ParameterOrigin> origins;
};

/// The unknowns of a search: of each fitted parameter ln(s / (1 - s)), with its place s between its bounds, on a
/// logarithmic scale but for exponents. So any unknowns belong to values within the bounds.
class LawUnknowns {
 public:
  LawUnknowns(LawForm form, std::vector<Bounds> bounds, LawState state);

  /// Their number.
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(fitted_.size()); }
  /// The number of the parameter to which an unknown belongs.
  [[nodiscard]] Eigen::Index parameter(Eigen::Index unknown) const;
  /// The unknowns of the present values; of a value at or beyond a bound those of one just inside.
  [[nodiscard]] Eigen::VectorXd of_state() const;
  /// The values of all parameters for other unknowns.
  [[nodiscard]] Eigen::VectorXd values(const Eigen::VectorXd& unknowns) const;

  /// A value on the scale of its parameter: an exponent as it is, anything else as its logarithm.
  [[nodiscard]] double scaled(Eigen::Index parameter, double value) const;
  /// The derivative of that by the unknown, at the present value.
  [[nodiscard]] double slope(Eigen::Index unknown) const;
  /// The bound of a parameter at which a value is, to a thousandth of the range; nothing inside.
  [[nodiscard]] std::optional<double> bound_at(Eigen::Index parameter, double value) const;

 private:
  [[nodiscard]] double place(Eigen::Index parameter, double value) const;
  [[nodiscard]] bool is_exponent(Eigen::Index parameter) const;

  LawForm form_;
  std::vector<Bounds> bounds_;
  LawState state_;
  std::vector<Eigen::Index> fitted_;  ///< numbers of the fitted parameters
};

}  // namespace breccia
