#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "discretisation/mixed_cells.hpp"
#include "quasistatic/composites.hpp"
#include "quasistatic/reduced/sampling.hpp"
#include "tables/csv.hpp"

namespace breccia::test {

/// A table of tests/reference/sphere_packings.
inline CsvTable sphere_reference(const std::string& name, const std::vector<std::string>& texts) {
  return read_csv(BRECCIA_REFERENCE_DIRECTORY "/sphere_packings/" + name + ".csv", texts);
}

/// The box, moved by shares of a cell.
inline Microstructure<3> moved_by(Microstructure<3> box, const Vector<3>& cells, int n) {
  for (auto& sphere : box.particles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sphere.centre[axis] = std::fmod(sphere.centre[axis] + cells[axis] / n + 1.0, 1.0);
    }
  }
  return box;
}

/// A cubic array of equal spheres with gaps between nearest neighbours, as a share of their diameter.
inline Microstructure<3> cubic_array(const std::string& name, double gap) {
  Microstructure<3> box = {1.0, Walls::periodic, {}};
  double distance = 1.0;
  std::vector<Vector<3>> places = {{0.0, 0.0, 0.0}};
  if (name == "bcc") {
    distance = std::sqrt(0.75);
    places.push_back({0.5, 0.5, 0.5});
  } else if (name == "fcc") {
    distance = std::sqrt(0.5);
    places.insert(places.end(), {{0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}});
  }
  for (const auto& place : places) box.particles.push_back({place, distance / (1.0 + gap)});
  return box;
}

/// A packing of the references.
inline Microstructure<3> sphere_packing(const std::string& name) {
  const auto table = sphere_reference(name, {});
  const auto &x = table.numbers("x"), &y = table.numbers("y"), &z = table.numbers("z");
  Microstructure<3> box = {1.0, Walls::periodic, {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    box.particles.push_back({{x[i], y[i], z[i]}, table.numbers("diameter")[i]});
  }
  return box;
}

/// Stiff spheres with gaps in a binder with a shear modulus of 1 and a bulk modulus of 1e5.
inline QuasistaticProblem<3> spheres_with_gaps(const Microstructure<3>& box, int n, double contrast = 1e7) {
  const std::vector<PhaseIndex> spheres(box.particles.size(), 1);
  QuasistaticProblem<3> problem = {.discretisation = discretise_mixed(box, n, 0, spheres, 2),
                                   .materials = {{"binder", 1.0, PronySeries(1e5), PronySeries(1.0)},
                                                 {"spheres", 1.0, PronySeries(10.0 * contrast), PronySeries(contrast)}},
                                   .volumetric = Volumetric::averaged,
                                   .boundary = Boundary::periodic};
  problem.linear.method = LinearMethod::direct;
  problem.discretisation.set_particles_with_gaps(std::make_shared<const ParticlesInBox<3>>(
      ParticlesInBox<3>{box, 0, std::vector<ParticlePhases>(spheres.size(), {.phase = 1})}));
  return problem;
}

/// The moduli under a diagonal shear and a shear.
inline std::array<double, 2> shear_moduli(const QuasistaticProblem<3>& problem) {
  const Moduli binder = {.bulk = 1e5, .shear = 1.0};
  const auto found =
      sample_responses(problem, std::array{Load::diagonal_shear, Load::shear}, matrix_path(0, std::array{binder}));
  return {found.responses[0].modulus(binder), found.responses[1].modulus(binder)};
}

}  // namespace breccia::test
