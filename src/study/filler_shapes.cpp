#include "breccia/study/filler_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "breccia/io/units.hpp"

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

struct MistakesOf {
  std::vector<std::string> operator()(const EllipticOutline& outline) const {
    if (outline.aspect > 0.0 && std::isfinite(outline.aspect)) return {};
    return {fmt::format("expected an aspect above 0, got {:g}", outline.aspect)};
  }
  std::vector<std::string> operator()(const PolygonalOutline& outline) const {
    std::vector<std::string> mistakes;
    for (const auto& [corner, text] : corner_mistakes(outline.corners)) {
      mistakes.push_back(fmt::format("corner {} of the polygon: {}", corner + 1, text));
    }
    return mistakes;
  }
};

struct InWords {
  std::string operator()(const EllipticOutline& outline) const {
    return fmt::format("ellipses of aspect {:g}", outline.aspect);
  }
  std::string operator()(const PolygonalOutline& outline) const {
    return fmt::format("polygons of {} corners", outline.corners.size());
  }
};

}  // namespace

Shape shape_of(const Filler& filler, double diameter) {
  return filler.shape ? std::visit(ShapeOf{diameter}, filler.shape->outline) : Ellipse{{diameter, diameter}};
}

std::vector<std::string> mistakes_of_shape(const FillerShape& shape) {
  auto mistakes = std::visit(MistakesOf(), shape.outline);
  if (!std::isfinite(shape.angle.value_or(0.0))) mistakes.emplace_back("expected a finite angle");
  return mistakes;
}

std::string in_words(const FillerShape& shape) {
  const auto angle = shape.angle ? fmt::format(", all at {}", readable(*shape.angle, Dimension::angle)) : "";
  return std::visit(InWords(), shape.outline) + angle;
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

ParticleBox particle_box(const Stage& stage, const ExplicitPacking& listed) {
  return {stage.side, listed.walls, listed.particles, listed.fillers,
          coatings_of(stage, listed.fillers, listed.particles.size())};
}

}  // namespace breccia
