#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/law_fit.hpp"

#include "viscoelasticity/law_values.hpp"

namespace breccia {

/// The data of the search for the parameters of a law.
struct LawProblem {
  Eigen::VectorXd data;
  std::vector<double> at;  ///< time [s] or angular frequency [rad/s] of each datum
  RangeOfData range;       ///< of the data
  std::function<Eigen::VectorXd(const ViscoelasticLaw&)> predict;  ///< at each datum
  std::function<Eigen::VectorXd(const ViscoelasticLaw&)> foresee;  ///< a quick estimate of it, to choose where to begin
};

/// Searches the values of the parameters of a law that were not given (theory, section 13). Throws InputError and
/// NumericalError as fit_law_to_moduli().
LawFit search_law(LawForm form, const LawProblem& problem, const GivenParameters& given);

}  // namespace breccia
