#include "results/meshes/msh_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include <fmt/format.h>

namespace breccia {
namespace {

/// The numbers of Gmsh for the types of elements with straight edges, by the number of their corners.
constexpr std::array types_of_corners = {0, 0, 1, 2, 4};

/// The numbers of the physical groups: of the grains, of the binder, and of the first surface.
constexpr std::size_t group_of_grains = 1, group_of_binder = 2, group_of_first_surface = 3;

/// The text of a name in quotes, which may hold none itself.
std::string quoted(std::string name) {
  std::ranges::replace(name, '"', '\'');
  return fmt::format("\"{}\"", name);
}

/// Appends the sections of a file one by one.
template <int dim>
class MshWriter {
 public:
  MshWriter(const films::ConformingMesh<dim>& mesh, double scale) : mesh_(mesh), scale_(scale) {
    for (const auto& element : mesh.elements) {
      if (element.grain) grains_ = std::max(grains_, *element.grain + 1);
    }
  }

  void add_groups(const MeshMaterials& materials) {
    add("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", 2 + mesh_.surfaces.size());
    for (std::size_t s = 0; s < mesh_.surfaces.size(); ++s) {
      add("{} {} {}\n", dim - 1, group_of_first_surface + s, quoted(name_of(mesh_.surfaces[s])));
    }
    add("{} {} {}\n", dim, group_of_grains, quoted(materials.grains));
    add("{} {} {}\n$EndPhysicalNames\n", dim, group_of_binder, quoted(materials.binder));
  }

  void add_nodes() {
    add("$Nodes\n{}\n", mesh_.nodes.size());
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      std::array<double, 3> place{};
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) place[axis] = scale_ * mesh_.nodes[n][axis];
      add("{} {} {} {}\n", n + 1, place[0], place[1], place[2]);
    }
    add("$EndNodes\n");
  }

  void add_elements() {
    std::size_t count = mesh_.elements.size();
    for (const auto& surface : mesh_.surfaces) count += surface.facets.size();
    add("$Elements\n{}\n", count);
    for (std::size_t s = 0; s < mesh_.surfaces.size(); ++s) {
      for (const auto& facet : mesh_.surfaces[s].facets) add_element(facet, group_of_first_surface + s, s + 1);
    }
    for (const auto& element : mesh_.elements) {
      add_element(element.nodes, element.grain ? group_of_grains : group_of_binder,
                  element.grain.value_or(grains_) + 1);
    }
    add("$EndElements\n");
  }

  void add_periodic() {
    if (mesh_.opposites.empty()) return;
    add("$Periodic\n{}\n", mesh_.opposites.size());
    for (const auto& [first, second, displacement, nodes] : mesh_.opposites) {
      std::array<double, 3> by{};
      for (std::size_t axis = 0; axis < displacement.size(); ++axis) {
        by[axis] = scale_ * mesh_.side * displacement[axis];
      }
      add("{} {} {}\n", dim - 1, second + 1, first + 1);
      add("Affine 1 0 0 {} 0 1 0 {} 0 0 1 {} 0 0 0 1\n{}\n", by[0], by[1], by[2], nodes.size());
      for (const auto& [node, displaced] : nodes) add("{} {}\n", displaced + 1, node + 1);
    }
    add("$EndPeriodic\n");
  }

  [[nodiscard]] std::string take() { return fmt::to_string(text_); }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
  }

  template <std::size_t corners>
  void add_element(const std::array<std::size_t, corners>& nodes, std::size_t group, std::size_t entity) {
    add("{} {} 2 {} {}", ++elements_, types_of_corners[corners], group, entity);
    for (const auto node : nodes) add(" {}", node + 1);
    add("\n");
  }

  const films::ConformingMesh<dim>& mesh_;
  double scale_;
  std::size_t grains_ = 0;    ///< number of grains
  std::size_t elements_ = 0;  ///< number of elements so far
  fmt::memory_buffer text_;
};

}  // namespace

template <int dim>
std::string name_of(const films::MeshSurface<dim>& surface) {
  if (surface.beyond == films::Beyond::gap) return "gap";
  std::string name = surface.beyond == films::Beyond::image ? "side" : "wall";
  constexpr std::array axes = {'x', 'y', 'z'};
  for (std::size_t axis = 0; axis < surface.direction.size(); ++axis) {
    const int step = surface.direction[axis];
    if (step != 0) name += fmt::format("_{}_{}", axes[axis], step > 0 ? "plus" : "minus");
  }
  return name;
}

template std::string name_of(const films::MeshSurface<2>&);
template std::string name_of(const films::MeshSurface<3>&);

template <int dim>
std::string msh_text(const films::ConformingMesh<dim>& mesh, const MeshMaterials& materials, double scale) {
  MshWriter<dim> writer(mesh, scale);
  writer.add_groups(materials);
  writer.add_nodes();
  writer.add_elements();
  writer.add_periodic();
  return writer.take();
}

template std::string msh_text(const films::ConformingMesh<2>&, const MeshMaterials&, double);
template std::string msh_text(const films::ConformingMesh<3>&, const MeshMaterials&, double);

}  // namespace breccia
