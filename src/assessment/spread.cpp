#include "assessment/spread.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace breccia {
namespace {

/// The value below which a share of numbers lies.
double quantile(std::vector<double> numbers, double share) {
  const auto index = static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1));
  std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(index));
  return numbers[index];
}

}  // namespace

Spread spread_of(const Eigen::VectorXd& numbers) {
  constexpr double tail = 0.025;
  const std::vector<double> all(numbers.begin(), numbers.end());
  return {quantile(all, 0.5), {quantile(all, tail), quantile(all, 1.0 - tail)}};
}

}  // namespace breccia
