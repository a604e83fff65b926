#include "deck/shapes.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/tables/measured_table_reader.hpp"

#include "io/file_mistakes.hpp"
#include "study/filler_shapes.hpp"
#include "study/limits.hpp"

namespace breccia {
namespace {

/// The reason why a packing cannot place fillers with shapes; nothing where it can.
struct ReasonAgainstShapes {
  using Reason = std::optional<std::string>;
  const char* round;  ///< name of the particles without a shape

  template <int dim>
  Reason operator()(const RandomSequentialPacking<dim>&) const {
    return std::nullopt;
  }
  Reason operator()(const RegularPacking&) const {
    return "a regular packing has discs alone; packing.method = \"random-sequential\" packs other shapes";
  }
  Reason operator()(const LatticePacking&) const { return "a lattice has balls alone"; }
  template <int dim>
  Reason operator()(const ExplicitPacking<dim>&) const {
    return "the shapes of an explicit packing are all listed in its files";
  }
  template <int dim>
  Reason operator()(const ImagePacking<dim>&) const {
    return "an image shows the shapes";
  }
  template <int dim>
  Reason operator()(const LaguerrePacking<dim>&) const {
    return "grains of a tessellation have the shapes of its cells";
  }
  template <class Packing>
  Reason operator()(const Packing&) const {
    return fmt::format(R"(the method "{}" packs {} alone; packing.method = "random-sequential" packs other shapes)",
                       name_of(Packing::name), round);
  }
};

PolygonalOutline read_polygon(const std::filesystem::path& file) {
  const auto table = read_measured_table(file);
  table.require({Quantity::x, Quantity::y});
  const auto& x = table.column(Quantity::x).values;
  const auto& y = table.column(Quantity::y).values;
  PolygonalOutline outline = {file, {}};
  for (std::size_t row = 0; row < table.rows(); ++row) outline.corners.push_back({x[row], y[row]});
  FileMistakes mistakes(file);
  for (const auto& [corner, text] : corner_mistakes(outline.corners)) {
    mistakes.add(corner < table.rows() ? table.location(corner) : "", text);
  }
  mistakes.refuse();
  for (const auto& mistake : mistakes_of_shape({outline, {}})) mistakes.add("", mistake);
  mistakes.refuse();
  return outline;
}

/// The aspect of ellipsoids; nothing for spheres, and where a mistake has been reported.
std::optional<FillerShape> read_ellipsoids_of_revolution(const Section& shape) {
  shape.refuse({"polygon"}, "particles of three dimensions are ellipsoids: { aspect = 1.5 }");
  shape.refuse({"angle"}, "ellipsoids are turned at random; packing.method = \"explicit\" takes their angles");
  const double aspect = shape.number("aspect", allowed::aspect);
  if (aspect == 1.0) return std::nullopt;
  return FillerShape{EllipticOutline{aspect}, {}};
}

/// The shape of a table that has one; nothing for discs, and where a mistake has been reported.
std::optional<FillerShape> read_outline(const Section& shape) {
  const auto key = shape.exactly_one({"aspect", "polygon"});
  const auto angle = shape.optional_quantity("angle", Dimension::angle);
  if (key == "aspect") {
    const double aspect = shape.number("aspect", allowed::aspect);
    if (aspect == 1.0) return std::nullopt;
    return FillerShape{EllipticOutline{aspect}, angle};
  }
  if (key != "polygon") return std::nullopt;
  const auto file = shape.file("polygon");
  if (file.empty()) return std::nullopt;
  std::optional<FillerShape> read;
  shape.report_errors_of("polygon", [&] { read = FillerShape{read_polygon(file), angle}; });
  return read;
}

}  // namespace

std::optional<FillerShape> read_shape(const Section& filler, const Stage& stage) {
  if (!filler.has("shape")) return std::nullopt;
  if (filler.kind("shape") != Kind::table) {
    filler.report("shape", stage.dimensions() == 3
                               ? "expected { aspect = 1.5 } for ellipsoids of revolution"
                               : "expected { aspect = 1.5 } for ellipses or { polygon = \"file.csv\" }");
    return std::nullopt;
  }
  const bool is_flat = stage.dimensions() == 2;
  const auto shape = filler.section("shape");
  auto read = is_flat ? read_outline(shape) : read_ellipsoids_of_revolution(shape);
  const auto reason = visit_nested(ReasonAgainstShapes{is_flat ? "discs" : "spheres"}, stage.packing);
  if (!read || !reason) return read;
  filler.report("shape", *reason);
  return std::nullopt;
}

}  // namespace breccia
