#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/law_form.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// Where the value of a parameter of a fitted law comes from.
enum class ParameterOrigin {
  fitted,
  given,        ///< by the caller
  limit,        ///< the data do not determine it: the value at which the law does without it
  bound,        ///< the end of the range in which it is sought: the data ask for more, or do not show it
  of_no_effect  ///< the time of creep by a power law: another one changes the parameter `creep` and nothing else
};

/// A parameter of a fitted law.
struct FittedParameter {
  std::string_view key;  ///< as in decks
  double value = 0.0;    ///< in SI units
  /// From the scatter of the data, in the unit of the value; infinite where the data do not determine it, and 0 where
  /// it was not fitted.
  double standard_error = 0.0;
  ParameterOrigin origin = ParameterOrigin::fitted;
};

/// A law fitted to data.
struct LawFit {
  LawForm form = LawForm::two_springs_two_parabolas_dashpot;
  std::vector<FittedParameter> parameters = {};  ///< in the order of parameters_of()
  PronySeries series = {};                       ///< of the relaxation modulus (series_of)
  FitQuality quality = {};
};

/// Values of parameters that are given, by their keys, in SI units.
using GivenParameters = std::vector<std::pair<std::string, double>>;

/// What is wrong with given parameters, each mistake with its key: a key that the law does not have, one that is given
/// twice, a value out of its range, k above h.
std::vector<std::string> mistakes_in(LawForm form, const GivenParameters& given);

/// Fits the parameters of a law to storage and loss moduli [Pa] at angular frequencies [rad/s] that do not fall, by
/// least squares of the relative deviations (theory, section 13). The quality lists the storage moduli first. A
/// parameter takes its limit where the data are met as well with it. Throws InputError for mistakes_in() the given
/// parameters, for fewer data than unknowns and three more, for data that are out of order or not positive, and for a
/// law of creep; NumericalError when the search does not converge.
LawFit fit_law_to_dynamic_moduli(LawForm form, std::span<const double> frequencies, std::span<const double> storage,
                                 std::span<const double> loss, const GivenParameters& given = {});
/// The same for relaxation moduli [Pa] at times [s].
LawFit fit_law_to_moduli(LawForm form, std::span<const double> times, std::span<const double> moduli,
                         const GivenParameters& given = {});
/// The same for creep compliances [1/Pa] at times [s], for the laws of creep alone.
LawFit fit_law_to_compliances(LawForm form, std::span<const double> times, std::span<const double> compliances,
                              const GivenParameters& given = {});

}  // namespace breccia
