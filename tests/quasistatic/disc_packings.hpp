#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "tables/csv.hpp"

namespace breccia::test {

/// The discs of a table in a box of side 1.
inline Microstructure<2> discs_of(const std::string& file, Walls walls) {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/disc_packings/" + file, {});
  const auto &x = table.numbers("x"), &y = table.numbers("y"), &diameter = table.numbers("diameter");
  Microstructure<2> box = {1.0, walls, {}};
  for (std::size_t disc = 0; disc < table.rows(); ++disc) box.particles.push_back({{x[disc], y[disc]}, diameter[disc]});
  return box;
}

/// A packing of discs in a periodic box (tests/reference/disc_packings).
inline Microstructure<2> disc_packing(const std::string& name) {
  return discs_of("packings/" + name, Walls::periodic);
}
/// One in a box with walls.
inline Microstructure<2> disc_packing_between_walls(const std::string& name) {
  return discs_of("packings_walls/" + name, Walls::hard);
}

/// The box, moved by a share of a cell along both axes.
inline Microstructure<2> moved(Microstructure<2> box, const Vector<2>& cells, int n) {
  for (auto& disc : box.particles) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      disc.centre[axis] = std::fmod(disc.centre[axis] + cells[axis] / n + 1.0, 1.0);
    }
  }
  return box;
}

/// A box on n x n cells with gaps, under a periodic boundary or, with walls, a displacement boundary. The binder has a
/// shear modulus of 1.
inline QuasistaticProblem<2> with_gaps(const Microstructure<2>& box, int n, double bulk_ratio, double contrast) {
  const std::vector<PhaseIndex> discs(box.particles.size(), 1);
  QuasistaticProblem<2> problem = {
      .discretisation = discretise_mixed(box, n, 0, discs, 2),
      .materials = {{"binder", 1.0, PronySeries(bulk_ratio), PronySeries(1.0)},
                    {"discs", 1.0, PronySeries(contrast * 13.4 / 5.84), PronySeries(contrast)}},
      .volumetric = Volumetric::averaged,
      .boundary = box.walls == Walls::periodic ? Boundary::periodic : Boundary::displacement};
  problem.discretisation.set_particles_with_gaps(
      std::make_shared<const ParticlesInBox<2>>(ParticlesInBox<2>{as_particles(box), 0, without_coatings(discs)}));
  return problem;
}

/// Its modulus under a load, over the shear modulus of the binder.
inline double modulus_of(const QuasistaticProblem<2>& problem, Load load) {
  const auto& binder = problem.materials.front();
  const Moduli matrix = {.bulk = binder.bulk.at(0.0), .shear = binder.shear.at(0.0)};
  return sample_responses(problem, std::array{load}, matrix_path(0, std::array{matrix})).responses[0].modulus(matrix);
}

}  // namespace breccia::test
