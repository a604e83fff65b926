#pragma once

#include <Eigen/Core>

#include "breccia/assessment/interval.hpp"

namespace breccia {

/// The middle and the interval of 95 % of numbers.
struct Spread {
  double median = 0.0;
  Interval interval = {};
};

Spread spread_of(const Eigen::VectorXd& numbers);

}  // namespace breccia
