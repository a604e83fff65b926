// Prints the apparent moduli of a packing of discs, in plane strain, over the shear modulus of the binder:
//
//   disc_moduli BOUNDARY PACKING ORDER LENGTH LAYERS BINDER_BULK[,BINDER_BULK...] [DISC_BULK DISC_SHEAR]
//
// BOUNDARY is periodic, displacement or traction (boundary.hpp); the latter two are of a box with walls. ORDER, LENGTH
// and LAYERS are the size of the mesh (edge_points.hpp); all moduli are shares of the shear modulus of the binder;
// without moduli the discs are rigid.

#include <cstdio>
#include <exception>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "apparent_moduli.hpp"
#include "boundary.hpp"
#include "element_matrices.hpp"
#include "mesh.hpp"
#include "packing.hpp"
#include "unknowns.hpp"

namespace disc_packings {
namespace {

std::vector<double> numbers_in(const std::string& list) {
  std::vector<double> numbers;
  std::istringstream stream(list);
  for (std::string number; std::getline(stream, number, ',');) numbers.push_back(std::stod(number));
  return numbers;
}

/// The area of the elements of the binder less what the discs leave of the box: large if the mesh is no division of it.
double area_error(const Packing& packing, const std::vector<ElementMatrices>& elements) {
  double error = -1.0;
  for (const Disc& disc : packing) error += std::numbers::pi * disc.radius * disc.radius;
  for (const ElementMatrices& element : elements) {
    if (element.region == Region::binder) error += element.area;
  }
  return error;
}

void print_moduli(const std::vector<std::string>& arguments) {
  const Boundary boundary = boundary_named(arguments[0]);
  const Packing packing = read_packing(arguments[1]);
  const MeshSize size = {std::stoi(arguments[2]), std::stod(arguments[3]), std::stoi(arguments[4])};
  const Filler filler = arguments.size() == 6 ? Filler::rigid : Filler::deformable;
  // There are no elements in rigid discs.
  const Moduli discs = filler == Filler::rigid ? Moduli{} : Moduli{std::stod(arguments[6]), std::stod(arguments[7])};
  const Mesh mesh = make_mesh(packing, box_of(boundary), filler, size);
  const Unknowns unknowns = number_unknowns(mesh, packing, filler, boundary);
  const auto elements = element_matrices(mesh, packing, unknowns, size.order);
  std::printf("# area error %.1e\nK_over_g,load,modulus,unknowns\n", area_error(packing, elements));
  for (const double bulk : numbers_in(arguments[5])) {
    const auto moduli = apparent_moduli(elements, unknowns, boundary, {bulk, 1.0}, discs);
    for (int load = 0; load < 3; ++load) {
      std::printf("%g,%s,%.10g,%d\n", bulk, loads()[load].name, moduli[load], unknowns.count);
    }
  }
}

}  // namespace
}  // namespace disc_packings

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  if (arguments.size() != 6 && arguments.size() != 8) {
    std::fputs("usage: disc_moduli BOUNDARY PACKING ORDER LENGTH LAYERS BINDER_BULK[,...] [DISC_BULK DISC_SHEAR]\n",
               stderr);
    return 2;
  }
  try {
    disc_packings::print_moduli(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "disc_moduli: %s\n", error.what());
    return 1;
  }
}
