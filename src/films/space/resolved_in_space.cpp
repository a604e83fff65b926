#include "films/space/resolved_in_space.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "films/assembly/matrix_assembly.hpp"
#include "films/space/resolved_solids.hpp"
#include "films/space/solid_elements.hpp"
#include "films/space/solid_strain.hpp"
#include "films/space/solid_unknowns.hpp"

namespace breccia::films {
namespace {

/// Numbers of the pressures by node; `held` for nodes without one: those inside grains and the middles of edges.
std::vector<int> numbers_of_pressures(const ResolvedSolids& mesh) {
  std::vector<int> numbers(mesh.nodes.size(), held);
  int next = 0;
  for (const auto& tetrahedron : mesh.binder) {
    for (std::size_t corner = 0; corner < tetrahedron.corners.size(); ++corner) {
      int& number = numbers[tetrahedron.nodes[corner]];
      if (number == held) number = next++;
    }
  }
  return numbers;
}

Eigen::Vector3d middle_of(const TetrahedronCorners& corners, const std::array<std::size_t, 2>& edge) {
  return 0.5 * (corners[edge[0]] + corners[edge[1]]);
}

ElementUnknowns<3> unknowns_of(const QuadraticTetrahedron& tetrahedron) {
  const auto& corners = tetrahedron.corners;
  std::array<ElementNode, 10> nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    nodes[n] = {static_cast<int>(tetrahedron.nodes[n]),
                n < corners.size() ? corners[n] : middle_of(corners, edges_of_tetrahedron[n - corners.size()])};
  }
  return solid_unknowns(nodes);
}

}  // namespace

FilmMatrices<3> resolved_in_space(const FilmProblem<3>& problem) {
  const auto mesh = resolved_solids(SpaceMesh(problem), *problem.layers);
  const auto numbers = numbers_of_pressures(mesh);
  const auto pressures = static_cast<int>(std::ranges::count_if(numbers, [](int number) { return number != held; }));
  MatrixAssembly<3> sum(displacements_of(static_cast<int>(mesh.nodes.size())), pressures);
  for (std::size_t t = 0; t < mesh.grains.size(); ++t) {
    const auto& tetrahedron = mesh.grains[t];
    const auto elasticity = elasticity_of_grain(problem, mesh.grain_of_element[t]);
    sum.add_grain(unknowns_of(tetrahedron), tetrahedron_stiffness(tetrahedron.corners, elasticity));
    sum.add_content_of_grain(volume_of(tetrahedron.corners), elasticity);
  }
  for (const auto& tetrahedron : mesh.binder) {
    const auto element = taylor_hood_element(tetrahedron.corners);
    const auto unknowns = unknowns_of(tetrahedron);
    std::array<int, 4> of_corners{};
    for (std::size_t i = 0; i < of_corners.size(); ++i) of_corners[i] = numbers[tetrahedron.nodes[i]];
    sum.add_shear(unknowns, element.shear);
    sum.add_dilatation(of_corners, unknowns, element.dilatation);
    sum.add_volume(of_corners, element.volume);
    sum.add_content(element.volume.sum());
  }
  return sum.finish();
}

}  // namespace breccia::films
