#include "viscoelasticity/law_values.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "breccia/viscoelasticity/law_series.hpp"

namespace breccia {
namespace {

/// One value a decade from some decades before a window to some after it.
std::vector<double> decades_around(const TimeWindow& reach, int before, int after) {
  const int first = static_cast<int>(std::floor(std::log10(reach.begin))) - before;
  const int last = static_cast<int>(std::ceil(std::log10(reach.end))) + after;
  std::vector<double> times;
  for (int exponent = first; exponent <= last; ++exponent) times.push_back(std::pow(10.0, exponent));
  return times;
}

}  // namespace

Eigen::VectorXd in_order(LawForm form, const Eigen::VectorXd& values) {
  if (form != LawForm::two_springs_two_parabolas_dashpot || values[4] <= values[5]) return values;
  // delta (p tau)^-k becomes (p tau')^-k, and (p tau)^-h delta' (p tau')^-h.
  const double delta = values[2], k = values[4], h = values[5], shorter = std::pow(delta, -1.0 / k);
  Eigen::VectorXd ordered = values;
  ordered[2] = std::pow(delta, -h / k);
  ordered[3] *= shorter;
  ordered[4] = h;
  ordered[5] = k;
  ordered[6] /= shorter;
  return ordered;
}

ViscoelasticLaw law_with(LawForm form, const Eigen::VectorXd& any_order) {
  const auto values = in_order(form, any_order);
  switch (form) {
    case LawForm::two_springs_two_parabolas_dashpot:
      return RelaxationLaw(TwoSpringsTwoParabolasDashpot{.static_modulus = values[0],
                                                         .glassy_modulus = values[1],
                                                         .delta = values[2],
                                                         .time = values[3],
                                                         .k = values[4],
                                                         .h = values[5],
                                                         .beta = values[6]});
    case LawForm::fractional_zener:
      return RelaxationLaw(
          FractionalZener{.equilibrium = values[0], .unrelaxed = values[1], .time = values[2], .exponent = values[3]});
    case LawForm::power_law_creep:
      return CreepLaw(
          PowerLawCreep{.instantaneous = values[0], .creep = values[1], .time = values[2], .exponent = values[3]});
    case LawForm::logarithmic_creep:
      break;
  }
  return CreepLaw(
      LogarithmicCreep{.instantaneous = values[0], .creep = values[1], .time = values[2], .exponent = values[3]});
}

PronySeries series_of(const ViscoelasticLaw& law) {
  return std::visit([](const auto& any) { return series_of(any); }, law);
}

std::vector<std::vector<double>> starting_values(LawForm form, const RangeOfData& data) {
  const auto& [least, most, reach] = data;
  switch (form) {
    case LawForm::two_springs_two_parabolas_dashpot:
      return {{1e-3 * least, 0.9 * least},
              {1.05 * most, 3.0 * most},
              {1.0, 3.0, 9.0},
              decades_around(reach, 3, 0),
              {0.15, 0.35},
              {0.5, 0.7},
              {10.0, 1e3, 1e5}};
    case LawForm::fractional_zener:
      return {{1e-3 * least, 0.9 * least},
              {1.05 * most, 3.0 * most, 30.0 * most},
              decades_around(reach, 3, 1),
              {0.2, 0.4, 0.6, 0.8}};
    case LawForm::power_law_creep:
    case LawForm::logarithmic_creep:
      break;
  }
  return {{0.1 * least, 0.9 * least},
          {0.01 * most, 0.1 * most, 0.5 * most, most},
          decades_around(reach, 3, 1),
          {0.1, 0.3, 0.6, 0.9}};
}

std::vector<Eigen::VectorXd> combinations(const std::vector<std::vector<double>>& lists) {
  std::vector<Eigen::VectorXd> all = {Eigen::VectorXd(static_cast<Eigen::Index>(lists.size()))};
  for (std::size_t i = 0; i < lists.size(); ++i) {
    std::vector<Eigen::VectorXd> longer;
    for (const auto& before : all) {
      for (const double value : lists[i]) {
        longer.push_back(before);
        longer.back()[static_cast<Eigen::Index>(i)] = value;
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<Bounds> bounds_of(LawForm form, const RangeOfData& data) {
  constexpr double stiffest = 1e6, softest = 1e9, least_exponent = 0.02, largest_exponent = 0.95, decades = 1e9;
  std::vector<Bounds> bounds;
  for (const auto& parameter : parameters_of(form)) {
    switch (parameter.kind) {
      case ParameterKind::modulus:
        bounds.push_back({data.least / softest, data.most * stiffest});
        break;
      case ParameterKind::compliance:
        bounds.push_back({data.least / stiffest, data.most * softest});
        break;
      case ParameterKind::time:
        bounds.push_back({data.reach.begin / decades, data.reach.end * decades});
        break;
      case ParameterKind::number:
        bounds.push_back({1.0 / softest, softest});
        break;
      case ParameterKind::exponent:
        bounds.push_back({least_exponent, parameter.limit.value_or(largest_exponent)});
        break;
    }
  }
  return bounds;
}

}  // namespace breccia
