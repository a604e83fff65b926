#include "edge_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace disc_packings {
namespace {

using Eigen::Vector2d;

double distance_to(const Disc& disc, const Vector2d& point) {
  return (point - disc.centre).norm() - disc.radius;
}

/// The length of elements at a point of an edge.
double element_length(const Edge& edge, const Vector2d& point, double share) {
  double least = std::numeric_limits<double>::max();  // the least R h
  for (const Disc& disc : {edge.one, edge.other}) {
    for (const Disc& near : edge.near) {
      if ((near.centre - disc.centre).norm() < 1e-9) continue;
      const double h = distance_to(disc, point) + distance_to(near, point);
      least = std::min(least, neck_radius(disc, near) * h);
    }
  }
  return share * std::sqrt(least);
}

/// Positions along an edge, dense in the neck: equally spaced in asinh((t - neck) / width).
std::vector<double> positions(const Edge& edge, int intervals) {
  const double length = (edge.end - edge.begin).norm();
  const Vector2d along = (edge.end - edge.begin).normalized();
  const Vector2d across = (edge.other.centre - edge.one.centre).normalized();
  const double gap_of_discs = gap(edge.one, edge.other);
  const Vector2d middle = edge.one.centre + across * (edge.one.radius + gap_of_discs / 2.0);
  const double neck = std::clamp(along.dot(middle - edge.begin), 0.0, length);
  const double width = std::sqrt(neck_radius(edge.one, edge.other) * gap_of_discs);
  const double first = std::asinh(-neck / width);
  const double last = std::asinh((length - neck) / width);
  std::vector<double> positions(intervals + 1);
  for (int i = 0; i <= intervals; ++i) {
    positions[i] = std::clamp(neck + width * std::sinh(first + (last - first) * i / intervals), 0.0, length);
  }
  positions.front() = 0.0;
  positions.back() = length;
  return positions;
}

/// Positions of the ends of the elements along an edge.
std::vector<double> element_ends(const Edge& edge, double share) {
  constexpr int intervals = 600;  // of the integral of one over the length of elements
  const Vector2d along = (edge.end - edge.begin).normalized();
  const std::vector<double> at = positions(edge, intervals);
  std::vector<double> elements(intervals + 1, 0.0);  // the number of elements, a real number, up to each position
  for (int i = 0; i < intervals; ++i) {
    const Vector2d middle = edge.begin + along * (at[i] + at[i + 1]) / 2.0;
    elements[i + 1] = elements[i] + (at[i + 1] - at[i]) / element_length(edge, middle, share);
  }
  const int count = std::max(1, static_cast<int>(std::ceil(elements.back())));
  std::vector<double> ends(count + 1, 0.0);
  ends.back() = at.back();
  for (int element = 1; element < count; ++element) {
    const double sought = elements.back() * element / count;
    const auto i = std::ranges::upper_bound(elements, sought) - elements.begin() - 1;
    ends[element] = at[i] + (at[i + 1] - at[i]) * (sought - elements[i]) / (elements[i + 1] - elements[i]);
  }
  return ends;
}

}  // namespace

std::vector<Vector2d> edge_points(const Edge& edge, const MeshSize& size) {
  const Vector2d along = (edge.end - edge.begin).normalized();
  const std::vector<double> ends = element_ends(edge, size.length);
  std::vector<Vector2d> points;
  for (std::size_t element = 0; element + 1 < ends.size(); ++element) {
    const double length = ends[element + 1] - ends[element];
    for (int node = 0; node < size.order; ++node) {
      points.push_back(edge.begin + along * (ends[element] + length * node / size.order));
    }
  }
  points.push_back(edge.end);
  return points;
}

}  // namespace disc_packings
