#include "viscoelasticity/talbot_contour.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace breccia {

TalbotContour::TalbotContour(double time, int nodes) : scale_(2.0 * nodes / (5.0 * time)) {
  variables_.emplace_back(scale_);
  growths_.emplace_back(std::exp(scale_ * time));
  slopes_.emplace_back(0.5);
  for (int k = 1; k < nodes; ++k) {
    const double angle = k * std::numbers::pi / nodes, cotangent = 1.0 / std::tan(angle);
    const std::complex<double> s = scale_ * angle * std::complex<double>(cotangent, 1.0);
    variables_.push_back(s);
    growths_.push_back(std::exp(time * s));
    slopes_.emplace_back(1.0, angle + (angle * cotangent - 1.0) * cotangent);
  }
}

double TalbotContour::function(std::span<const std::complex<double>> times_s) const {
  double sum = slopes_[0].real() * growths_[0].real() * times_s[0].real() / variables_[0].real();
  for (std::size_t k = 1; k < times_s.size(); ++k) {
    sum += (growths_[k] * times_s[k] / variables_[k] * slopes_[k]).real();
  }
  return sum * scale_ / static_cast<double>(times_s.size());
}

}  // namespace breccia
