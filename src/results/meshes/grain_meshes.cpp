#include "results/meshes/grain_meshes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/films/film_problem.hpp"

#include "films/mesh/conforming_mesh.hpp"
#include "io/range.hpp"
#include "io/text_file.hpp"
#include "rasters/vtkhdf.hpp"
#include "results/meshes/msh_text.hpp"
#include "results/stored_geometry.hpp"
#include "study/limits.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The record of a test of grains and films; nullptr where there is none.
const QuasistaticEntry* film_test_of(const StageEntry& stage) {
  for (const auto& test : stage.tests) {
    const auto* const record = std::get_if<QuasistaticEntry>(&test.record);
    if (record != nullptr && test.id.grid.is_films()) return record;
  }
  return nullptr;
}

/// A number of the record of a test that lies in its range. Throws FileError for another one.
template <class Number>
Number recorded(const char* key, Number number, const Range& range) {
  if (accepts(range, static_cast<double>(number))) return number;
  throw FileError(fmt::format("study.json: {} of a test: expected {}", key, described(range, "number")));
}

template <int dim>
FilmElements<dim> elements_of(const StageEntry& stage, const MeshSettings& settings) {
  const auto* const test = film_test_of(stage);
  FilmElements<dim> elements;
  if constexpr (dim == 2) {
    if (test != nullptr) {
      const auto& share = test->face_share;
      elements.face_share = recorded("face_share", share.value_or(elements.face_share), allowed::face_share);
    }
    elements.face_share = settings.face_share.value_or(elements.face_share);
  } else {
    if (test != nullptr) {
      elements.divisions = recorded("divisions", test->divisions.value_or(elements.divisions), allowed::divisions);
    }
    elements.divisions = settings.divisions.value_or(elements.divisions);
  }
  return elements;
}

template <int dim>
FilmProblem<dim> problem_of(const fs::path& directory, const StageEntry& stage, const MeshSettings& settings) {
  Tessellation<dim> tessellation(read_stored_sites<dim>(directory, stage));
  const bool is_periodic = tessellation.walls() == Walls::periodic;
  return {.tessellation = std::move(tessellation),
          .thickness = *stage.microstructure.film,
          .grain = {.bulk = 1.0, .shear = 1.0},  // a mesh does not depend on them
          .boundary = is_periodic ? Boundary::periodic : Boundary::displacement,
          .elements = elements_of<dim>(stage, settings),
          .layers = layers_of(stage, settings),
          .debonded = read_debonded_films<dim>(directory, stage)};
}

template <int dim>
MeshCounts counts_of(const films::ConformingMesh<dim>& mesh) {
  MeshCounts counts{
      .nodes = mesh.nodes.size(), .elements = mesh.elements.size(), .opposite_surfaces = mesh.opposites.size()};
  for (const auto& element : mesh.elements) {
    const double content = content_of(mesh, element);
    if (!(content > 0.0)) ++counts.inverted;
    (element.grain ? counts.grains : counts.binder) += content / std::pow(mesh.side, dim);
  }
  for (const auto& surface : mesh.surfaces) {
    if (surface.beyond == films::Beyond::gap) counts.facets_of_gaps += surface.facets.size();
  }
  return counts;
}

/// Writes a mesh as VTKHDF: the phase of each element, 0 in the binder and 1 in the grains, and the number of its
/// grain, -1 in the binder.
template <int dim>
void write_vtkhdf_mesh(const fs::path& file, const films::ConformingMesh<dim>& mesh, double scale) {
  PieceMesh<dim> pieces{.points = mesh.nodes, .corners = {}, .corner_counts = {}};
  for (auto& point : pieces.points) {
    for (double& x : point) x *= scale;
  }
  std::vector<std::uint8_t> phases;
  std::vector<float> grains;
  for (const auto& element : mesh.elements) {
    for (const auto node : element.nodes) pieces.corners.push_back(static_cast<std::int64_t>(node));
    pieces.corner_counts.push_back(std::ssize(element.nodes));
    phases.push_back(element.grain ? 1 : 0);
    grains.push_back(element.grain ? static_cast<float>(*element.grain) : -1.0F);
  }
  write_vtkhdf(file, pieces, {{"phase", 1, std::move(phases)}, {"grain", 1, std::move(grains)}}, {}, {});
}

/// The names of the materials, or of the phases where both are of one material.
MeshMaterials materials_of(const StageEntry& stage) {
  const auto& grains = stage.fillers.front().material;
  return grains == stage.matrix ? MeshMaterials{"filler", "matrix"} : MeshMaterials{grains, stage.matrix};
}

template <int dim>
MeshCounts write(const fs::path& file, const fs::path& directory, const StageEntry& stage,
                 const MeshSettings& settings) {
  const auto mesh = films::conforming_mesh(problem_of<dim>(directory, stage, settings));
  const double scale = units_per_metre(settings.unit);
  if (settings.format == MeshFormat::msh) {
    write_text(file, msh_text(mesh, materials_of(stage), scale));
  } else {
    write_vtkhdf_mesh(file, mesh, scale);
  }
  return counts_of(mesh);
}

}  // namespace

std::optional<int> layers_of(const StageEntry& stage, const MeshSettings& settings) {
  const auto* const test = film_test_of(stage);
  if (settings.layers || test == nullptr || !test->layers) return settings.layers;
  return recorded("layers", *test->layers, allowed::layers);
}

void require_mesh(const StageEntry& stage, const MeshSettings& settings) {
  const auto format = name_of(settings.format);
  if (!stage.microstructure.film || stage.fillers.empty()) {
    throw InputError(fmt::format(
        "{0}: stage {1} has no grains that fill its box (packing.method = \"laguerre\"), and its cells are a grid that "
        "does not follow the interfaces; {1}/labels.npy and {1}/labels.vti have the phases of its points{2}",
        format, stage.name,
        stage.dimensions == 3 && !stage.microstructure.pixels && !stage.fillers.empty()
            ? ", and stl has the surfaces of its particles"
            : ""));
  }
  const auto sides = stage.microstructure.sides;
  if (sides == BoxSides::hard || (sides == BoxSides::cut && stage.dimensions == 3)) {
    throw InputError(
        fmt::format("{}: the box of stage {} has walls; expected a periodic box{}", format, stage.name,
                    stage.dimensions == 2 ? ", or walls that cut the grains (packing.walls = \"cut\")" : ""));
  }
}

MeshCounts write_mesh(const fs::path& file, const fs::path& directory, const StageEntry& stage,
                      const MeshSettings& settings) {
  require_mesh(stage, settings);
  return stage.dimensions == 3 ? write<3>(file, directory, stage, settings)
                               : write<2>(file, directory, stage, settings);
}

}  // namespace breccia
