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
#include "breccia/microstructure/image_statistics.hpp"
#include "breccia/study/chain.hpp"
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
  return stage.dimensions == 3 ? dynamic_memory<3>(study, stage, cells) : dynamic_memory<2>(study, stage, cells);
}

/// Largest share of the cells of side h [m] that interfaces of a filler cross: a disc of diameter d crosses about
/// 4 d / h cells, a sphere about 3/2 pi (d / h)^2, and particles of the smallest diameter have the largest interface. A
/// coating has two interfaces.
double share_of_mixed_cells(const Stage& stage, const Filler& filler, double h) {
  const auto sizes = stage.listed() != nullptr ? diameters_of(stage) : diameters_of(filler);
  if (!sizes) return 1.0;
  const double interfaces = filler.coating ? 2.0 : 1.0;
  const double crossed = stage.dimensions == 3 ? 9.0 : 16.0 / std::numbers::pi;
  return interfaces * crossed * filler.fraction.value_or(1.0) * h / sizes->smallest;
}

double share_of_mixed_cells(const Study& study, const Stage& stage, int cells) {
  if (study.tests.mixing == Mixing::points) return 0.0;
  if (const auto* image = stage.image()) return std::min(1.0, specific_interface(*image) * stage.side / cells);
  if (const auto* stack = stage.stack()) return std::min(1.0, specific_interface(*stack) * stage.side / cells);
  double share = 0.0;
  for (const auto& filler : stage.fillers) share += share_of_mixed_cells(stage, filler, stage.side / cells);
  return std::min(1.0, share);
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
  return stage.dimensions * std::pow(static_cast<double>(cells), stage.dimensions);
}

double quasistatic_memory(const Study& study, const Stage& stage, int cells) {
  const double unknowns = quasistatic_unknowns(stage, cells);
  // Strains of the second phase of mixed cells beside the displacements a cell of each nodal vector.
  const int modes = stage.dimensions == 3 ? CellShape<3>::modes : CellShape<2>::modes;
  const double vectors =
      1.0 + modes / static_cast<double>(stage.dimensions) * share_of_mixed_cells(study, stage, cells);
  constexpr double dozen = 12.0 * sizeof(double);
  constexpr double vector = sizeof(double);
  // The residual of a reduced basis takes a nodal vector for each modulus that varies, among the dozen for the matrix.
  double further = 2.0 * vector * vectors * static_cast<double>(other_varying_phases(study.tests, stage).size());
  // So does each snapshot under each load; those that the matrix alone takes are among the dozen as well.
  constexpr double few_snapshots = 11.0;
  further += vector * vectors * static_cast<double>(loads_of(study, stage).size()) *
             std::max(0.0, expected_snapshots(study.tests, stage) - few_snapshots);
  if (study.tests.quasistatic.solver == Solver::stepping) {
    // A nodal vector for each term, in the run with fine and in that with coarse time steps.
    std::size_t terms = 0;
    for (const auto& material : materials_of(stage, expected_matrix(study, stage))) {
      terms += material.bulk.terms().size() + material.shear.terms().size();
    }
    further = 2.0 * vector * vectors * static_cast<double>(terms * loads_of(study, stage).size());
  }
  if (study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), 1, stage.dimensions)) {
    // Sparse Cholesky factors of a square grid, ordered by nested dissection.
    return unknowns * (640.0 + 60.0 * std::log2(unknowns) + dozen * (vectors - 1.0) + further);
  }
  // Fields of the iteration, a dozen nodal vectors, and the fractions and labels of the cells. Fields in space take the
  // moduli of each phase applied to the displacement, twice, and 15 values a cell and time.
  if (stage.dimensions == 3) {
    const auto phases = static_cast<double>(materials_of(stage, expected_matrix(study, stage)).size());
    const double of_fields = (4.0 * phases + 2.0) * sizeof(double);
    const double values_in_cell = 15.0 * sizeof(double) / 3.0 * static_cast<double>(study.tests.field_times.size());
    const double in_space = study.tests.field_times.empty() ? 0.0 : of_fields * vectors + values_in_cell;
    return unknowns * (60.0 + dozen * vectors + in_space + further);
  }
  // Substructures and a dozen nodal vectors; fields of a square take as much again.
  constexpr double substructures = 340.0 - dozen;
  const double fields = study.tests.field_times.empty() ? 1.0 : 2.0;
  return unknowns * (fields * (substructures + dozen * vectors) + further);
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
      const int fitting = static_cast<int>(cells * std::pow(left / bytes, 1.0 / stage.dimensions));
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
