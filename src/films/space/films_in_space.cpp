#include "films/space/films_in_space.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "films/assembly/matrix_assembly.hpp"
#include "films/space/film_wedge.hpp"
#include "films/space/solid_elements.hpp"
#include "films/space/solid_strain.hpp"
#include "films/space/space_mesh.hpp"

namespace breccia::films {
namespace {

/// Adds up the matrices of grains, films, channels and junctions.
class SpaceAssembly {
 public:
  explicit SpaceAssembly(const SpaceMesh& mesh)
      : mesh_(mesh), sum_(mesh.unknowns(), static_cast<int>(mesh.sheets().nodes.size())) {}

  void add_grains(const FilmProblem<3>& problem) {
    const auto& solids = mesh_.grains().solids();
    for (std::size_t g = 0; g < solids.size(); ++g) {
      const auto elasticity = elasticity_of_grain(problem, g);
      for (const auto& tetrahedron : solids[g].tetrahedra) {
        std::vector<SolidNode> nodes;
        nodes.reserve(tetrahedron.size());
        for (const auto node : tetrahedron) nodes.push_back({g, node, Eigen::Vector3i::Zero()});
        const std::array corners = {position(nodes[0]), position(nodes[1]), position(nodes[2]), position(nodes[3])};
        sum_.add_grain(mesh_.unknowns_of(nodes), tetrahedron_stiffness(corners, elasticity));
        sum_.add_content_of_grain(volume_of(corners), elasticity);
      }
    }
  }

  void add_films() {
    for (std::size_t t = 0; t < mesh_.sheets().triangles.size(); ++t) {
      if (is_gap(mesh_.debonding(t))) {
        for (const int flow : mesh_.flows_of(t)) sum_.isolate(flow);
        continue;
      }
      const auto nodes = mesh_.nodes_of_film(t);
      const bool slides = mesh_.debonding(t) == Debonding::slip, is_at_rim = mesh_.sheets().triangles[t].is_at_rim;
      const auto element = slides ? sliding_film_wedge(mesh_.film(t), is_at_rim) : film_wedge(mesh_.film(t), is_at_rim);
      const auto unknowns = mesh_.unknowns_of(nodes, mesh_.flows_of(t));
      const auto pressures = pressures_of(mesh_.sheets().triangles[t].nodes);
      const auto springs = mesh_.springs(t);
      const auto all = with_jumps(unknowns, springs);
      sum_.add_grain(unknowns_of_jumps<3>(springs), springs.stiffness);
      sum_.add_shear(all, stiffness_with_jumps(element.shear, springs));
      sum_.add_dilatation(pressures, all, dilatation_with_jumps(element.dilatation, springs));
      sum_.add_volume(pressures, element.volume);
      sum_.add_content(slides ? work_in_uniform_shear(unknowns, element.shear) : element.volume.sum());
    }
  }

  /// Holds the pressures inside gaps and, with the rims, in open ones.
  void hold_pressures() {
    const auto& sheets = mesh_.sheets();
    std::vector<bool> has_pressure(sheets.nodes.size(), false);
    const auto set = [&has_pressure](std::span<const SheetNode> nodes, bool value) {
      for (const auto& node : nodes) has_pressure[node.number] = value;
    };
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t) {
      if (!is_gap(mesh_.debonding(t))) set(sheets.triangles[t].nodes, true);
    }
    for (const auto& segment : sheets.segments) set(segment.nodes, true);
    set(sheets.points, true);
    for (std::size_t t = 0; t < sheets.triangles.size(); ++t) {
      if (mesh_.debonding(t) == Debonding::open) set(sheets.triangles[t].nodes, false);
    }
    for (std::size_t node = 0; node < has_pressure.size(); ++node) {
      if (!has_pressure[node]) sum_.hold_pressure(static_cast<int>(node));
    }
  }

  void add_channels() {
    for (std::size_t s = 0; s < mesh_.sheets().segments.size(); ++s) {
      add(channel_element(mesh_.channel(s)), mesh_.nodes_of_channel(s), mesh_.sheets().segments[s].nodes);
    }
  }

  void add_corners() {
    for (std::size_t p = 0; p < mesh_.sheets().points.size(); ++p) {
      add(corner_element(mesh_.corner(p)), mesh_.nodes_of_corner(p), std::span(&mesh_.sheets().points[p], 1));
    }
  }

  [[nodiscard]] FilmMatrices<3> finish() { return sum_.finish(); }

 private:
  [[nodiscard]] Eigen::Vector3d position(const SolidNode& node) const { return mesh_.grains().position(node); }

  [[nodiscard]] static std::vector<int> pressures_of(std::span<const SheetNode> nodes) {
    std::vector<int> pressures;
    for (const auto& node : nodes) pressures.push_back(static_cast<int>(node.number));
    return pressures;
  }

  void add(const BinderElement& element, std::span<const SolidNode> nodes, std::span<const SheetNode> pressure_nodes) {
    const auto unknowns = mesh_.unknowns_of(nodes);
    const auto pressures = pressures_of(pressure_nodes);
    sum_.add_shear(unknowns, element.shear);
    sum_.add_dilatation(pressures, unknowns, element.dilatation);
    sum_.add_volume(pressures, element.volume);
    sum_.add_content(element.volume.sum());
  }

  const SpaceMesh& mesh_;
  MatrixAssembly<3> sum_;
};

}  // namespace

FilmMatrices<3> films_in_space(const FilmProblem<3>& problem) {
  const SpaceMesh mesh(problem);
  SpaceAssembly films(mesh);
  films.add_grains(problem);
  films.add_films();
  films.add_channels();
  films.add_corners();
  films.hold_pressures();
  return films.finish();
}

}  // namespace breccia::films
