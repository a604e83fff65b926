#include "viscoelasticity/merged_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace breccia {
namespace {

struct Cluster {
  double logarithm;  ///< logarithm of the relaxation time [ln s]
  double weight;
};

double cost_of_merger(const Cluster& one, const Cluster& other) {
  const double distance = one.logarithm - other.logarithm;
  return one.weight * other.weight / (one.weight + other.weight) * distance * distance;
}

void merge_nearest(std::vector<Cluster>& clusters) {
  std::size_t best = 0;
  for (std::size_t i = 1; i + 1 < clusters.size(); ++i) {
    if (cost_of_merger(clusters[i], clusters[i + 1]) < cost_of_merger(clusters[best], clusters[best + 1])) best = i;
  }
  auto& [logarithm, weight] = clusters[best];
  const auto& next = clusters[best + 1];
  logarithm = (weight * logarithm + next.weight * next.logarithm) / (weight + next.weight);
  weight += next.weight;
  clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(best) + 1);
}

Eigen::VectorXd times_of(const std::vector<Cluster>& clusters) {
  Eigen::VectorXd times(static_cast<Eigen::Index>(clusters.size()));
  std::ranges::transform(clusters, times.begin(), [](const Cluster& cluster) { return std::exp(cluster.logarithm); });
  return times;
}

}  // namespace

std::vector<Eigen::VectorXd> merged_times(const Eigen::VectorXd& relaxation_times, const Eigen::VectorXd& weights) {
  std::vector<Cluster> clusters;
  for (Eigen::Index k = 0; k < relaxation_times.size(); ++k) {
    if (weights[k] > 0.0) clusters.push_back({std::log(relaxation_times[k]), weights[k]});
  }
  std::vector<Eigen::VectorXd> lists(clusters.size() + 1);
  for (auto n = clusters.size(); n > 0; --n) {
    lists[n] = times_of(clusters);
    if (n > 1) merge_nearest(clusters);
  }
  return lists;
}

}  // namespace breccia
