#include "breccia/films/film_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "films/elastic_state.hpp"
#include "films/fields/film_recovery.hpp"
#include "films/film_sampling.hpp"
#include "films/grains_and_films.hpp"
#include "quasistatic/reduced/carson_path.hpp"

namespace breccia::films {
namespace {

using test::all_boundaries;
using test::all_loads;

/// Means of the fields over the box.
struct Means {
  double area = 0.0, work = 0.0;
  Stress<2> stress;
  Strain<2> strain;
};

Means means_of(const FilmFields<2>& fields) {
  Means means;
  for (const auto& cell : fields.cells) {
    means.area += cell.content;
    means.work += cell.content * cell.work;
    means.stress.xx += cell.content * cell.stress[0];
    means.stress.yy += cell.content * cell.stress[1];
    means.stress.xy += cell.content * cell.stress[3];
    means.strain.xx += cell.content * cell.strain[0];
    means.strain.yy += cell.content * cell.strain[1];
    means.strain.xy += cell.content * cell.strain[2];
  }
  return means;
}

/// Fields with an elastic binder.
FilmFields<2> elastic_fields(const FilmProblem<2>& problem, const Moduli& binder, Load load) {
  const FilmComposite<2> composite(problem);
  return FilmRecovery<2>(composite, problem).fields(load, test::elastic_state(composite, binder, load));
}

// If the binder has the moduli of the grains, the box is homogeneous: stress and strain are uniform, in periodic boxes
// and under displacements to rounding.
TEST(FilmFields, OfOneMaterialAreUniform) {
  for (const auto boundary : {Boundary::periodic, Boundary::displacement}) {
    for (const auto load : all_loads) {
      const auto strain = unit_strain<2>(load);
      const double bulk_stress = test::hmx.bulk * (strain.xx + strain.yy);
      for (const auto& cell : elastic_fields(test::voronoi_problem(boundary), test::hmx, load).cells) {
        const double modulus = test::modulus_of(test::hmx, load);
        EXPECT_NEAR(cell.strain[0], strain.xx, 1e-9);
        EXPECT_NEAR(cell.strain[1], strain.yy, 1e-9);
        EXPECT_NEAR(cell.strain[2], strain.xy, 1e-9);
        const double mean = (cell.stress[0] + cell.stress[1] + cell.stress[2]) / 3.0;
        EXPECT_NEAR(mean / modulus, bulk_stress / modulus, 1e-9);
        EXPECT_NEAR(cell.stress[3] / modulus, 2.0 * test::hmx.shear * strain.xy / modulus, 1e-9);
        EXPECT_NEAR((cell.stress[0] - cell.stress[1]) / modulus,
                    2.0 * test::hmx.shear * (strain.xx - strain.yy) / modulus, 1e-9);
        EXPECT_NEAR(cell.work / modulus, 1.0, 1e-9);
        EXPECT_NEAR(cell.flow, 0.0, 1e-9);
      }
    }
  }
}

// All components of the mean over the box are those that the boundary prescribes, for any binder.
TEST(FilmFields, HaveTheMeansOfTheirLoads) {
  for (const auto boundary : all_boundaries) {
    for (const auto load : all_loads) {
      const auto means = means_of(elastic_fields(test::voronoi_problem(boundary), {test::binder_bulk, 1e6}, load));
      const auto strain = unit_strain<2>(load);
      const auto stress = unit_stress<2>(load);
      if (boundary == Boundary::traction) {
        EXPECT_NEAR(means.stress.xx, stress.xx, 1e-9);
        EXPECT_NEAR(means.stress.yy, stress.yy, 1e-9);
        EXPECT_NEAR(means.stress.xy, stress.xy, 1e-9);
      } else {
        EXPECT_NEAR(means.strain.xx, strain.xx, 1e-12);
        EXPECT_NEAR(means.strain.yy, strain.yy, 1e-12);
        EXPECT_NEAR(means.strain.xy, strain.xy, 1e-12);
      }
    }
  }
}

// The cells tile the box. In time the mean stress is the modulus, the mean strain the compliance, and the mean work
// both (Hill).
TEST(FilmFields, HaveTheMeansOfTheCurves) {
  const auto material = test::relaxing_binder();
  const auto path = carson_path(material, {1e-7, 1e1});
  for (const auto boundary : all_boundaries) {
    const auto sampled = sample_film_responses(test::voronoi_problem(boundary), all_loads, path);
    for (std::size_t l = 0; l < all_loads.size(); ++l) {
      const auto load = all_loads[l];
      const auto compliance = creep_compliance(sampled.responses[l], material);
      const auto modulus = relaxation_modulus(compliance);
      for (const double time : {1e-7, 1e-4, 1e-1, 1e1}) {
        SCOPED_TRACE(std::string(name_of(boundary)) + " " + std::string(name_of(load)) + " " + std::to_string(time));
        const auto means = means_of(sampled.fields(l, std::array{material}, time));
        EXPECT_NEAR(means.area, 1.0, 1e-12);
        const bool is_creep = boundary == Boundary::traction;
        const double expected = is_creep ? compliance.at(time) : modulus.at(time);
        EXPECT_NEAR(means.work / expected, 1.0, 1e-9);
        const double response =
            is_creep ? compliance_of<2>(load, means.strain) : breccia::modulus_of<2>(load, means.stress);
        EXPECT_NEAR(response / expected, 1.0, 1e-9);
        const double prescribed =
            is_creep ? breccia::modulus_of<2>(load, means.stress) : compliance_of<2>(load, means.strain);
        EXPECT_NEAR(prescribed, 1.0, 1e-9);
      }
    }
  }
}

TEST(FilmFields, OfFilmsOnSpringsHaveTheMeansOfTheCurves) {
  auto problem = test::voronoi_problem();
  problem.debonded = {
      .kind = Debonding::spring, .faces = random_faces(problem.tessellation, 0.5, 1).faces, .springs = {1e13, 3e12}};
  const auto material = test::relaxing_binder();
  const auto sampled = sample_film_responses(problem, all_loads, carson_path(material, {1e-7, 1e1}));
  for (std::size_t l = 0; l < all_loads.size(); ++l) {
    const auto modulus = relaxation_modulus(creep_compliance(sampled.responses[l], material));
    const auto strain = unit_strain<2>(all_loads[l]);
    for (const double time : {1e-7, 1e-4, 1e1}) {
      SCOPED_TRACE(std::string(name_of(all_loads[l])) + " " + std::to_string(time));
      const auto fields = sampled.fields(l, std::array{material}, time);
      EXPECT_TRUE(std::ranges::any_of(fields.cells, [](const auto& one) { return one.part == FilmPart::spring; }));
      const auto means = means_of(fields);
      EXPECT_NEAR(means.work / modulus.at(time), 1.0, 1e-9);
      EXPECT_NEAR(breccia::modulus_of<2>(all_loads[l], means.stress) / modulus.at(time), 1.0, 1e-9);
      EXPECT_NEAR(means.strain.xx, strain.xx, 1e-12);
      EXPECT_NEAR(means.strain.yy, strain.yy, 1e-12);
      EXPECT_NEAR(means.strain.xy, strain.xy, 1e-12);
    }
  }
}

// The displacements of films and grains agree where they meet.
TEST(FilmFields, AreContinuousInTheDisplacement) {
  const auto problem = test::voronoi_problem(Boundary::displacement);
  const auto fields = elastic_fields(problem, {test::binder_bulk, 1e6}, Load::shear);
  const double near = 1e-12;
  std::size_t met = 0;
  std::size_t first = 0;
  for (const auto& cell : fields.cells) {
    const auto corners = std::span(fields.corners).subspan(first, cell.corners);
    first += cell.corners;
    if (cell.part == FilmPart::grain) continue;
    for (const auto corner : corners) {
      for (std::size_t other = 0; other < corner; ++other) {
        const auto& here = fields.points[corner];
        const auto& there = fields.points[other];
        if (std::hypot(here[0] - there[0], here[1] - there[1]) > near) continue;
        ++met;
        EXPECT_NEAR(fields.displacement[corner][0], fields.displacement[other][0], 1e-12);
        EXPECT_NEAR(fields.displacement[corner][1], fields.displacement[other][1], 1e-12);
      }
    }
  }
  EXPECT_GT(met, 100U);
  EXPECT_EQ(first, fields.corners.size());
}

// With a soft binder nearly all of the strain is in films and junctions.
TEST(FilmFields, ShowWhereASoftBinderWorks) {
  const auto fields = elastic_fields(test::voronoi_problem(), {test::binder_bulk, 1e5}, Load::shear);
  double all = 0.0, in_binder = 0.0;
  for (const auto& cell : fields.cells) {
    EXPECT_GT(cell.work, 0.0);
    all += cell.content * cell.work;
    if (cell.part != FilmPart::grain) in_binder += cell.content * cell.work;
  }
  EXPECT_GT(in_binder / all, 0.9);
}

}  // namespace
}  // namespace breccia::films
