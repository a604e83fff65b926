#include "homogenisation/plan/cell_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/ellipsoid.hpp"

#include "discretisation/cell_shape.hpp"
#include "discretisation/contrast.hpp"
#include "homogenisation/narrow_gaps.hpp"
#include "homogenisation/plan/expected_snapshots.hpp"
#include "homogenisation/plan/measured_costs.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "homogenisation/varying_phases.hpp"
#include "microstructure/image/image_statistics.hpp"
#include "study/chain.hpp"
#include "study/filler_shapes.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// Interface of the particles of a filler, per volume of the filler [1/m]: that of the smallest particles, which is the
/// largest.
double specific_interface(const Filler& filler, double smallest, int dimensions) {
  if (dimensions == 2) return 4.0 / smallest;
  const Ellipsoid particle{{}, axes_of(filler, smallest)};
  return surface(particle) / volume(particle);
}

double surface_of(const Sphere& sphere) {
  return ball_surface<3>(sphere.diameter);
}
double surface_of(const Ellipsoid& ellipsoid) {
  return surface(ellipsoid);
}

/// Largest share of the cells of side h [m] that interfaces of a filler cross: on the average over all directions an
/// interface crosses 4 / pi cells per h of its length in 2 dimensions, and 3 / 2 per h^2 of its area in 3. A coating
/// has two interfaces.
double share_of_mixed_cells(const Stage& stage, const Filler& filler, double h) {
  const auto sizes = stage.is_listed() ? diameters_of(stage) : diameters_of(filler);
  if (!sizes) return 1.0;
  const double crossed = stage.dimensions() == 3 ? 1.5 : 4.0 / std::numbers::pi;
  return crossed * h * filler.fraction.value_or(1.0) * specific_interface(filler, sizes->smallest, stage.dimensions());
}

/// The share of mixed cells of side h [m] of a stage, which may be above 1, by its packing.
struct ShareOfMixedCells {
  const Stage& stage;
  double h;

  template <int dim>
  double operator()(const ImagePacking<dim>& pixels) const {
    return specific_interface(*pixels.image) * h;
  }
  double operator()(const ExplicitPacking<3>& listed) const {
    double interface = 0.0;
    std::visit(
        [&](const auto& particles) {
          for (const auto& one : particles) interface += surface_of(one);
        },
        listed.particles);
    const auto is_coated = [](const Filler& one) { return one.coating.has_value(); };
    const double interfaces = std::ranges::any_of(stage.fillers, is_coated) ? 2.0 : 1.0;
    return 1.5 * h * interfaces * (interface / std::pow(stage.side, 3.0));
  }
  template <class Packing>
  double operator()(const Packing&) const {
    double share = 0.0;
    for (const auto& filler : stage.fillers) {
      share += (filler.coating ? 2.0 : 1.0) * share_of_mixed_cells(stage, filler, h);
    }
    return share;
  }
};

/// Number of nodal vectors that stepping keeps for each load, for the terms of all materials, in the run with fine time
/// steps and in that with coarse ones.
double vectors_of_stepping(const Study& study, const Stage& stage) {
  std::size_t terms = 0;
  for (const auto& material : materials_of(stage, expected_matrix(study, stage))) {
    terms += material.bulk.terms().size() + material.shear.terms().size();
  }
  return 2.0 * static_cast<double>(terms * most_solved_loads(study, stage));
}

/// Bytes an unknown of a cube without the sparse factors. `strains` is the size, in bytes an unknown, of the strains of
/// phases in a nodal vector.
double bytes_of_cube(const Study& study, const Stage& stage, double strains) {
  constexpr double vector = sizeof(double);
  const double whole = vector + strains;
  // The phases of the points and the kinds of the cells.
  constexpr double cells = (8.0 * sizeof(PhaseIndex) + sizeof(std::uint32_t)) / 3.0;
  // The vectors of a basis have no strains of phases. Products of their forces take three vectors with strains and one
  // without; conjugate gradients, which keep five without, take less. The rest was measured in a run of 96 cells a
  // side.
  double bytes = cells + 3.0 * whole + vector + measured_costs::rest_of_cube;
  if (study.tests.quasistatic.solver == Solver::stepping) {
    bytes += whole * (1.0 + vectors_of_stepping(study, stage));
  } else {
    const auto loads = static_cast<double>(most_solved_loads(study, stage));
    bytes += vector * loads * (1.0 + expected_snapshots(study, stage));
  }
  if (study.tests.field_times.empty()) return bytes;
  // Fields take the moduli of each phase applied to the displacement, twice, and 15 values a cell and time.
  const auto phases = static_cast<double>(materials_of(stage, expected_matrix(study, stage)).size());
  return bytes + (4.0 * phases + 2.0) * whole +
         15.0 / 3.0 * vector * static_cast<double>(study.tests.field_times.size());
}

/// Bytes an unknown of a square. `strains` is the size, in bytes an unknown, of the strains of phases in a nodal
/// vector.
double bytes_of_square(const Study& study, const Stage& stage, double strains) {
  constexpr double vector = sizeof(double);
  const double whole = vector + strains;
  if (study.tests.quasistatic.solver == Solver::stepping) return whole * vectors_of_stepping(study, stage);
  // The residual of a reduced basis takes a nodal vector for each modulus that varies, among a dozen for the matrix.
  double bytes = 2.0 * whole * static_cast<double>(other_varying_phases(study.tests, stage).size());
  // Each snapshot under each load takes one, too; the snapshots for the matrix alone, of up to three loads, are among
  // the dozen as well.
  constexpr double few_snapshots = 11.0, few_loads = 3.0;
  const double snapshots = expected_snapshots(study, stage);
  const auto loads = static_cast<double>(most_solved_loads(study, stage));
  bytes += whole * loads * std::max(0.0, snapshots - few_snapshots);
  bytes += whole * std::max(0.0, loads - few_loads) * std::min(snapshots, few_snapshots);
  return bytes;
}

}  // namespace

bool is_expected_to_have_flow(const Study& study, const Stage& stage) {
  if (study.tests.mixing != Mixing::flow || stage.fillers.empty()) return false;
  // The gaps of particles in a lattice or a list follow from their places.
  if (!stage.has_seed()) return mixing_of(study, stage, make_microstructure(stage)) == Mixing::flow;
  const bool asks_for_narrow_gaps = std::ranges::any_of(
      stage.fillers, [&](const Filler& filler) { return filler.gap < cells_in_narrow_gaps * stage.cell_size(); });
  return asks_for_narrow_gaps && are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)));
}

double quasistatic_unknowns(const Study& study, const Stage& stage, int cells) {
  // Displacements of a node; there are about as many nodes as cells.
  const double of_nodes = stage.dimensions() * std::pow(static_cast<double>(cells), stage.dimensions());
  return is_expected_to_have_flow(study, stage) ? measured_costs::unknowns_with_flow * of_nodes : of_nodes;
}

double share_of_mixed_cells(const Study& study, const Stage& stage, int cells) {
  if (study.tests.mixing == Mixing::points) return 0.0;
  return std::min(1.0, visit_nested(ShareOfMixedCells{stage, stage.side / cells}, stage.packing));
}

double quasistatic_memory(const Study& study, const Stage& stage, int cells) {
  const double unknowns = quasistatic_unknowns(study, stage, cells);
  // Strains of the second phase of mixed cells, in each nodal vector, relative to the displacements of a cell.
  const int modes = stage.dimensions() == 3 ? CellShape<3>::modes : CellShape<2>::modes;
  constexpr double vector = sizeof(double);
  const double strains = vector * modes / stage.dimensions() * share_of_mixed_cells(study, stage, cells);
  const bool is_direct =
      study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), stage.dimensions());
  // Sparse Cholesky factors of a square grid, ordered by nested dissection.
  const double factors =
      is_direct ? measured_costs::factors + measured_costs::factors_of_logarithm * std::log2(unknowns) : 0.0;
  if (stage.dimensions() == 3) {
    const double of_flow = is_direct ? measured_costs::factors_of_cube_with_flow : measured_costs::saddle_point_of_cube;
    const double of_solver = is_expected_to_have_flow(study, stage) ? of_flow : factors;
    return measured_costs::program + unknowns * (of_solver + bytes_of_cube(study, stage, strains));
  }
  const double further = bytes_of_square(study, stage, strains);
  const double strains_of_vectors = measured_costs::vectors_among_others * strains;
  if (is_direct) return measured_costs::program + unknowns * (factors + strains_of_vectors + further);
  // Fields of a square double the memory of the vectors.
  const double fields = study.tests.field_times.empty() ? 1.0 : 2.0;
  return measured_costs::program + unknowns * (fields * (measured_costs::substructures + strains_of_vectors) + further);
}

}  // namespace breccia
