#include "breccia/microstructure/convex_cell.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {

constexpr double cut_tolerance = 4e-15;  // tolerance as a share of the diagonal of the box from which a cell is cut

/// Volume of the simplex spanned by `dim` vectors from a common corner [m^dim].
double simplex_volume(const std::array<Vector<2>, 2>& edges) {
  return 0.5 * std::abs(edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0]);
}

Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double simplex_volume(const std::array<Vector<3>, 3>& edges) {
  return std::abs(dot(edges[0], cross(edges[1], edges[2]))) / 6.0;
}

double triangle_area(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
  return 0.5 * norm(cross(b - a, c - a));
}

/// Calls visit(corner, across, slot) once for every edge: it joins two corners and leads away from the plane `slot` of
/// the first one.
template <int dim, class Visit>
void visit_edges(const ConvexCell<dim>& cell, Visit&& visit) {
  for (std::size_t corner = 0; corner < cell.corners().size(); ++corner) {
    for (std::size_t slot = 0; slot < dim; ++slot) {
      const std::size_t across = cell.corner_across(corner, slot);
      if (across > corner && across < cell.corners().size()) visit(corner, across, slot);
    }
  }
}

/// Calls visit(plane, measure, others) for simplices that fill the cell. All have the first corner of the cell in
/// common; the `others` are on the face of one half-space, where they span a simplex of this measure.
template <class Visit>
void visit_simplices(const ConvexCell<2>& cell, Visit&& visit) {
  visit_edges(cell, [&](std::size_t corner, std::size_t across, std::size_t slot) {
    const auto& begin = cell.corners()[corner];
    const auto& end = cell.corners()[across].position;
    visit(begin.planes[1 - slot], norm(end - begin.position), std::array{begin.position, end});
  });
}

template <class Visit>
void visit_simplices(const ConvexCell<3>& cell, Visit&& visit) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> apex(cell.half_spaces().size(), none);  // a corner of each face
  for (std::size_t corner = 0; corner < cell.corners().size(); ++corner) {
    for (const auto plane : cell.corners()[corner].planes) apex[plane] = std::min(apex[plane], corner);
  }
  visit_edges(cell, [&](std::size_t corner, std::size_t across, std::size_t slot) {
    const auto& begin = cell.corners()[corner];
    const auto& end = cell.corners()[across].position;
    for (const std::size_t side : {(slot + 1) % 3, (slot + 2) % 3}) {
      const auto plane = begin.planes[side];
      if (apex[plane] == corner || apex[plane] == across) continue;
      const auto& top = cell.corners()[apex[plane]].position;
      visit(plane, triangle_area(top, begin.position, end), std::array{top, begin.position, end});
    }
  });
}

/// The vectors from the first corner of a cell to the corners of a simplex.
template <std::size_t dim>
std::array<Vector<dim>, dim> seen_from(const Vector<dim>& origin, std::array<Vector<dim>, dim> corners) {
  for (auto& corner : corners) corner -= origin;
  return corners;
}

}  // namespace

template <int dim>
ConvexCell<dim>::ConvexCell(const Vector<dim>& lower, const Vector<dim>& upper, const BoxSides& behind)
    : tolerance_(cut_tolerance * norm(upper - lower)) {
  for (std::uint32_t axis = 0; axis < dim; ++axis) {
    Vector<dim> normal{};
    normal[axis] = -1.0;
    half_spaces_.push_back({normal, -lower[axis], behind[axis][0]});
    normal[axis] = 1.0;
    half_spaces_.push_back({normal, upper[axis], behind[axis][1]});
  }
  // The bits say whether a corner is at the lower or the upper side along each axis.
  for (std::uint32_t sides = 0; sides < (1U << dim); ++sides) {
    Corner corner{};
    for (std::uint32_t axis = 0; axis < dim; ++axis) {
      const std::uint32_t is_above = (sides >> axis) & 1U;
      corner.position[axis] = is_above ? upper[axis] : lower[axis];
      corner.planes[axis] = 2 * axis + is_above;
    }
    if (std::popcount(sides) % 2 != 0) std::swap(corner.planes[0], corner.planes[1]);  // counter-clockwise
    corners_.push_back(corner);
  }
}

template <int dim>
double ConvexCell<dim>::reach() const noexcept {
  double square = 0.0;
  for (const Corner& corner : corners_) square = std::max(square, dot(corner.position, corner.position));
  return std::sqrt(square);
}

template <int dim>
std::size_t ConvexCell<dim>::corner_across(std::size_t corner, std::size_t slot) const noexcept {
  const auto& planes = corners_[corner].planes;
  const auto is_across = [&](const Corner& other) {
    for (std::size_t other_slot = 0; other_slot < planes.size(); ++other_slot) {
      if (other_slot == slot) continue;
      if (std::ranges::find(other.planes, planes[other_slot]) == other.planes.end()) return false;
    }
    return &other != &corners_[corner];
  };
  return static_cast<std::size_t>(std::ranges::find_if(corners_, is_across) - corners_.begin());
}

template <int dim>
bool ConvexCell<dim>::cut(const HalfSpace<dim>& half_space) {
  const auto is_kept = [&](const Corner& corner) { return half_space.height(corner.position) <= tolerance_; };
  if (std::ranges::all_of(corners_, is_kept)) return false;
  const auto plane = static_cast<std::uint32_t>(half_spaces_.size());
  half_spaces_.push_back(half_space);
  const auto removed = std::partition(corners_.begin(), corners_.end(), is_kept);
  const auto kept = static_cast<std::size_t>(removed - corners_.begin());
  const std::size_t all = corners_.size();
  // An edge from a kept corner to a removed one now ends at the new plane.
  for (std::size_t corner = kept; corner < all; ++corner) {
    const double above = half_space.height(corners_[corner].position);
    for (std::size_t slot = 0; slot < dim; ++slot) {
      const std::size_t across = corner_across(corner, slot);
      if (across >= kept) continue;
      const double below = half_space.height(corners_[across].position);
      Corner end = corners_[corner];
      end.planes[slot] = plane;
      const auto& start = corners_[across].position;
      end.position = start + std::max(0.0, -below) / (above - below) * (end.position - start);
      corners_.push_back(end);
    }
  }
  corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(kept),
                 corners_.begin() + static_cast<std::ptrdiff_t>(all));
  return true;
}

template <int dim>
void ConvexCell<dim>::trim() {
  std::vector<std::uint32_t> number(half_spaces_.size(), 0);
  for (const Corner& corner : corners_) {
    for (const auto plane : corner.planes) number[plane] = 1;
  }
  std::uint32_t kept = 0;
  for (std::size_t plane = 0; plane < number.size(); ++plane) {
    if (number[plane] == 0) continue;
    half_spaces_[kept] = half_spaces_[plane];
    number[plane] = kept++;
  }
  half_spaces_.erase(half_spaces_.begin() + kept, half_spaces_.end());
  for (Corner& corner : corners_) {
    for (auto& plane : corner.planes) plane = number[plane];
  }
}

template <int dim>
ConvexCell<dim> ConvexCell<dim>::eroded(double distance) const {
  return eroded([distance](const HalfSpace<dim>&) { return distance; });
}

template <int dim>
ConvexCell<dim> ConvexCell<dim>::eroded(const std::function<double(const HalfSpace<dim>&)>& distance) const {
  ConvexCell result = *this;
  for (HalfSpace<dim> half_space : half_spaces_) {
    const double depth = distance(half_space);
    if (!(depth > 0.0)) continue;
    half_space.offset -= depth;
    result.cut(half_space);
  }
  result.trim();
  return result;
}

template <int dim>
double volume(const ConvexCell<dim>& cell) {
  double sum = 0.0;
  if (cell.is_empty()) return sum;
  const auto& origin = cell.corners().front().position;
  visit_simplices(
      cell, [&](std::uint32_t, double, const auto& corners) { sum += simplex_volume(seen_from(origin, corners)); });
  return sum;
}

template <int dim>
std::vector<double> face_measures(const ConvexCell<dim>& cell) {
  std::vector<double> measures(cell.half_spaces().size(), 0.0);
  visit_simplices(cell, [&](std::uint32_t plane, double measure, const auto&) { measures[plane] += measure; });
  return measures;
}

template <int dim>
Moments<dim> moments(const ConvexCell<dim>& cell) {
  Moments<dim> result;
  if (cell.is_empty()) return result;
  // For a simplex with corners x_k and volume V: int x = V sum x_k / (dim + 1),
  // int x x' = V (sum x_k x_k' + sum x_k sum x_k') / ((dim + 1)(dim + 2)).
  const auto& origin = cell.corners().front().position;
  Vector<dim> first{};
  auto& second = result.covariance;
  visit_simplices(cell, [&](std::uint32_t, double, const auto& corners) {
    const auto points = seen_from(origin, corners);
    const double simplex = simplex_volume(points);
    Vector<dim> sum{};
    for (const auto& point : points) sum += point;
    result.volume += simplex;
    first += simplex / (dim + 1) * sum;
    for (std::size_t a = 0; a < dim; ++a) {
      const double share = simplex / ((dim + 1) * (dim + 2));
      second[a] += share * sum[a] * sum;
      for (const auto& point : points) second[a] += share * point[a] * point;
    }
  });
  if (!(result.volume > 0.0)) return Moments<dim>{0.0, origin, {}};
  for (double& x : first) x /= result.volume;
  for (std::size_t a = 0; a < dim; ++a) {
    for (std::size_t b = 0; b < dim; ++b) second[a][b] = second[a][b] / result.volume - first[a] * first[b];
  }
  result.centroid = origin + first;
  return result;
}

template <int dim>
double aspect_ratio(const Moments<dim>& moments) {
  if (!(moments.volume > 0.0)) return 1.0;
  Eigen::Matrix<double, dim, dim> covariance;
  for (int a = 0; a < dim; ++a) {
    for (int b = 0; b < dim; ++b) {
      covariance(a, b) = moments.covariance[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, dim, dim>> principal(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(principal.eigenvalues()(dim - 1) / principal.eigenvalues()(0));
}

std::vector<Vector<2>> polygon(const ConvexCell<2>& cell) {
  std::vector<Vector<2>> corners;
  corners.reserve(cell.corners().size());
  for (std::size_t corner = 0; corners.size() < cell.corners().size(); corner = cell.corner_across(corner, 0)) {
    corners.push_back(cell.corners()[corner].position);
  }
  return corners;
}

template class ConvexCell<2>;
template class ConvexCell<3>;
template double volume(const ConvexCell<2>&);
template double volume(const ConvexCell<3>&);
template std::vector<double> face_measures(const ConvexCell<2>&);
template std::vector<double> face_measures(const ConvexCell<3>&);
template Moments<2> moments(const ConvexCell<2>&);
template Moments<3> moments(const ConvexCell<3>&);
template double aspect_ratio(const Moments<2>&);
template double aspect_ratio(const Moments<3>&);

}  // namespace breccia
