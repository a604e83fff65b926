#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "cli/command.hpp"
#include "cli/output_file.hpp"
#include "io/collected_mistakes.hpp"
#include "io/display.hpp"
#include "results/meshes/closed_surface.hpp"
#include "results/meshes/grain_meshes.hpp"
#include "results/meshes/particle_surfaces.hpp"
#include "results/stored_geometry.hpp"
#include "study/limits.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

/// The name of the format of surfaces; the others are MeshFormat.
constexpr std::string_view surface_format = "stl";

struct MeshArguments {
  fs::path results;
  std::string format;
  std::string stage;  ///< name of the stage; empty: the last one
  std::string resolution = "10 %";
  std::string material;  ///< material of the particles; empty: all
  std::optional<int> layers;
  std::optional<int> divisions;
  std::optional<double> face_share;
  std::string units = "m";
  fs::path output;
  bool overwrite = false;
  std::vector<std::string> of_other_formats;  ///< options that were given, but that the format does not have
};

std::vector<std::string> formats() {
  std::vector<std::string> names = {std::string(surface_format)};
  for (const auto& [word, value] : words<MeshFormat>) names.emplace_back(word);
  return names;
}

std::vector<std::string> units() {
  std::vector<std::string> names;
  for (const auto& [word, value] : words<LengthUnit>) names.emplace_back(word);
  return names;
}

/// The study in a directory of results, whose stages need not be tested.
StudyDocument read_packed_study(const fs::path& directory) {
  const auto name = directory.string();
  if (!fs::is_directory(directory)) throw InputError(fmt::format("{}: no such directory", name));
  if (fs::exists(directory / "sweep.json")) {
    throw InputError(fmt::format("{}: the results of a sweep; name the directory of one of its tasks", name));
  }
  if (!fs::exists(directory / "study.json")) {
    throw InputError(fmt::format("{}: no study.json, which `breccia run` and `breccia pack` write", name));
  }
  return read_study_document(directory);
}

SurfaceSettings read_surface_settings(const MeshArguments& arguments) {
  SurfaceSettings settings{.material = arguments.material, .unit = *value_named<LengthUnit>(arguments.units)};
  settings.longest_edge = option_share("--resolution", arguments.resolution).value_or(settings.longest_edge);
  if (settings.longest_edge >= shortest_longest_edge && settings.longest_edge <= 1.0) return settings;
  throw InputError(fmt::format("--resolution: expected a share from {:g} % to 100 %, got \"{}\"",
                               100.0 * shortest_longest_edge, arguments.resolution));
}

MeshSettings mesh_settings(const MeshArguments& arguments) {
  return {.format = *value_named<MeshFormat>(arguments.format),
          .unit = *value_named<LengthUnit>(arguments.units),
          .layers = arguments.layers,
          .divisions = arguments.divisions,
          .face_share = arguments.face_share};
}

/// Collects the mistakes in the sizes of the elements.
void check_elements(const StageEntry& stage, const MeshSettings& settings, CollectedMistakes& mistakes) {
  mistakes.collect([&] {
    if (layers_of(stage, settings)) return;
    throw InputError(
        fmt::format("--layers: the results have no elements of binder between the grains of stage {}, whose films are "
                    "thin or not tested; expected a number of layers of elements across every film, such as "
                    "--layers 2",
                    stage.name));
  });
  mistakes.collect([&] {
    if (stage.dimensions == 3 || !settings.divisions) return;
    throw InputError(fmt::format("--divisions: stage {} is in the plane; expected --face-share", stage.name));
  });
  mistakes.collect([&] {
    if (stage.dimensions == 2 || !settings.face_share) return;
    throw InputError(fmt::format("--face-share: stage {} is in space; expected --divisions", stage.name));
  });
}

std::string percent(double share) {
  return fmt::format("{:.4g} %", 100.0 * share);
}

std::string in_words(const StageEntry& stage, const SurfaceCounts& counts, const std::string& units) {
  auto text = fmt::format("{}: the surfaces of {}, {}, lengths in {}\n", stage.name,
                          display_count(counts.particles, stage.microstructure.film ? "grain" : "particle"),
                          display_count(counts.triangles, "triangle"), units);
  text += fmt::format("  they enclose {} of the box, which the {} fill to {}\n", percent(counts.enclosed),
                      stage.microstructure.film ? "grains" : "particles", percent(counts.fraction));
  if (counts.across_sides > 0) {
    text += fmt::format("  {} reach beyond the sides of the periodic box, and are whole, at their place\n",
                        counts.across_sides);
  }
  return text;
}

std::string in_words(const StageEntry& stage, const MeshCounts& counts, const std::string& units) {
  auto text = fmt::format("{}: {} {} of {} nodes, lengths in {}\n", stage.name, counts.elements,
                          stage.dimensions == 3 ? "tetrahedra" : "triangles", counts.nodes, units);
  text +=
      fmt::format("  the grains fill {} of the box, the binder {}\n", percent(counts.grains), percent(counts.binder));
  if (counts.opposite_surfaces > 0) {
    text += fmt::format(
        "  the grains are whole where they reach beyond the sides of the box; {} of surfaces are "
        "periodic\n",
        display_count(counts.opposite_surfaces, "pair"));
  }
  if (counts.facets_of_gaps > 0) {
    text += "  films that are debonded are gaps, without elements\n";
  }
  return text;
}

/// Warnings of elements that do not fill the box once.
void print_warnings(const MeshCounts& counts) {
  constexpr double tolerance = 1e-6;
  if (counts.inverted > 0) {
    fmt::print(stderr, "warning: {} of no or negative content: the binder is very narrow there\n",
               display_count(counts.inverted, "element"));
  }
  const double filled = counts.grains + counts.binder;
  if (filled > 1.0 + tolerance) {
    fmt::print(stderr, "warning: the elements fill {:.6g} % of the box: parts of the binder overlap\n", 100.0 * filled);
  }
  if (counts.facets_of_gaps == 0 && filled < 1.0 - tolerance) {
    fmt::print(stderr, "warning: the elements fill {:.6g} % of the box: parts of it are missing\n", 100.0 * filled);
  }
}

void write_geometry(const MeshArguments& arguments) {
  CollectedMistakes mistakes;
  const bool has_surfaces = arguments.format == surface_format;
  SurfaceSettings surfaces;
  for (const auto& option : arguments.of_other_formats) {
    mistakes.collect([&] { throw InputError(fmt::format("{}: the format {} has none", option, arguments.format)); });
  }
  mistakes.collect([&] { surfaces = read_surface_settings(arguments); });
  mistakes.collect([&] { refuse_existing(arguments.output, arguments.overwrite); });
  StudyDocument document;
  const StageEntry* stage = nullptr;
  mistakes.collect([&] {
    document = read_packed_study(arguments.results);
    stage = &stage_named(document, arguments.stage);
    if (has_surfaces) return require_surfaces(*stage, surfaces);
    const auto settings = mesh_settings(arguments);
    require_mesh(*stage, settings);
    check_elements(*stage, settings, mistakes);
  });
  mistakes.refuse();

  const auto directory = arguments.results / stage->name;
  if (has_surfaces) {
    fmt::print("{}", in_words(*stage, write_surfaces(arguments.output, directory, *stage, surfaces), arguments.units));
  } else {
    const auto counts = write_mesh(arguments.output, directory, *stage, mesh_settings(arguments));
    fmt::print("{}", in_words(*stage, counts, arguments.units));
    print_warnings(counts);
  }
  fmt::print("The {} are in {}\n", has_surfaces ? "surfaces" : "elements", arguments.output.string());
}

}  // namespace

void add_mesh(CLI::App& application) {
  auto* command = application.add_subcommand(
      "mesh", "write the geometry of a packed box for other programs: surfaces of particles, or a conforming mesh");
  auto arguments = std::make_shared<MeshArguments>();
  command->add_option("DIR", arguments->results, "the results of `breccia run` or `breccia pack`")
      ->required()
      ->type_name("");
  command
      ->add_option("--format", arguments->format,
                   "stl: closed surfaces of particles in space; msh: a mesh of grains and binder for Gmsh; vtkhdf: the "
                   "same for ParaView")
      ->required()
      ->check(CLI::IsMember(formats()).description(""))
      ->type_name(fmt::format("{}", fmt::join(formats(), "|")));
  command->add_option("--stage", arguments->stage, "the stage (default: the last one)")->type_name("NAME");
  auto* resolution = command
                         ->add_option("--resolution", arguments->resolution,
                                      "of stl: longest edge of a triangle of a sphere, as a share of its diameter "
                                      "(default: \"10 %\")")
                         ->type_name("SHARE");
  auto* material =
      command
          ->add_option("--material", arguments->material, "of stl: the particles of this material alone (default: all)")
          ->type_name("NAME");
  auto* layers =
      command
          ->add_option("--layers", arguments->layers,
                       "of msh and vtkhdf: layers of elements across every film (default: those of the "
                       "tests)")
          ->check(CLI::Range(static_cast<int>(allowed::layers.lower), static_cast<int>(allowed::layers.upper))
                      .description(""))
          ->type_name("N");
  auto* divisions =
      command
          ->add_option("--divisions", arguments->divisions,
                       "in space: elements along each edge of a grain (default: those of the tests, or "
                       "2)")
          ->check(CLI::Range(static_cast<int>(allowed::divisions.lower), static_cast<int>(allowed::divisions.upper))
                      .description(""))
          ->type_name("N");
  auto* face_share = command
                         ->add_option("--face-share", arguments->face_share,
                                      "in the plane: longest element along a film, over the root of the area of the "
                                      "smaller grain (default: that of the tests, or 0.3)")
                         ->check(CLI::Range(allowed::face_share.lower, allowed::face_share.upper).description(""))
                         ->type_name("NUMBER");
  command->add_option("--units", arguments->units, "unit of length in the file (default: m)")
      ->check(CLI::IsMember(units()).description(""))
      ->type_name(fmt::format("{}", fmt::join(units(), "|")));
  command->add_option("--output", arguments->output, "the file")->required()->type_name("FILE");
  command->add_flag("--overwrite", arguments->overwrite, "replace that file");
  const std::vector<CLI::Option*> of_surfaces = {resolution, material}, of_meshes = {layers, divisions, face_share};
  command->callback([arguments, of_surfaces, of_meshes] {
    const auto& others = arguments->format == surface_format ? of_meshes : of_surfaces;
    for (const auto* option : others) {
      if (option->count() > 0) arguments->of_other_formats.push_back(option->get_name());
    }
    write_geometry(*arguments);
  });
}

}  // namespace breccia::cli
