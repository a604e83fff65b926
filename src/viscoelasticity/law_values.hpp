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

/// Values from which a search may start: every combination of a few values of each parameter, for moduli or compliances
/// between `least` and `most` in a window of time.
std::vector<Eigen::VectorXd> starting_values(LawForm form, double least, double most, const TimeWindow& reach);

}  // namespace breccia
