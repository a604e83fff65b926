#pragma once

#include <vector>

#include <Eigen/Core>

namespace breccia {

/// Lists of relaxation times from few to many: the list at the index n has n of them [s], rising. The longest has all
/// times of a positive weight. Each other one is the next with two neighbours merged at the mean of their logarithms,
/// weighted, where that adds least to the weighted squares of the logarithms about their means,
/// w1 w2 / (w1 + w2) ln(tau_1 / tau_2)^2 (Ward's criterion). `relaxation_times` rise.
std::vector<Eigen::VectorXd> merged_times(const Eigen::VectorXd& relaxation_times, const Eigen::VectorXd& weights);

}  // namespace breccia
