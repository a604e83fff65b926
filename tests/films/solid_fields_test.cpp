#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/microstructure/random_sites.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "films/elastic_state.hpp"
#include "films/film_sampling.hpp"
#include "films/film_stepping.hpp"
#include "films/grains_and_films.hpp"
#include "films/space/solid_recovery.hpp"
#include "quasistatic/reduced/carson_path.hpp"

namespace breccia::films {
namespace {

using test::hmx;

constexpr std::array loads_in_space = {Load::shear, Load::axial_shear, Load::shear_yz, Load::bulk};
constexpr std::size_t components = 6;

/// A fifth of the films of six grains are debonded in some way, or all are bonded.
FilmProblem<3> six_grains(std::optional<Debonding> debonding = {}) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  for (int i = 0; i < 6; ++i) request.diameters.push_back(1.0 + 0.1 * i);
  const Tessellation<3> tessellation(random_sites<3>(request));
  FilmProblem<3> problem = {.tessellation = tessellation,
                            .thickness = film_thickness(tessellation, 0.93),
                            .grain = hmx,
                            .elements = {.divisions = 1}};
  if (debonding) problem.debonded = {*debonding, random_faces(tessellation, 0.2, 1).faces, {1e14, 3e13}};
  return problem;
}

/// Means of the fields over the box.
struct Means {
  double volume = 0.0, work = 0.0;
  std::array<double, components> stress{}, strain{};
};

Means means_of(const FilmFields<3>& fields, double side) {
  Means means;
  for (const auto& cell : fields.cells) {
    const double share = cell.content / (side * side * side);
    means.volume += share;
    means.work += share * cell.work;
    for (std::size_t i = 0; i < components; ++i) {
      means.stress[i] += share * cell.stress[i];
      means.strain[i] += share * cell.strain[i];
    }
  }
  return means;
}

template <class Tensor>
std::array<double, components> components_of(const Tensor& tensor) {
  return {tensor.xx, tensor.yy, tensor.zz, tensor.yz, tensor.zx, tensor.xy};
}

/// The stress or strain component of a load.
double stress_under(Load load, const std::array<double, components>& stress) {
  const auto& [xx, yy, zz, yz, zx, xy] = stress;
  return modulus_of<3>(load, {.xx = xx, .yy = yy, .zz = zz, .yz = yz, .zx = zx, .xy = xy});
}

/// Fields with an elastic binder, and the modulus from the energy of the solution.
struct ElasticFields {
  FilmFields<3> fields;
  double modulus = 0.0;
};

ElasticFields elastic_fields(const FilmProblem<3>& problem, const Moduli& binder, Load load) {
  const FilmComposite<3> composite(problem);
  const auto state = test::elastic_state(composite, binder, load);
  const std::array parameters = {binder.shear, binder.bulk};
  return {FilmRecovery<3>(composite, problem).fields(load, state),
          work(composite.forces(parameters, load, state.displacement), state.displacement)};
}

// If the binder has the moduli of the grains, the box is homogeneous: stress and strain are uniform.
TEST(SolidFields, OfOneMaterialAreUniform) {
  for (const auto load : loads_in_space) {
    const auto strain = unit_strain<3>(load);
    const auto expected = components_of(strain);
    const double trace = strain.xx + strain.yy + strain.zz;
    for (const auto& cell : elastic_fields(six_grains(), hmx, load).fields.cells) {
      for (std::size_t i = 0; i < components; ++i) {
        const double of_trace = i < 3 ? trace : 0.0;
        const double stress = 2.0 * hmx.shear * (expected[i] - of_trace / 3.0) + hmx.bulk * of_trace;
        EXPECT_NEAR(cell.strain[i], expected[i], 1e-9);
        EXPECT_NEAR(cell.stress[i] / hmx.shear, stress / hmx.shear, 1e-8);
      }
      EXPECT_NEAR(cell.flow, 0.0, 1e-12);
    }
  }
}

// The cells tile the box; its mean strain is that of the load, its mean stress and work are the modulus.
TEST(SolidFields, HaveTheMeansOfTheirLoads) {
  using enum Debonding;
  for (const auto debonding : {std::optional<Debonding>(), std::optional(open), std::optional(sealed),
                               std::optional(slip), std::optional(spring)}) {
    const auto problem = six_grains(debonding);
    for (const auto load : loads_in_space) {
      SCOPED_TRACE(std::string(name_of(load)) + (debonding ? " debonded" : ""));
      const auto [fields, modulus] = elastic_fields(problem, {test::binder_bulk, 1e6}, load);
      const auto means = means_of(fields, problem.tessellation.side());
      EXPECT_NEAR(means.volume, 1.0, 1e-12);
      const auto expected = components_of(unit_strain<3>(load));
      for (std::size_t i = 0; i < components; ++i) EXPECT_NEAR(means.strain[i], expected[i], 1e-12);
      EXPECT_NEAR(stress_under(load, means.stress) / modulus, 1.0, 1e-9);
      EXPECT_NEAR(means.work / modulus, 1.0, 1e-9);
    }
  }
}

// In time the mean stress and the mean work are the modulus (Hill), of a reduced basis and of steps.
TEST(SolidFields, HaveTheMeansOfTheCurves) {
  const auto binder = test::relaxing_binder();
  const auto problem = six_grains(Debonding::open);
  const std::array only = {Load::shear};
  const auto sampled = sample_film_responses(problem, only, carson_path(binder, {1e-7, 1e1}));
  const auto curve = relaxation_modulus(creep_compliance(sampled.responses.front(), binder));
  for (const double time : {1e-7, 1e-4, 1e1}) {
    const auto means = means_of(sampled.fields(0, std::array{binder}, time), problem.tessellation.side());
    EXPECT_NEAR(stress_under(Load::shear, means.stress) / curve.at(time), 1.0, 1e-9);
    EXPECT_NEAR(means.work / curve.at(time), 1.0, 1e-9);
  }
  const std::vector steps = {1e-7, 1e-6, 1e-5}, kept = {1e-5};
  const auto stepped = run_film_stepping(problem, binder, only, steps, {}, kept);
  ASSERT_EQ(stepped.fields.size(), 1U);
  const auto means = means_of(stepped.fields.front().fields, problem.tessellation.side());
  EXPECT_NEAR(stress_under(Load::shear, means.stress) / stepped.responses.front().values.back(), 1.0, 1e-9);
  EXPECT_NEAR(means.strain.back(), 0.5, 1e-12);
}

// A gap carries nothing and opens or slides; bonded films carry, and the largest strains are in them.
TEST(SolidFields, ShowGapsAndFilms) {
  const auto fields = elastic_fields(six_grains(Debonding::open), {test::binder_bulk, 1e6}, Load::shear).fields;
  std::array<std::size_t, 6> count{};
  double in_binder = 0.0, all = 0.0;
  for (const auto& cell : fields.cells) {
    ++count.at(static_cast<std::size_t>(cell.part));
    all += cell.content * cell.work;
    if (cell.part == FilmPart::gap) {
      EXPECT_EQ(cell.work, 0.0);
      EXPECT_EQ(cell.stress, (std::array<double, components>{}));
      EXPECT_EQ(cell.flow, 0.0);
      EXPECT_GT(std::hypot(cell.slip, cell.opening), 0.0);
    }
    if (cell.part != FilmPart::grain) in_binder += cell.content * cell.work;
    EXPECT_EQ(cell.corners, cell.part == FilmPart::grain || cell.part == FilmPart::junction ? 4U : 6U);
  }
  for (const auto part : {FilmPart::grain, FilmPart::film, FilmPart::junction, FilmPart::gap, FilmPart::channel}) {
    EXPECT_GT(count.at(static_cast<std::size_t>(part)), 0U);
  }
  const auto sliding = elastic_fields(six_grains(Debonding::slip), {test::binder_bulk, 1e6}, Load::shear).fields;
  EXPECT_TRUE(std::ranges::any_of(sliding.cells, [](const auto& cell) { return cell.part == FilmPart::slip; }));
  EXPECT_GT(in_binder / all, 0.5);
}

/// Six times the signed volume of a tetrahedron.
double determinant(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c, const Vector<3>& d) {
  const auto minus = [&](const Vector<3>& to) { return Vector<3>{to[0] - a[0], to[1] - a[1], to[2] - a[2]}; };
  const auto u = minus(b), v = minus(c), w = minus(d);
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
}

// The corners in the order of VTK enclose the content of a cell.
TEST(SolidFields, HaveTheCornersOfTheirCells) {
  const auto problem = six_grains();
  const auto fields = elastic_fields(problem, {test::binder_bulk, 1e6}, Load::shear).fields;
  auto corner = fields.corners.begin();
  for (const auto& cell : fields.cells) {
    std::vector<Vector<3>> c;
    for (std::size_t i = 0; i < cell.corners; ++i, ++corner) c.push_back(fields.points[*corner]);
    // The triangle 0, 1, 2 of a wedge is counter-clockwise from outside, that of a tetrahedron from inside.
    const double volume = cell.corners == 4
                              ? determinant(c[0], c[1], c[2], c[3])
                              : -determinant(c[0], c[1], c[2], c[5]) - determinant(c[0], c[1], c[5], c[4]) -
                                    determinant(c[0], c[4], c[5], c[3]);
    EXPECT_NEAR(volume / 6.0 / cell.content, 1.0, cell.part == FilmPart::grain ? 1e-12 : 1e-3);
  }
}

// Corners that are a side of the box apart move apart by the strain of the load.
TEST(SolidFields, ArePeriodicButForTheStrain) {
  const auto problem = six_grains();
  const double side = problem.tessellation.side(), near = 1e-9 * side;
  const auto fields = elastic_fields(problem, {test::binder_bulk, 1e6}, Load::shear).fields;
  const auto strain = unit_strain<3>(Load::shear);
  std::size_t met = 0;
  for (std::size_t i = 0; i < fields.points.size(); i += 41) {
    for (std::size_t j = 0; j < fields.points.size(); ++j) {
      const auto &here = fields.points[i], &there = fields.points[j];
      Vector<3> apart{};
      double distance = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        apart[axis] = side * std::round((there[axis] - here[axis]) / side);
        distance = std::max(distance, std::abs(there[axis] - here[axis] - apart[axis]));
      }
      if (distance > near || apart == Vector<3>{}) continue;
      ++met;
      const auto moved = product(strain, apart);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(fields.displacement[j][axis] - fields.displacement[i][axis], moved[axis], near);
      }
    }
  }
  EXPECT_GT(met, 20U);
}

// Between very unlike grains junctions may be inverted: the means hold all the same.
TEST(SolidFields, HaveTheirMeansBetweenUnlikeGrains) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  for (int i = 0; i < 24; ++i) request.diameters.push_back(i < 4 ? 8.0 : 1.0);
  const Tessellation<3> tessellation(random_sites<3>(request));
  const FilmProblem<3> problem = {.tessellation = tessellation,
                                  .thickness = film_thickness(tessellation, 0.93),
                                  .grain = hmx,
                                  .elements = {.divisions = 1}};
  const auto [fields, modulus] = elastic_fields(problem, {test::binder_bulk, 1e6}, Load::shear);
  const auto means = means_of(fields, tessellation.side());
  EXPECT_NEAR(means.volume, 1.0, 1e-12);
  EXPECT_NEAR(means.strain[5], 0.5, 1e-12);
  EXPECT_NEAR(means.strain[0], 0.0, 1e-12);
  EXPECT_NEAR(stress_under(Load::shear, means.stress) / modulus, 1.0, 1e-9);
  EXPECT_NEAR(means.work / modulus, 1.0, 1e-9);
}

}  // namespace
}  // namespace breccia::films
