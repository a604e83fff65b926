#include "films/mesh/grading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace breccia::films {

double graded(double x) {
  constexpr double grading = 0.7;
  return x - grading / (2.0 * std::numbers::pi) * std::sin(2.0 * std::numbers::pi * x);
}

std::vector<double> graded_divisions(double length, double first, double longest) {
  constexpr double growth = 1.5;
  std::vector<double> reached = {0.0};
  for (double element = first; reached.back() < 0.5 * length; element *= growth) {
    reached.push_back(reached.back() + std::min(element, longest));
  }
  const std::size_t half = reached.size() - 1;
  std::vector<double> shares(2 * half + 1, 0.5);
  for (std::size_t k = 0; k < half; ++k) {
    shares[k] = 0.5 * reached[k] / reached.back();
    shares[2 * half - k] = 1.0 - shares[k];
  }
  return shares;
}

}  // namespace breccia::films
