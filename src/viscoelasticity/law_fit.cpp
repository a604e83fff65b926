#include "breccia/viscoelasticity/law_fit.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/law_series.hpp"

#include "viscoelasticity/fitted_data.hpp"
#include "viscoelasticity/law_search.hpp"

namespace breccia {
namespace {

bool is_of_creep(LawForm form) {
  return form == LawForm::power_law_creep || form == LawForm::logarithmic_creep;
}

void require_law_of_moduli(LawForm form) {
  if (!is_of_creep(form)) return;
  throw InputError(
      fmt::format("{} is a creep compliance: it is fitted to creep compliances, not to moduli", name_of(form)));
}

Eigen::VectorXd column(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Values of a function at each of some times or frequencies.
template <class Function>
Eigen::VectorXd values_at(std::span<const double> at, const Function& function) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(at.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = function(at[static_cast<std::size_t>(i)]);
  return values;
}

/// The data of values at times, without their predictions.
LawProblem problem_in_time(std::span<const double> times, std::span<const double> values) {
  return {.data = column(values),
          .at = {times.begin(), times.end()},
          .range = {.least = std::ranges::min(values),
                    .most = std::ranges::max(values),
                    .reach = {times.front(), times.back()}},
          .predict = {},
          .foresee = {}};
}

}  // namespace

std::vector<std::string> mistakes_in(LawForm form, const GivenParameters& given) {
  const auto parameters = parameters_of(form);
  std::vector<std::string> mistakes;
  std::vector<std::string_view> keys;
  for (const auto& parameter : parameters) keys.push_back(parameter.key);
  for (auto one = given.begin(); one != given.end(); ++one) {
    const auto& [key, value] = *one;
    const auto known = std::ranges::find(parameters, key, &LawParameter::key);
    if (known == parameters.end()) {
      mistakes.push_back(
          fmt::format("{}: not a parameter of {}, which has {}", key, name_of(form), fmt::join(keys, ", ")));
      continue;
    }
    const bool is_twice =
        std::find_if(given.begin(), one, [one](const auto& other) { return other.first == one->first; }) != one;
    if (is_twice) mistakes.push_back(fmt::format("{}: given twice", key));
    const bool is_exponent = known->kind == ParameterKind::exponent;
    const bool is_inside = value > 0.0 && value < (is_exponent ? 1.0 : std::numeric_limits<double>::infinity());
    if (is_inside || value == known->limit) continue;
    mistakes.push_back(fmt::format("{}: expected {}, got {:g}", key,
                                   is_exponent ? "a number between 0 and 1" : "a positive number", value));
  }
  const auto k = std::ranges::find(given, "k", &std::pair<std::string, double>::first);
  const auto h = std::ranges::find(given, "h", &std::pair<std::string, double>::first);
  if (mistakes.empty() && k != given.end() && h != given.end() && k->second > h->second) {
    mistakes.push_back(fmt::format("k: expected a number up to h, {:g}, got {:g}", h->second, k->second));
  }
  return mistakes;
}

LawFit fit_law_to_dynamic_moduli(LawForm form, std::span<const double> frequencies, std::span<const double> storage,
                                 std::span<const double> loss, const GivenParameters& given) {
  require_law_of_moduli(form);
  require_fitted_data(frequencies, {storage, loss}, "dynamic data");
  LawProblem problem;
  problem.data.resize(static_cast<Eigen::Index>(2 * frequencies.size()));
  problem.data << column(storage), column(loss);
  problem.at.assign(frequencies.begin(), frequencies.end());
  problem.at.insert(problem.at.end(), frequencies.begin(), frequencies.end());
  problem.range.least = std::ranges::min(storage);
  problem.range.most = std::ranges::max(storage);
  problem.range.reach = {1.0 / frequencies.back(), 1.0 / frequencies.front()};
  problem.predict = [frequencies](const ViscoelasticLaw& law) {
    const auto count = static_cast<Eigen::Index>(frequencies.size());
    Eigen::VectorXd moduli(2 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto modulus =
          carson_modulus(std::get<RelaxationLaw>(law), {0.0, frequencies[static_cast<std::size_t>(i)]});
      moduli[i] = modulus.real();
      moduli[count + i] = modulus.imag();
    }
    return moduli;
  };
  problem.foresee = problem.predict;
  return search_law(form, problem, given);
}

LawFit fit_law_to_moduli(LawForm form, std::span<const double> times, std::span<const double> moduli,
                         const GivenParameters& given) {
  require_law_of_moduli(form);
  require_fitted_data(times, {moduli}, "relaxation data");
  auto problem = problem_in_time(times, moduli);
  problem.predict = [times](const ViscoelasticLaw& law) {
    const auto series = series_of(law);
    return values_at(times, [&](double t) { return series.at(t); });
  };
  // A relaxation modulus at t is near the storage modulus at the frequency 0.5 / t.
  problem.foresee = [times](const ViscoelasticLaw& law) {
    return values_at(times, [&](double t) {
      return carson_modulus(std::get<RelaxationLaw>(law), {0.0, 0.5 / t}).real();
    });
  };
  return search_law(form, problem, given);
}

LawFit fit_law_to_compliances(LawForm form, std::span<const double> times, std::span<const double> compliances,
                              const GivenParameters& given) {
  if (!is_of_creep(form)) {
    throw InputError(fmt::format(
        "{} is a modulus: it is fitted to dynamic or relaxation moduli, not to creep compliances", name_of(form)));
  }
  require_fitted_data(times, {compliances}, "creep data");
  auto problem = problem_in_time(times, compliances);
  problem.predict = [times](const ViscoelasticLaw& law) {
    return values_at(times, [&](double t) { return compliance_at(std::get<CreepLaw>(law), t); });
  };
  problem.foresee = problem.predict;
  return search_law(form, problem, given);
}

}  // namespace breccia
