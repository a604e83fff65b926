#include "deck/packing.hpp"

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
#include "breccia/tables/measured_table_reader.hpp"

#include "deck/filler_sections.hpp"
#include "deck/listed_particles.hpp"
#include "io/file_mistakes.hpp"
#include "study/limits.hpp"

namespace breccia {

namespace {

/// The columns with the coordinates of a position.
std::vector<const MeasuredColumn*> coordinate_columns(const MeasuredTable& table, std::size_t dimensions) {
  constexpr std::array<Quantity, 3> axes = {Quantity::x, Quantity::y, Quantity::z};
  std::vector<const MeasuredColumn*> columns;
  for (std::size_t axis = 0; axis < dimensions; ++axis) columns.push_back(&table.column(axes[axis]));
  return columns;
}

/// Throws InputError where the positions in a table for a box of two dimensions differ along z.
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

/// Whether particles stay inside the box (true) or the box is periodic (false). The tests of a periodic box that is cut
/// ("cut") take it for a window in a larger body (StageDefaults::boundaries).
Walls read_walls(const Section& packing, Walls by_default) {
  if (packing.kind("walls") == Kind::text) {
    return packing.choice<Walls>("walls", {{"cut", Walls::periodic}}).value_or(by_default);
  }
  const auto has_walls = packing.optional_boolean("walls");
  if (!has_walls) return by_default;
  return *has_walls ? Walls::hard : Walls::periodic;
}

/// A packing at random: its walls and its seed.
template <class Packing>
Packing read_random(const Section& packing, Walls by_default) {
  const auto walls = read_walls(packing, by_default);
  const auto seed = packing.optional_integer("seed", Range::not_negative()).value_or(1);
  return {walls, static_cast<std::uint64_t>(seed)};
}

template <int dim>
PackingMethod<dim> read_regular(const Section& packing);

template <>
PackingMethod<3> read_regular<3>(const Section& packing) {
  packing.refuse({"columns", "rows"}, R"(a box of three dimensions has lattice = "sc", "bcc" or "fcc", and repeats)");
  return LatticePacking{packing.choice<Lattice>("lattice").value_or(Lattice::simple),
                        static_cast<int>(packing.optional_integer("repeats", allowed::repeats).value_or(1))};
}

template <>
PackingMethod<2> read_regular<2>(const Section& packing) {
  if (packing.has("lattice") || packing.has("repeats")) {
    packing.refuse({"lattice", "repeats"},
                   "it belongs to dimensions = 3; a box of two has columns and rows, such as columns = 2, rows = 2");
    for (const auto* key : {"columns", "rows"}) {
      if (packing.has(key)) static_cast<void>(packing.integer(key, allowed::rows));
    }
    return RegularPacking{};
  }
  return RegularPacking{static_cast<int>(packing.integer("columns", allowed::rows)),
                        static_cast<int>(packing.integer("rows", allowed::rows))};
}

bool is_picture(const std::filesystem::path& file) {
  auto extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  constexpr std::array<std::string_view, 8> pictures = {".png",  ".jpg", ".jpeg", ".tif",
                                                        ".tiff", ".bmp", ".gif",  ".svg"};
  return std::ranges::find(pictures, extension) != pictures.end();
}

/// The key that names the file of the particles; `discs` is its earlier name. Empty if there is no such key.
std::string key_of_particles(const Section& packing) {
  if (packing.has("particles")) packing.refuse({"discs"}, "the particles are given already");
  if (packing.has("particles")) return "particles";
  return packing.has("discs") || !packing.has("polygons") ? "discs" : "";
}

/// The particles that a table lists: discs or ellipses, spheres or ellipsoids.
template <int dim>
ParticleList<dim> read_list(const MeasuredTable& table, double side, FileMistakes& mistakes);

template <>
ParticleList<2> read_list<2>(const MeasuredTable& table, double side, FileMistakes& mistakes) {
  if (lists_ellipses(table)) return read_ellipses(table, side, mistakes);
  return read_balls<2>(table, side, mistakes);
}

template <>
ParticleList<3> read_list<3>(const MeasuredTable& table, double side, FileMistakes& mistakes) {
  if (lists_ellipsoids(table)) return read_ellipsoids(table, side, mistakes);
  return read_balls<3>(table, side, mistakes);
}

/// Reads the file of the particles, which a key of the packing names.
template <int dim>
void read_particles(const Section& packing, const std::string& key, double side, std::size_t fillers,
                    ExplicitPacking<dim>& listed) {
  if (is_picture(listed.file)) {
    packing.report(key, fmt::format("expected a CSV file with columns {}, got {}; {}",
                                    dim == 3 ? "x_m, y_m, z_m, diameter_m" : "x_m, y_m, diameter_m",
                                    listed.file.string(), image_elsewhere));
    return;
  }
  packing.report_errors_of(key, [&] {
    const auto table = read_measured_table(listed.file);
    FileMistakes mistakes(listed.file);
    auto particles = read_list<dim>(table, side, mistakes);
    auto numbers = read_filler_numbers(table, fillers, mistakes);
    mistakes.refuse();
    listed.particles = std::move(particles);
    listed.fillers = std::move(numbers);
  });
}

/// Adds polygons to the particles of a table; discs among these become circles.
void add_polygons(ListedPolygons polygons, ExplicitPacking<2>& listed) {
  if (const auto* discs = std::get_if<std::vector<Disc>>(&listed.particles)) {
    std::vector<Particle> circles;
    for (const auto& [centre, diameter] : *discs) {
      circles.push_back({Ellipse{{diameter, diameter}}, Pose(centre, 0.0)});
    }
    listed.particles = std::move(circles);
  }
  std::ranges::move(polygons.particles, std::back_inserter(std::get<std::vector<Particle>>(listed.particles)));
  std::ranges::move(polygons.fillers, std::back_inserter(listed.fillers));
}

template <int dim>
ExplicitPacking<dim> read_explicit(const Section& packing, double side, std::size_t fillers);

template <>
ExplicitPacking<3> read_explicit<3>(const Section& packing, double side, std::size_t fillers) {
  packing.refuse({"discs", "polygons"}, "they are particles of a box of two dimensions");
  ExplicitPacking<3> listed = {.file = packing.file("particles"), .walls = read_walls(packing, Walls::hard)};
  if (!listed.file.empty()) read_particles(packing, "particles", side, fillers, listed);
  return listed;
}

template <>
ExplicitPacking<2> read_explicit<2>(const Section& packing, double side, std::size_t fillers) {
  const auto key = key_of_particles(packing);
  ExplicitPacking<2> listed = {.file = key.empty() ? "" : packing.file(key), .walls = read_walls(packing, Walls::hard)};
  const bool is_known = !is_picture(listed.file);
  if (!listed.file.empty()) read_particles(packing, key, side, fillers, listed);
  if (!is_known || !packing.has("polygons")) return listed;
  const auto polygons = packing.file("polygons");
  if (polygons.empty()) return listed;
  packing.report_errors_of("polygons", [&] { add_polygons(breccia::read_polygons(polygons, side, fillers), listed); });
  if (listed.file.empty()) listed.file = polygons;
  return listed;
}

/// The sites of a tessellation. In a table without weights all sites have the same weight; without film shares all
/// films have one thickness.
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

template <int dim>
LaguerrePacking<dim> read_laguerre(const Section& packing, double side) {
  LaguerrePacking<dim> grains;
  if (packing.kind("walls") == Kind::text) {
    grains.wall_film = packing.choice<WallFilm>("walls", {{"cut", WallFilm::none}}).value_or(WallFilm::half);
    grains.walls = Walls::hard;
  } else {
    grains.walls = read_walls(packing, Walls::periodic);
  }
  // A film that is no length has been reported; the filler still needs no fraction.
  if (packing.has("film")) grains.film = packing.quantity("film", Dimension::length, Range::positive());
  if (packing.has("sites")) {
    packing.refuse({"seed"}, "the grains follow from packing.sites");
    grains.file = packing.file("sites");
    if (grains.file.empty()) {
      grains.file = "missing";  // the missing file has been reported; the filler still needs no sizes
      return grains;
    }
    packing.report_errors_of("sites", [&] {
      auto read = read_sites<dim>(grains.file, side, grains.walls);
      grains.sites = std::move(read.sites);
      grains.film_shares = std::move(read.film_shares);
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

/// The word for the random packing that suits the shapes of a stage's fillers.
constexpr std::string_view any_random = "random";

/// Reads the method of a stage's packing.
std::optional<PackingName> read_name(const Section& stage, const Section& packing) {
  const bool has_shapes =
      std::ranges::any_of(filler_sections(stage), [](const Section& one) { return one.has("shape"); });
  std::vector<Choice<PackingName>> choices(words<PackingName>.begin(), words<PackingName>.end());
  choices.emplace_back(any_random, has_shapes ? PackingName::random_sequential : PackingName::lubachevsky_stillinger);
  return packing.choice<PackingName>("method", choices);
}

}  // namespace

bool has_method(const Section& packing, PackingName name) {
  return packing.kind("method") == Kind::text && packing.optional_text("method") == name_of(name);
}

bool takes_seed(const Section& packing) {
  const bool is_any_random = packing.kind("method") == Kind::text && packing.optional_text("method") == any_random;
  return is_any_random || has_method(packing, PackingName::lubachevsky_stillinger) ||
         has_method(packing, PackingName::random_sequential) ||
         (has_method(packing, PackingName::laguerre) && !packing.has("sites"));
}

namespace {

template <int dim>
std::optional<PackingMethod<dim>> read_method(const Section& packing, const Stage& stage, std::size_t fillers,
                                              Walls walls, PackingName name) {
  switch (name) {
    case PackingName::lubachevsky_stillinger:
      return read_random<LubachevskyStillingerPacking<dim>>(packing, walls);
    case PackingName::random_sequential:
      return read_random<RandomSequentialPacking<dim>>(packing, walls);
    case PackingName::regular:
      return read_regular<dim>(packing);
    case PackingName::listed:
      return read_explicit<dim>(packing, stage.side, fillers);
    case PackingName::laguerre:
      return read_laguerre<dim>(packing, stage.side);
    case PackingName::image:
      break;  // read_image() reads it
  }
  return std::nullopt;
}

}  // namespace

std::optional<StagePacking> read_packing(const Section& section, const Stage& stage, std::size_t fillers, Walls walls) {
  const auto packing = section.section("packing");
  if (stage.dimensions() == 2 && asks_for_other_shapes(packing)) {
    packing.report("method", shapes_elsewhere);
    packing.accept_all_keys();
    return std::nullopt;
  }
  packing.refuse({"image"}, image_elsewhere);
  const auto name = read_name(section, packing);
  if (!name) {
    packing.accept_all_keys();
    return std::nullopt;
  }
  if (stage.dimensions() == 3) return read_method<3>(packing, stage, fillers, walls, *name);
  return read_method<2>(packing, stage, fillers, walls, *name);
}

}  // namespace breccia
