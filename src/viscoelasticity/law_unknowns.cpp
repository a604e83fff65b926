#include "viscoelasticity/law_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace breccia {

LawUnknowns::LawUnknowns(LawForm form, std::vector<Bounds> bounds, LawState state)
    : form_(form), bounds_(std::move(bounds)), state_(std::move(state)) {
  for (std::size_t i = 0; i < state_.origins.size(); ++i) {
    if (state_.origins[i] == ParameterOrigin::fitted) fitted_.push_back(static_cast<Eigen::Index>(i));
  }
}

Eigen::Index LawUnknowns::parameter(Eigen::Index unknown) const {
  return fitted_[static_cast<std::size_t>(unknown)];
}

Eigen::VectorXd LawUnknowns::of_state() const {
  constexpr double just_inside = 1e-6;
  Eigen::VectorXd unknowns(size());
  for (Eigen::Index j = 0; j < size(); ++j) {
    const double s = std::clamp(place(parameter(j), state_.values[parameter(j)]), just_inside, 1.0 - just_inside);
    unknowns[j] = std::log(s / (1.0 - s));
  }
  return unknowns;
}

Eigen::VectorXd LawUnknowns::values(const Eigen::VectorXd& unknowns) const {
  auto values = state_.values;
  for (Eigen::Index j = 0; j < size(); ++j) {
    const auto i = parameter(j);
    const auto& [lower, upper] = bounds_[static_cast<std::size_t>(i)];
    const double first = scaled(i, lower), last = scaled(i, upper);
    const double value = first + (last - first) / (1.0 + std::exp(-unknowns[j]));
    values[i] = is_exponent(i) ? value : std::exp(value);
  }
  return values;
}

double LawUnknowns::scaled(Eigen::Index parameter, double value) const {
  return is_exponent(parameter) ? value : std::log(value);
}

double LawUnknowns::slope(Eigen::Index unknown) const {
  const auto i = parameter(unknown);
  const auto& [lower, upper] = bounds_[static_cast<std::size_t>(i)];
  const double s = place(i, state_.values[i]);
  return (scaled(i, upper) - scaled(i, lower)) * s * (1.0 - s);
}

std::optional<double> LawUnknowns::bound_at(Eigen::Index parameter, double value) const {
  constexpr double near = 1e-3;
  const double s = place(parameter, value);
  const auto& [lower, upper] = bounds_[static_cast<std::size_t>(parameter)];
  if (s < near) return lower;
  return s > 1.0 - near ? std::optional(upper) : std::nullopt;
}

double LawUnknowns::place(Eigen::Index parameter, double value) const {
  const auto& [lower, upper] = bounds_[static_cast<std::size_t>(parameter)];
  const double first = scaled(parameter, lower), last = scaled(parameter, upper);
  return (scaled(parameter, value) - first) / (last - first);
}

bool LawUnknowns::is_exponent(Eigen::Index parameter) const {
  return parameters_of(form_)[static_cast<std::size_t>(parameter)].kind == ParameterKind::exponent;
}

}  // namespace breccia
