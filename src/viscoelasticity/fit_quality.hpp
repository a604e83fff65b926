#pragma once

#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/fit.hpp"

namespace breccia {

/// The quality of a fit by least squares of relative deviations (theory, section 13). `at` has the time or frequency of
/// each datum; `derivatives` those of the deviations by the unknowns, data x unknowns.
FitQuality quality_of_fit(const Eigen::VectorXd& data, const Eigen::VectorXd& deviations, const std::vector<double>& at,
                          const Eigen::MatrixXd& derivatives);

}  // namespace breccia
