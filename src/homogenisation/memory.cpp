#include "breccia/homogenisation/memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/discretisation/cell_shape.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/expected_snapshots.hpp"
#include "breccia/homogenisation/film_estimate.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/test_requests.hpp"
#include "breccia/homogenisation/varying_phases.hpp"
#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/image_statistics.hpp"
#include "breccia/study/chain.hpp"
#include "breccia/study/filler_shapes.hpp"
#include "breccia/study/filler_sizes.hpp"
#include "breccia/study/test_rules.hpp"

namespace breccia {
namespace {

/// Largest memory [B] of the dynamic tests of a stage on a grid of `cells` cells per side. Tests whose time domains
/// cannot be planned from estimated moduli are left out; the run itself plans with computed moduli.
template <int dim>
double dynamic_memory(const Study& study, const Stage& stage, int cells) {
  // Neither the positions of the particles matter nor the grid on which the time domains are planned.
  constexpr int few = 2;
  const auto discretisation = discretise<dim>(stage, {stage.side, Walls::hard, {}}, few, study.tests.mixing);
  const double refinement = static_cast<double>(cells) / few;
  double most = 0.0;
  try {
    for (const auto boundary : study.tests.boundaries) {
      for (const auto load : loads_of(study, stage)) {
        const auto test =
            make_dynamic_test(study, stage, expected_matrix(study, stage), discretisation, boundary, load, 0);
        most = std::max(most, static_cast<double>(plan_dynamic_test(test, refinement).bytes));
      }
    }
  } catch (const NumericalError&) {
    // The largest memory found so far is returned.
  }
  return most;
}

double dynamic_memory(const Study& study, const Stage& stage, int cells) {
  return stage.dimensions() == 3 ? dynamic_memory<3>(study, stage, cells) : dynamic_memory<2>(study, stage, cells);
}

/// Interface of the particles of a filler, per volume of the filler [1/m]: that of the smallest ones, which have most.
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

double share_of_mixed_cells(const Study& study, const Stage& stage, int cells) {
  if (study.tests.mixing == Mixing::points) return 0.0;
  return std::min(1.0, visit_nested(ShareOfMixedCells{stage, stage.side / cells}, stage.packing));
}

/// Grains and films that need more than the available memory [B]: a message, with the number of grains that would fit.
std::optional<std::string> lacking_for_films(const Study& study, const Stage& stage, double available) {
  const auto grains = expected_grains(stage);
  const double bytes = film_memory(study, stage, grains), left = std::max(0.0, available);
  if (bytes <= left) return std::nullopt;
  // Larger factors are in files, so that the need does not grow steadily with the grains.
  double fitting = grains.count;
  constexpr double fewer = 0.999;
  while (fitting >= 1.0 && film_memory(study, stage, {fitting, grains.film}) > left)
    fitting = std::floor(fewer * fitting);
  return fmt::format("{}: {:.0f} grains and films take about {:.3g} GB, and {:.3g} GB are left{}", stage.name,
                     grains.count, bytes / 1e9, left / 1e9,
                     fitting >= 1.0 ? fmt::format("; {:.0f} grains would fit", fitting) : "");
}

}  // namespace

double quasistatic_unknowns(const Stage& stage, int cells) {
  // Displacements of a node; there are about as many nodes as cells.
  return stage.dimensions() * std::pow(static_cast<double>(cells), stage.dimensions());
}

namespace {

/// Nodal vectors of the terms of all materials that stepping keeps for each load, in the run with fine and in that with
/// coarse time steps.
double vectors_of_stepping(const Study& study, const Stage& stage) {
  std::size_t terms = 0;
  for (const auto& material : materials_of(stage, expected_matrix(study, stage))) {
    terms += material.bulk.terms().size() + material.shear.terms().size();
  }
  return 2.0 * static_cast<double>(terms * loads_of(study, stage).size());
}

/// Bytes an unknown of a cube beside what sparse factors take, with fields of `strains` bytes an unknown for the
/// strains of phases in a nodal vector.
double bytes_of_cube(const Study& study, const Stage& stage, double strains) {
  constexpr double vector = sizeof(double);
  const double whole = vector + strains;
  // The phases of the points and the kinds of the cells.
  constexpr double cells = (8.0 * sizeof(PhaseIndex) + sizeof(std::uint32_t)) / 3.0;
  // The vectors of a basis have no strains of phases. Products of their forces take three vectors with strains and one
  // without; conjugate gradients, which keep five without, take less. The rest is what a run of 96 cells a side takes
  // beside (docs/three-dimensions.md).
  constexpr double rest = 20.0;
  double bytes = cells + 3.0 * whole + vector + rest;
  if (study.tests.quasistatic.solver == Solver::stepping) {
    bytes += whole * (1.0 + vectors_of_stepping(study, stage));
  } else {
    const auto loads = static_cast<double>(loads_of(study, stage).size());
    bytes += vector * loads * (1.0 + expected_snapshots(study.tests, stage));
  }
  if (study.tests.field_times.empty()) return bytes;
  // Fields take the moduli of each phase applied to the displacement, twice, and 15 values a cell and time.
  const auto phases = static_cast<double>(materials_of(stage, expected_matrix(study, stage)).size());
  return bytes + (4.0 * phases + 2.0) * whole +
         15.0 / 3.0 * vector * static_cast<double>(study.tests.field_times.size());
}

/// The same of a square, with as many nodal vectors as there are with the strains of phases in each.
double bytes_of_square(const Study& study, const Stage& stage, double strains) {
  constexpr double vector = sizeof(double);
  const double whole = vector + strains;
  if (study.tests.quasistatic.solver == Solver::stepping) return whole * vectors_of_stepping(study, stage);
  // The residual of a reduced basis takes a nodal vector for each modulus that varies, among a dozen for the matrix.
  double bytes = 2.0 * whole * static_cast<double>(other_varying_phases(study.tests, stage).size());
  // So does each snapshot under each load; those that the matrix alone takes are among the dozen as well.
  constexpr double few_snapshots = 11.0;
  bytes += whole * static_cast<double>(loads_of(study, stage).size()) *
           std::max(0.0, expected_snapshots(study.tests, stage) - few_snapshots);
  return bytes;
}

}  // namespace

double quasistatic_memory(const Study& study, const Stage& stage, int cells) {
  const double unknowns = quasistatic_unknowns(stage, cells);
  // Strains of the second phase of mixed cells beside the displacements a cell of each nodal vector.
  const int modes = stage.dimensions() == 3 ? CellShape<3>::modes : CellShape<2>::modes;
  constexpr double vector = sizeof(double);
  const double strains = vector * modes / stage.dimensions() * share_of_mixed_cells(study, stage, cells);
  const bool is_direct =
      study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), stage.dimensions());
  // Sparse Cholesky factors of a square grid, ordered by nested dissection.
  const double factors = is_direct ? 640.0 + 60.0 * std::log2(unknowns) : 0.0;
  if (stage.dimensions() == 3) return unknowns * (factors + bytes_of_cube(study, stage, strains));
  constexpr double dozen = 12.0;
  const double further = bytes_of_square(study, stage, strains);
  if (is_direct) return unknowns * (factors + dozen * strains + further);
  // Substructures and a dozen nodal vectors; fields of a square take as much again.
  constexpr double substructures = 340.0;
  const double fields = study.tests.field_times.empty() ? 1.0 : 2.0;
  return unknowns * (fields * (substructures + dozen * strains) + further);
}

std::vector<std::string> lacking_memory(const Study& study, double available) {
  std::vector<std::string> lines;
  for (const auto& stage : study.stages) {
    if (model_of(study.tests, stage) == Model::films) {
      if (auto line = lacking_for_films(study, stage, available)) lines.push_back(*std::move(line));
      continue;
    }
    const int cells = stage.cells;
    for (const auto method : study.tests.methods) {
      const double bytes =
          method == Method::quasistatic ? quasistatic_memory(study, stage, cells) : dynamic_memory(study, stage, cells);
      const double left = std::max(0.0, available);
      if (bytes <= left) continue;
      const int fitting = static_cast<int>(cells * std::pow(left / bytes, 1.0 / stage.dimensions()));
      lines.push_back(fmt::format("{}: {} cells take about {:.3g} GB by the {} method, and {:.3g} GB are left{}",
                                  stage.name, cells_in_words(stage, cells), bytes / 1e9,
                                  method == Method::quasistatic ? "quasi-static" : "dynamic", left / 1e9,
                                  fitting > 1 ? fmt::format("; cells = {} would fit", fitting) : ""));
    }
  }
  return lines;
}

void require_memory(const Study& study, double available) {
  const auto lines = lacking_memory(study, available);
  if (!lines.empty()) throw LackingMemory(fmt::format("{}", fmt::join(lines, "\n")));
}

}  // namespace breccia
