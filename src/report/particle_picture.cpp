#include "report/particle_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "report/picture_frame.hpp"

namespace breccia {
namespace {

/// Whether any part of a particle with a coating may lie inside the box [0, side]^2.
bool may_show(const Shape& shape, const Pose& pose, double coating, double side) {
  const auto reach = extent(shape, pose);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = pose.centre()[axis];
    if (x + reach[axis][1] + coating <= 0.0 || x - reach[axis][0] - coating >= side) return false;
  }
  return true;
}

/// The beginning of the element of a shape, up to its attributes.
struct Element {
  const Pose& pose;
  double scale;

  std::string operator()(const Ellipse& ellipse) const {
    const double x = pose.centre()[0] * scale, y = drawn_side - pose.centre()[1] * scale;
    const double turn = -pose.angle() * 180.0 / std::numbers::pi;  // the y axis of SVG points downwards
    return fmt::format(
        "<ellipse cx=\"{0:.6g}\" cy=\"{1:.6g}\" rx=\"{2:.5g}\" ry=\"{3:.5g}\" transform=\"rotate({4:.5g} "
        "{0:.6g} {1:.6g})\"",
        x, y, 0.5 * ellipse.axes[0] * scale, 0.5 * ellipse.axes[1] * scale, turn);
  }
  std::string operator()(const ConvexPolygon& polygon) const {
    std::string text = "<polygon points=\"";
    for (const auto& corner : polygon.corners()) {
      const auto seen = pose.from_shape(corner);
      fmt::format_to(std::back_inserter(text), "{:.6g},{:.6g} ", (pose.centre()[0] + seen[0]) * scale,
                     drawn_side - (pose.centre()[1] + seen[1]) * scale);
    }
    return text + "\"";
  }
};

/// A particle above its coating. The coating is the outline of the particle, drawn with a broad pen.
std::string drawn(const Shape& shape, const Pose& pose, const DrawnFiller& filler, double scale) {
  const auto element = std::visit(Element{pose, scale}, shape);
  std::string text;
  if (filler.coating_thickness > 0.0) {
    text = fmt::format("{0} fill=\"{1}\" stroke=\"{1}\" stroke-width=\"{2:.4g}\" stroke-linejoin=\"round\"/>\n",
                       element, colour_of_phase(filler.coating_colour), 2.0 * filler.coating_thickness * scale);
  }
  text += element;
  if (filler.colour != 1) text += fmt::format(" fill=\"{}\"", colour_of_phase(filler.colour));
  return text + "/>\n";
}

}  // namespace

std::string particle_picture(const ParticleBox& box, const std::vector<DrawnFiller>& fillers) {
  const auto is_unknown = [&](std::size_t filler) { return filler >= fillers.size(); };
  const bool needs_one = box.fillers.empty() && !box.particles.empty();
  if ((needs_one && fillers.empty()) || std::ranges::any_of(box.fillers, is_unknown)) {
    throw InputError("picture of a microstructure: a particle belongs to no filler");
  }
  const double scale = picture_scale(box.side);
  std::string shapes;
  for_each_image(box, [&](std::size_t particle, const Pose& pose) {
    const auto& shape = box.particles[particle].shape;
    const auto& filler = fillers[box.filler_of(particle)];
    if (may_show(shape, pose, filler.coating_thickness, box.side)) shapes += drawn(shape, pose, filler, scale);
  });
  constexpr auto style = R"(fill="#5b7f95" stroke="#2f4858" stroke-width="1")";
  return framed_picture(box.side, fmt::format("{} particles", box.particles.size()), style, shapes);
}

}  // namespace breccia
