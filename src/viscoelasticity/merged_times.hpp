#pragma once

#include <vector>

#include <Eigen/Core>

namespace breccia {

/// Lists of relaxation times from few to many: the list at the index n has n times [s], rising. The longest list has
/// all times of a positive weight. Each shorter list is the next longer one with two neighbours merged at the weighted
/// mean of their logarithms: the pair with the least w1 w2 / (w1 + w2) ln(tau_1 / tau_2)^2, by which merging adds to
/// the weighted squares of the logarithms about their means (Ward's criterion). `relaxation_times` must rise.
std::vector<Eigen::VectorXd> merged_times(const Eigen::VectorXd& relaxation_times, const Eigen::VectorXd& weights);

}  // namespace breccia
