#include "dynamics/maxwell_step.hpp"

#include <cmath>

namespace breccia::dynamics {

std::vector<TermStep> maxwell_steps(const PronySeries& series, double time_step) {
  std::vector<TermStep> steps;
  for (const auto& [relaxation_time, modulus] : series.terms()) {
    const double x = time_step / relaxation_time;
    steps.push_back({std::exp(-x), -modulus * std::expm1(-x) / x});
  }
  return steps;
}

}  // namespace breccia::dynamics
