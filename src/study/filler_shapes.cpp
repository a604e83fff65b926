#include "study/filler_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/units.hpp"
#include "study/limits.hpp"

namespace breccia {
namespace {

struct ShapeOf {
  double diameter;

  Shape operator()(const EllipticOutline& outline) const {
    const double ratio = std::sqrt(outline.aspect);
    return Ellipse{{diameter * ratio, diameter / ratio}};
  }
  Shape operator()(const PolygonalOutline& outline) const {
    const ConvexPolygon polygon(outline.corners);
    return polygon.scaled(diameter / equivalent_diameter(polygon));
  }
};

/// Long polygons pack as badly as long ellipses. The ratio is the aspect where the outline is an ellipse.
std::vector<std::string> mistakes_of_length(const std::vector<Vector<2>>& corners) {
  const ConvexPolygon polygon(corners);
  const double ratio = std::numbers::pi * circumradius(polygon) * circumradius(polygon) / area(polygon);
  if (ratio <= allowed::aspect.upper) return {};
  return {
      fmt::format("the disc around the polygon has {:.3g} times its area, expected at most {:g}; are its x and y in "
                  "one unit?",
                  ratio, allowed::aspect.upper)};
}

struct MistakesOf {
  std::vector<std::string> operator()(const EllipticOutline& outline) const {
    if (accepts(allowed::aspect, outline.aspect)) return {};
    return {fmt::format("expected an aspect from {} to {}, got {:g}", allowed::aspect.lower, allowed::aspect.upper,
                        outline.aspect)};
  }
  std::vector<std::string> operator()(const PolygonalOutline& outline) const {
    std::vector<std::string> mistakes;
    for (const auto& [corner, text] : corner_mistakes(outline.corners)) {
      mistakes.push_back(fmt::format("corner {} of the polygon: {}", corner + 1, text));
    }
    if (mistakes.empty()) mistakes = mistakes_of_length(outline.corners);
    return mistakes;
  }
};

struct InWords {
  int dimensions;

  std::string operator()(const EllipticOutline& outline) const {
    return fmt::format("{} of aspect {:g}", dimensions == 3 ? "ellipsoids of revolution" : "ellipses", outline.aspect);
  }
  std::string operator()(const PolygonalOutline& outline) const {
    return fmt::format("polygons of {} corners", outline.corners.size());
  }
};

}  // namespace

Shape shape_of(const Filler& filler, double diameter) {
  return filler.shape ? std::visit(ShapeOf{diameter}, filler.shape->outline) : Ellipse{{diameter, diameter}};
}

Vector<3> axes_of(const Filler& filler, double diameter) {
  if (!filler.shape) return {diameter, diameter, diameter};
  const auto* outline = std::get_if<EllipticOutline>(&filler.shape->outline);
  if (outline == nullptr) throw InputError("three dimensions: expected ellipsoids");
  const double ratio = std::cbrt(outline->aspect);
  return {diameter * ratio * ratio, diameter / ratio, diameter / ratio};
}

std::vector<std::string> mistakes_of_shape(const FillerShape& shape) {
  auto mistakes = std::visit(MistakesOf(), shape.outline);
  if (!std::isfinite(shape.angle.value_or(0.0))) mistakes.emplace_back("expected a finite angle");
  return mistakes;
}

std::string in_words(const FillerShape& shape, int dimensions) {
  const auto angle = shape.angle ? fmt::format(", all at {}", readable(*shape.angle, Dimension::angle)) : "";
  return std::visit(InWords{dimensions}, shape.outline) + angle;
}

std::vector<double> coatings_of(const Stage& stage, const std::vector<std::size_t>& fillers, std::size_t particles) {
  const auto is_coated = [](const Filler& filler) { return filler.coating.has_value(); };
  if (std::ranges::none_of(stage.fillers, is_coated)) return {};
  std::vector<double> coatings;
  for (std::size_t particle = 0; particle < particles; ++particle) {
    const auto& filler = stage.fillers.at(fillers.empty() ? 0 : fillers.at(particle));
    // A thickness that is not positive is a mistake of the coating, which is reported as such.
    coatings.push_back(std::max(0.0, filler.coating_thickness()));
  }
  return coatings;
}

}  // namespace breccia
