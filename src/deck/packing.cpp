#include "packing.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/file_mistakes.hpp"
#include "breccia/microstructure/particle_validity.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/study/coatings.hpp"
#include "breccia/study/filler_shapes.hpp"
#include "breccia/study/limits.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "listed_particles.hpp"

namespace breccia {

namespace {

constexpr std::string_view random_method = "lubachevsky-stillinger", sequential_method = "random-sequential",
                           grain_method = "laguerre", image_method = "image";

enum class MethodName { lubachevsky_stillinger, regular, listed, laguerre, image, sequential };

/// The columns with the coordinates of a place.
std::vector<const MeasuredColumn*> coordinate_columns(const MeasuredTable& table, std::size_t dimensions) {
  constexpr std::array<Quantity, 3> axes = {Quantity::x, Quantity::y, Quantity::z};
  std::vector<const MeasuredColumn*> columns;
  for (std::size_t axis = 0; axis < dimensions; ++axis) columns.push_back(&table.column(axes[axis]));
  return columns;
}

/// Throws InputError where the places of a table for a box of two dimensions differ along z.
void refuse_space(const MeasuredTable& table) {
  if (!table.has({Quantity::z})) return;
  const auto& heights = table.column(Quantity::z).values;
  if (std::ranges::adjacent_find(heights, std::ranges::not_equal_to{}) == heights.end()) return;
  throw InputError(
      fmt::format("{}: its places differ along z, so they belong to dimensions = 3; a box of two has x and "
                  "y alone",
                  table.path().string()));
}

template <int dim>
std::vector<Ball<dim>> read_balls(const MeasuredTable& table, double side, FileMistakes& mistakes) {
  if constexpr (dim == 3) table.require({Quantity::x, Quantity::y, Quantity::z, Quantity::diameter});
  table.require({Quantity::x, Quantity::y, Quantity::diameter});
  if constexpr (dim == 2) refuse_space(table);
  const auto columns = coordinate_columns(table, dim);
  const auto& diameters = table.column(Quantity::diameter);
  // An unknown side is not a number here, and every centre is accepted.
  const auto is_outside = [side](double coordinate) { return coordinate < 0.0 || coordinate > side; };
  std::vector<Ball<dim>> balls;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Vector<dim> centre{};
    std::vector<double> written;
    for (std::size_t axis = 0; axis < centre.size(); ++axis) {
      centre[axis] = columns[axis]->values[row];
      written.push_back(columns[axis]->written[row]);
    }
    if (!(diameters.values[row] > 0.0) || !std::isfinite(diameters.values[row])) {
      mistakes.add(table.location(row), "expected a positive diameter", fmt::format("{}", diameters.written[row]));
    } else if (std::ranges::any_of(centre, is_outside)) {
      mistakes.add(table.location(row),
                   fmt::format("expected a centre in the box, 0 to {}", readable(side, Dimension::length)),
                   fmt::format("({})", fmt::join(written, ", ")));
    }
    balls.push_back({centre, diameters.values[row]});
  }
  if (balls.empty()) mistakes.add("", fmt::format("expected at least one {}", dim == 2 ? "disc" : "sphere"));
  return balls;
}

Walls read_walls(const Section& packing, bool by_default = true) {
  return packing.optional_boolean("walls").value_or(by_default) ? Walls::hard : Walls::periodic;
}

/// A packing at random: its walls and its seed.
template <class Packing>
Packing read_random(const Section& packing) {
  const auto walls = read_walls(packing);
  const auto seed = packing.optional_integer("seed", Range::not_negative()).value_or(1);
  return {walls, static_cast<std::uint64_t>(seed)};
}

LatticePacking read_lattice(const Section& packing) {
  packing.refuse({"columns", "rows"}, R"(a box of three dimensions has lattice = "sc", "bcc" or "fcc", and repeats)");
  return {packing.choice<Lattice>("lattice").value_or(Lattice::simple),
          static_cast<int>(packing.optional_integer("repeats", allowed::repeats).value_or(1))};
}

RegularPacking read_regular(const Section& packing) {
  if (packing.has("lattice") || packing.has("repeats")) {
    packing.refuse({"lattice", "repeats"},
                   "it belongs to dimensions = 3; a box of two has columns and rows, such as columns = 2, rows = 2");
    for (const auto* key : {"columns", "rows"}) {
      if (packing.has(key)) static_cast<void>(packing.integer(key, allowed::rows));
    }
    return {};
  }
  return {static_cast<int>(packing.integer("columns", allowed::rows)),
          static_cast<int>(packing.integer("rows", allowed::rows))};
}

bool is_picture(const std::filesystem::path& file) {
  auto extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  constexpr std::array<std::string_view, 8> pictures = {".png",  ".jpg", ".jpeg", ".tif",
                                                        ".tiff", ".bmp", ".gif",  ".svg"};
  return std::ranges::find(pictures, extension) != pictures.end();
}

/// The key that names the file of the particles: `discs` is its earlier name. Empty without one.
std::string key_of_particles(const Section& packing) {
  if (packing.has("particles")) packing.refuse({"discs"}, "the particles are given already");
  if (packing.has("particles")) return "particles";
  return packing.has("discs") || !packing.has("polygons") ? "discs" : "";
}

/// Reads discs or ellipses.
void read_particle_table(const std::filesystem::path& file, double side, std::size_t fillers, ExplicitPacking& listed) {
  const auto table = read_measured_table(file);
  FileMistakes mistakes(file);
  if (lists_ellipses(table)) {
    listed.particles = read_ellipses(table, side, mistakes);
  } else {
    listed.discs = read_balls<2>(table, side, mistakes);
  }
  listed.fillers = read_filler_numbers(table, fillers, mistakes);
  mistakes.refuse();
}

/// Adds polygons to what a table of particles has listed; discs among them become circles.
void add_polygons(ListedPolygons polygons, ExplicitPacking& listed) {
  for (const auto& [centre, diameter] : listed.discs) {
    listed.particles.push_back({Ellipse{{diameter, diameter}}, Pose(centre, 0.0)});
  }
  listed.discs.clear();
  std::ranges::move(polygons.particles, std::back_inserter(listed.particles));
  std::ranges::move(polygons.fillers, std::back_inserter(listed.fillers));
}

/// Reads the spheres or ellipsoids of a box of three dimensions.
ExplicitPacking read_explicit_in_space(const Section& packing, double side, std::size_t fillers) {
  packing.refuse({"discs", "polygons"}, "they are particles of a box of two dimensions");
  ExplicitPacking listed{packing.file("particles"), {}, read_walls(packing), {}};
  if (listed.file.empty()) return listed;
  if (is_picture(listed.file)) {
    packing.report("particles", fmt::format("expected a CSV file with columns x_m, y_m, z_m, diameter_m, got {}; {}",
                                            listed.file.string(), image_elsewhere));
    return listed;
  }
  packing.report_errors_of("particles", [&] {
    const auto table = read_measured_table(listed.file);
    FileMistakes mistakes(listed.file);
    auto read = listed;
    if (lists_ellipsoids(table)) {
      read.ellipsoids = read_ellipsoids(table, side, mistakes);
    } else {
      read.spheres = read_balls<3>(table, side, mistakes);
    }
    read.fillers = read_filler_numbers(table, fillers, mistakes);
    mistakes.refuse();
    listed = std::move(read);
  });
  return listed;
}

ExplicitPacking read_explicit(const Section& packing, double side, std::size_t fillers) {
  const auto key = key_of_particles(packing);
  ExplicitPacking listed{key.empty() ? "" : packing.file(key), {}, read_walls(packing), {}};
  if (is_picture(listed.file)) {
    packing.report(key, fmt::format("expected a CSV file with columns x_m, y_m, diameter_m, got {}; {}",
                                    listed.file.string(), image_elsewhere));
    return listed;
  }
  if (!listed.file.empty()) {
    packing.report_errors_of(key, [&] {
      auto read = listed;
      read_particle_table(listed.file, side, fillers, read);
      listed = std::move(read);
    });
  }
  if (!packing.has("polygons")) return listed;
  const auto polygons = packing.file("polygons");
  if (polygons.empty()) return listed;
  packing.report_errors_of("polygons", [&] { add_polygons(read_polygons(polygons, side, fillers), listed); });
  if (listed.file.empty()) listed.file = polygons;
  return listed;
}

/// The sites of a tessellation. Those in a table without weights all weigh the same, and without shares of the films
/// these are of one thickness.
template <int dim>
LaguerreSites<dim> read_sites(const std::filesystem::path& file, double side, Walls walls) {
  const auto table = read_measured_table(file);
  table.require({Quantity::x, Quantity::y});
  if constexpr (dim == 3) {
    table.require({Quantity::x, Quantity::y, Quantity::z});
  } else {
    refuse_space(table);
  }
  table.refuse_unknown_units({Quantity::weight, Quantity::film_share});
  const auto columns = coordinate_columns(table, dim);
  const auto* weights = table.has({Quantity::weight}) ? &table.column(Quantity::weight) : nullptr;
  LaguerreSites<dim> read = {.side = side, .walls = walls, .sites = std::vector<Site<dim>>(table.rows())};
  auto& sites = read.sites;
  if (table.has({Quantity::film_share})) read.film_shares = table.column(Quantity::film_share).values;
  for (std::size_t row = 0; row < sites.size(); ++row) {
    auto& [position, weight] = sites[row];
    for (std::size_t axis = 0; axis < position.size(); ++axis) position[axis] = columns[axis]->values[row];
    weight = weights == nullptr ? 0.0 : weights->values[row];
  }
  FileMistakes mistakes(file);
  if (sites.empty()) mistakes.add("", "expected at least one site");
  // The side of the box may be unknown because of a mistake elsewhere.
  if (!sites.empty() && side > 0.0) {
    for (const auto& [site, text] : breccia::mistakes(read)) mistakes.add(table.location(site), text);
  }
  mistakes.refuse();
  return read;
}

LaguerrePacking read_laguerre(const Section& packing, const Stage& stage) {
  LaguerrePacking grains;
  if (packing.kind("walls") == Kind::text) {
    grains.wall_film = packing.choice<WallFilm>("walls", {{"cut", WallFilm::none}}).value_or(WallFilm::half);
    grains.walls = Walls::hard;
  } else {
    grains.walls = read_walls(packing, false);
  }
  // A film that is no length has been reported; the filler still needs no fraction.
  if (packing.has("film")) grains.film = packing.quantity("film", Dimension::length, Range::positive());
  if (packing.has("sites")) {
    packing.refuse({"seed"}, "the grains follow from packing.sites");
    grains.file = packing.file("sites");
    if (grains.file.empty()) {
      grains.file = "missing";  // which has been reported; the filler still needs no sizes
      return grains;
    }
    packing.report_errors_of("sites", [&] {
      const auto take = [&](auto read, auto& sites) {
        sites = std::move(read.sites);
        grains.film_shares = std::move(read.film_shares);
      };
      if (stage.dimensions == 3) {
        take(read_sites<3>(grains.file, stage.side, grains.walls), grains.sites_in_space);
      } else {
        take(read_sites<2>(grains.file, stage.side, grains.walls), grains.sites);
      }
    });
  } else {
    grains.seed = static_cast<std::uint64_t>(packing.optional_integer("seed", Range::not_negative()).value_or(1));
  }
  return grains;
}

/// A packing method that does not exist, but that users may expect.
bool asks_for_other_shapes(const Section& packing) {
  if (packing.kind("method") != Kind::text) return false;
  constexpr std::array<std::string_view, 2> methods = {"polygons", "ellipses"};
  return std::ranges::find(methods, packing.optional_text("method").value_or("")) != methods.end();
}

}  // namespace

bool takes_seed(const Section& packing) {
  if (packing.kind("method") != Kind::text) return false;
  const auto method = packing.optional_text("method");
  return method == random_method || method == sequential_method || (method == grain_method && !packing.has("sites"));
}

void require_room(const Stage& stage, const ExplicitPacking& listed) {
  const bool is_empty = listed.discs.empty() && listed.particles.empty();
  if (is_empty && listed.spheres.empty() && listed.ellipsoids.empty()) return;  // which has been reported
  try {
    if (!listed.ellipsoids.empty()) {
      require_valid(ellipsoid_box(stage, listed));
      return;
    }
    if (!listed.particles.empty()) {
      require_valid(particle_box(stage, listed));
    } else if (stage.dimensions == 3) {
      require_valid(with_coatings<3>(stage, {stage.side, listed.walls, listed.spheres, listed.fillers}));
    } else {
      require_valid<2>(with_coatings<2>(stage, {stage.side, listed.walls, listed.discs, listed.fillers}));
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", listed.file.string(), error.what()));
  }
}

namespace {

/// The packings whose keys are the same in two and three dimensions.
std::optional<PackingMethod> read_in_any_box(const Section& packing, const Stage& stage, MethodName method) {
  switch (method) {
    case MethodName::laguerre:
      return read_laguerre(packing, stage);
    case MethodName::image:
      return std::nullopt;  // read_image() reads it
    case MethodName::sequential:
      return read_random<RandomSequentialPacking>(packing);
    default:
      return read_random<LubachevskyStillingerPacking>(packing);
  }
}

/// The packings of a box of three dimensions.
std::optional<PackingMethod> read_packing_in_space(const Section& packing, const Stage& stage, std::size_t fillers) {
  const auto method = packing.choice<MethodName>("method", {{random_method, MethodName::lubachevsky_stillinger},
                                                            {"regular", MethodName::regular},
                                                            {"explicit", MethodName::listed},
                                                            {grain_method, MethodName::laguerre},
                                                            {image_method, MethodName::image},
                                                            {sequential_method, MethodName::sequential}});
  packing.refuse({"image"}, image_elsewhere);
  if (!method) {
    packing.accept_all_keys();
    return std::nullopt;
  }
  switch (*method) {
    case MethodName::regular:
      return read_lattice(packing);
    case MethodName::listed:
      return read_explicit_in_space(packing, stage.side, fillers);
    default:
      return read_in_any_box(packing, stage, *method);
  }
}

}  // namespace

std::optional<PackingMethod> read_packing(const Section& section, const Stage& stage, std::size_t fillers) {
  const auto packing = section.section("packing");
  if (stage.dimensions == 3) return read_packing_in_space(packing, stage, fillers);
  if (asks_for_other_shapes(packing)) {
    packing.report("method", shapes_elsewhere);
    packing.accept_all_keys();
    return std::nullopt;
  }
  packing.refuse({"image"}, image_elsewhere);
  const auto method = packing.choice<MethodName>("method", {
                                                               {random_method, MethodName::lubachevsky_stillinger},
                                                               {"regular", MethodName::regular},
                                                               {"explicit", MethodName::listed},
                                                               {grain_method, MethodName::laguerre},
                                                               {image_method, MethodName::image},
                                                               {sequential_method, MethodName::sequential},
                                                           });
  if (!method) {
    packing.accept_all_keys();
    return std::nullopt;
  }
  switch (*method) {
    case MethodName::regular:
      return read_regular(packing);
    case MethodName::listed:
      return read_explicit(packing, stage.side, fillers);
    default:
      return read_in_any_box(packing, stage, *method);
  }
}

}  // namespace breccia
