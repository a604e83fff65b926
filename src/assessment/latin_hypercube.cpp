#include "assessment/latin_hypercube.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>

#include "microstructure/uniform.hpp"

namespace breccia {
namespace {

/// The numbers from 0 to count - 1 in a random order, the same on every platform.
std::vector<Eigen::Index> random_order(Eigen::Index count, std::mt19937_64& engine) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[static_cast<std::size_t>(uniform(engine) * static_cast<double>(i))]);
  }
  return order;
}

/// The middles of slices of equal shares (inputs x points), in a random order for each input.
Eigen::MatrixXd random_shares(Eigen::Index inputs, Eigen::Index points, std::mt19937_64& engine) {
  Eigen::MatrixXd shares(inputs, points);
  for (Eigen::Index input = 0; input < inputs; ++input) {
    const auto order = random_order(points, engine);
    for (Eigen::Index point = 0; point < points; ++point) {
      shares(input, point) =
          (static_cast<double>(order[static_cast<std::size_t>(point)]) + 0.5) / static_cast<double>(points);
    }
  }
  return shares;
}

/// The largest correlation between the shares of two inputs.
double largest_correlation(const Eigen::MatrixXd& shares) {
  const Eigen::MatrixXd centred = shares.array() - 0.5;
  const Eigen::MatrixXd products = centred * centred.transpose();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < products.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      largest = std::max(largest, std::abs(products(i, j)) / std::sqrt(products(i, i) * products(j, j)));
    }
  }
  return largest;
}

double coordinate_at(const UncertainInput& input, double share) {
  const auto choices = choices_of(input);
  return choices > 0 ? std::floor(share * static_cast<double>(choices)) : normal_score(share);
}

}  // namespace

Eigen::MatrixXd latin_hypercube(const std::vector<UncertainInput>& inputs, Eigen::Index points, std::uint64_t seed) {
  constexpr int tries = 50;
  std::mt19937_64 engine(seed);
  const auto size = static_cast<Eigen::Index>(inputs.size());
  auto best = random_shares(size, points, engine);
  for (int i = 1; i < tries; ++i) {
    auto other = random_shares(size, points, engine);
    if (largest_correlation(other) < largest_correlation(best)) best = std::move(other);
  }
  for (Eigen::Index input = 0; input < size; ++input) {
    for (double& share : best.row(input)) {
      share = coordinate_at(inputs[static_cast<std::size_t>(input)], share);
    }
  }
  return best;
}

}  // namespace breccia
