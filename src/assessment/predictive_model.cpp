#include "assessment/predictive_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace breccia {

Eigen::VectorXd PredictiveModel::deviations(const Eigen::VectorXd& scores) const {
  auto deviations = predictions(scores);
  for (std::size_t i = 0; i < observations().size(); ++i) {
    const auto& observation = observations()[i];
    auto& one = deviations[static_cast<Eigen::Index>(i)];
    // The trial of a search may have all but relaxed, where the error of the contour may make it negative.
    constexpr double least = 1e-30;
    const double difference = observation.curve == ObservedCurve::phase
                                  ? one - observation.value
                                  : std::log(std::max(one / observation.value, least));
    one = difference / observation.deviation;
  }
  return deviations;
}

}  // namespace breccia
