#include "discretisation/gaps/plane/channel.hpp"

#include <algorithm>
#include <array>

#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Half of Gauss' rule with 16 points on [-1, 1]; the other half is its mirror image.
struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 8> gauss_rule = {{{0.0950125098376374, 0.1894506104550685},
                                                   {0.2816035507792589, 0.1826034150449236},
                                                   {0.4580167776572274, 0.1691565193950025},
                                                   {0.6178762444026438, 0.1495959888165767},
                                                   {0.7554044083550030, 0.1246289712555339},
                                                   {0.8656312023878318, 0.0951585116824928},
                                                   {0.9445750230732326, 0.0622535239386479},
                                                   {0.9894009349916499, 0.0271524594117541}}};

}  // namespace

Channel make_channel(const ParticleImages<2>& images, ImageIndex first, ImageIndex second, const Vector<2>& begin,
                     const Vector<2>& end) {
  constexpr double least = 1e-9;
  const auto path = end - begin;
  const double length = norm(path);
  Channel channel = {.resistance = Eigen::Matrix3d::Zero(), .slenderness = 0.0, .area = 0.0};
  if (length < least) return channel;
  const auto along = path / length;
  const auto middle = 0.5 * (begin + end);
  // A second particle on the right that turns counter-clockwise closes the channel before the middle and opens it
  // behind.
  const bool first_is_left = cross(along, images.across(first, second, middle)) < 0.0;
  const double turning = first_is_left ? 1.0 : -1.0;
  for (const double side : {-1.0, 1.0}) {
    for (const auto& [place, weight] : gauss_rule) {
      const double z = 0.5 * (1.0 + side * place), ds = 0.5 * weight * length;
      const auto point = begin + z * path;
      const double h = std::max(images.distance(first, point) + images.distance(second, point), least);
      const auto of_first = images.normal(first, point), of_second = images.normal(second, point);
      const double wedge = 0.5 * (1.0 + dot(of_first, of_second)), dh = dot(of_first + of_second, along);
      const double s = z * length;
      const Eigen::Vector3d q(1.0 - z, z, turning * 0.5 * s * (length - s));
      const Eigen::Vector3d dq(-1.0 / length, 1.0 / length, turning * (0.5 * length - s));
      const Eigen::Matrix3d q_dq = q * dq.transpose();
      channel.resistance += ds * (12.0 * (1.0 - 0.3 * wedge) / (h * h * h) * q * q.transpose() -
                                  1.2 * dh / (h * h) * (q_dq + q_dq.transpose()) + 1.4 / h * dq * dq.transpose());
      channel.slenderness += ds / h;
      channel.area += ds * h;
    }
  }
  return channel;
}

}  // namespace breccia::gaps
