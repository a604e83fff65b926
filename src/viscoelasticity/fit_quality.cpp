#include "viscoelasticity/fit_quality.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "viscoelasticity/least_squares.hpp"

namespace breccia {

FitQuality quality_of_fit(const Eigen::VectorXd& data, const Eigen::VectorXd& deviations, const std::vector<double>& at,
                          const Eigen::MatrixXd& derivatives) {
  FitQuality quality;
  std::vector<double> errors;
  for (Eigen::Index i = 0; i < data.size(); ++i) {
    quality.fitted.push_back(data[i] * (1.0 + deviations[i]));
    errors.push_back(std::abs(deviations[i]));
  }
  const auto worst = std::max_element(errors.begin(), errors.end());
  quality.worst_error = *worst;
  quality.worst_at = at[static_cast<std::size_t>(worst - errors.begin())];
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  quality.median_error = errors[errors.size() / 2];

  // Covariance of the fit with the observed scatter s: s^2 A (A'A)^-1 A'. With as many unknowns as data no degree of
  // freedom is left, from which the scatter could be estimated.
  const auto freedom = data.size() - derivatives.cols();
  const double scatter =
      freedom > 0 ? std::sqrt(deviations.squaredNorm() / static_cast<double>(freedom)) : std::nan("");
  const Eigen::MatrixXd basis = orthonormal_basis(derivatives);
  for (Eigen::Index i = 0; i < data.size(); ++i) quality.standard_errors.push_back(scatter * basis.row(i).norm());
  return quality;
}

}  // namespace breccia
