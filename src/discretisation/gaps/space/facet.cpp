#include "discretisation/gaps/space/facet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

using Corners = std::span<const Vector<3>>;
/// A number that depends on the flow, as a linear form of the flows through the edges and, last, of a circulation.
using FlowForm = Eigen::RowVectorXd;
using FlowForms = Eigen::Matrix<double, 3, Eigen::Dynamic>;

constexpr double least_area = 1e-14, least_width = 1e-9;

struct Triangle {
  std::array<Vector<3>, 3> corners;

  [[nodiscard]] Vector<3> at(double first, double second, double third) const noexcept {
    return first * corners[0] + second * corners[1] + third * corners[2];
  }
  [[nodiscard]] Vector<3> middle() const noexcept { return (corners[0] + corners[1] + corners[2]) / 3.0; }
  [[nodiscard]] double area() const noexcept {
    const auto a = corners[1] - corners[0], b = corners[2] - corners[0];
    const double along = dot(a, b);
    return 0.5 * std::sqrt(std::max(dot(a, a) * dot(b, b) - along * along, 0.0));
  }
  [[nodiscard]] double longest_side() const noexcept {
    const auto& [a, b, c] = corners;
    return std::max({norm(b - a), norm(c - b), norm(a - c)});
  }
  /// The four triangles of half the size in it.
  [[nodiscard]] std::array<Triangle, 4> quarters() const noexcept {
    const auto ab = at(0.5, 0.5, 0.0), bc = at(0.0, 0.5, 0.5), ca = at(0.5, 0.0, 0.5);
    return {{{{corners[0], ab, ca}}, {{ab, corners[1], bc}}, {{ca, bc, corners[2]}}, {{ab, bc, ca}}}};
  }
};

/// Dunavant's rule of six points (1985), exact for polynomials of the fourth degree.
struct RulePoint {
  double at_one, weight;  ///< weight of one corner in the place of the point; the other two share the rest
};
constexpr std::array<RulePoint, 2> triangle_rule = {
    {{0.108103018168070, 0.223381589678011}, {0.816847572980459, 0.109951743655322}}};

/// Calls action(point, weight) for the points of a rule of integration on a triangle, whose weights add up to its area.
/// It is divided where the width of the gap may vary by more than a third, as around the place where two particles are
/// nearest.
template <class Action>
void integrate(const Triangle& triangle, const WidthAt& width, int divisions, const Action& action) {
  constexpr double most_change = 0.35;
  const double size = triangle.longest_side();
  const auto varies_at = [&](const Vector<3>& point) {
    const auto [h, gradient] = width(point);
    return size * norm(gradient) > most_change * std::max(h, least_width);
  };
  if (divisions > 0 && (varies_at(triangle.middle()) || std::ranges::any_of(triangle.corners, varies_at))) {
    for (const auto& quarter : triangle.quarters()) integrate(quarter, width, divisions - 1, action);
    return;
  }
  const double area = triangle.area();
  for (const auto& [at_one, weight] : triangle_rule) {
    const double rest = 0.5 * (1.0 - at_one);
    action(triangle.at(at_one, rest, rest), weight * area);
    action(triangle.at(rest, at_one, rest), weight * area);
    action(triangle.at(rest, rest, at_one), weight * area);
  }
}

/// The triangles between the edges of a polygon and a centre.
std::vector<Triangle> triangles_around(const Vector<3>& centre, Corners corners) {
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    triangles.push_back({{centre, corners[k], corners[(k + 1) % corners.size()]}});
  }
  return triangles;
}

double area_of(std::span<const Triangle> triangles) {
  double area = 0.0;
  for (const auto& triangle : triangles) area += triangle.area();
  return area;
}

/// The centroid of a polygon, which need not be plane.
Vector<3> centroid(Corners corners) {
  Vector<3> mean{}, moment{};
  for (const auto& corner : corners) mean += corner / static_cast<double>(corners.size());
  const auto triangles = triangles_around(mean, corners);
  const double area = area_of(triangles);
  for (const auto& triangle : triangles) moment += triangle.area() * triangle.middle();
  return area > least_area ? moment / area : mean;
}

/// The flow in a polygon.
class Flow {
 public:
  explicit Flow(std::span<const Triangle> triangles) : triangles_(triangles) {
    const auto edges = static_cast<Eigen::Index>(triangles.size());
    divergence_ = FlowForm::Constant(edges + 1, 1.0 / area_of(triangles));
    divergence_[edges] = 0.0;
    // What flows into each triangle from the one before; the circulation is that into the first one.
    into_ = Eigen::MatrixXd::Zero(edges + 1, edges + 1);
    into_(0, edges) = 1.0;
    for (Eigen::Index k = 0; k < edges; ++k) {
      into_.row(k + 1) = into_.row(k) + triangles_[static_cast<std::size_t>(k)].area() * divergence_;
      into_(k + 1, k) -= 1.0;
    }
  }

  [[nodiscard]] const FlowForm& divergence() const noexcept { return divergence_; }
  /// The flow at a point of a triangle: a part for each of its sides, which vanishes in the opposite corner.
  [[nodiscard]] FlowForms at(std::size_t triangle, const Vector<3>& point) const {
    const auto& [centre, begin, end] = triangles_[triangle].corners;
    const auto number = static_cast<Eigen::Index>(triangle);
    const auto from = [&](const Vector<3>& corner) {
      const auto difference = point - corner;
      return Eigen::Vector3d(difference[0], difference[1], difference[2]);
    };
    FlowForms flow = from(begin) * into_.row(number + 1) - from(end) * into_.row(number);
    flow.col(number) += from(centre);
    return flow / (2.0 * triangles_[triangle].area());
  }

 private:
  std::span<const Triangle> triangles_;
  FlowForm divergence_;
  Eigen::MatrixXd into_;
};

}  // namespace

Facet make_facet(Corners corners, const WidthAt& width) {
  constexpr int most_divisions = 9;
  const auto triangles = triangles_around(centroid(corners), corners);
  const auto edges = static_cast<Eigen::Index>(corners.size());
  Facet facet = {.resistance = Eigen::MatrixXd::Zero(edges, edges), .slenderness = 0.0, .volume = 0.0};
  if (area_of(triangles) < least_area) return facet;
  const Flow flow(triangles);
  const auto& divergence = flow.divergence();
  Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(edges + 1, edges + 1);
  // A gap that closes also strains its cells, whose deviators have 4/3 of the square of the divergence.
  constexpr double of_closing = 3.6 - 4.0 / 3.0;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (triangles[k].area() < least_area) continue;
    integrate(triangles[k], width, most_divisions, [&](const Vector<3>& point, double area) {
      const auto [found, gradient] = width(point);
      const double h = std::max(found, least_width), square = dot(gradient, gradient);
      const FlowForms q = flow.at(k, point);
      const FlowForm along = Eigen::RowVector3d(gradient[0], gradient[1], gradient[2]) * q;
      energy += area * ((12.0 - 2.7 * square) / (h * h * h) * q.transpose() * q +
                        1.8 / (h * h * h) * along.transpose() * along -
                        1.8 / (h * h) * (divergence.transpose() * along + along.transpose() * divergence) +
                        of_closing / h * divergence.transpose() * divergence);
      facet.slenderness += area / h;
      facet.volume += area * h;
    });
  }
  // The circulation has the value of the least energy.
  facet.resistance = energy.topLeftCorner(edges, edges) -
                     energy.col(edges).head(edges) * energy.row(edges).head(edges) / energy(edges, edges);
  return facet;
}

}  // namespace breccia::gaps
