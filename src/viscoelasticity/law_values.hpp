#pragma once

#include <variant>
#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/creep_law.hpp"
#include "breccia/viscoelasticity/law_form.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/relaxation_law.hpp"

namespace breccia {

using ViscoelasticLaw = std::variant<RelaxationLaw, CreepLaw>;

/// Values in the order of parameters_of() with which k of 2S2P1D is not above h: its two parabolic elements change
/// places where it is, which leaves the modulus as it was.
Eigen::VectorXd in_order(LawForm form, const Eigen::VectorXd& values);

/// The law with values in the order of parameters_of(), which are put in_order() but not checked.
ViscoelasticLaw law_with(LawForm form, const Eigen::VectorXd& values);

/// The modulus as a Prony series. Throws as series_of().
PronySeries series_of(const ViscoelasticLaw& law);

/// What is known of data before a search.
struct RangeOfData {
  double least = 0.0;  ///< smallest modulus [Pa] or compliance [1/Pa]
  double most = 0.0;   ///< largest one
  TimeWindow reach;    ///< [s]
};

/// A few values of each parameter from which a search may start.
std::vector<std::vector<double>> starting_values(LawForm form, const RangeOfData& data);

/// All combinations of one value from each list.
std::vector<Eigen::VectorXd> combinations(const std::vector<std::vector<double>>& lists);

/// The values between which a parameter is sought.
struct Bounds {
  double lower;
  double upper;
};

/// The bounds of each parameter, so wide that only a parameter which the data do not show meets one: a Prony series of
/// few terms follows the law over the range of the data (exponents from 0.02 to 0.95, or to 1 where that is its limit,
/// the time within nine decades), and the stiffness at t = 0 is at most a million times what was measured.
std::vector<Bounds> bounds_of(LawForm form, const RangeOfData& data);

}  // namespace breccia
