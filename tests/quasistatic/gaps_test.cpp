// Tests of composites with gaps narrower than a cell, against conforming finite elements (tests/reference).

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/composites.hpp"
#include "quasistatic/disc_packings.hpp"
#include "quasistatic/mean_fields.hpp"
#include "quasistatic/reduced/carson_path.hpp"
#include "quasistatic/square_array.hpp"
#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia {
namespace {

constexpr std::array<Vector<2>, 3> positions = {{{0.0, 0.0}, {0.5, 0.5}, {0.37, 0.71}}};

/// A load and the name that it has in the table of the packings.
struct NamedLoad {
  Load load;
  const char* name;
};
constexpr std::array<NamedLoad, 3> loads = {
    {{Load::diagonal_shear, "xx-yy"}, {Load::shear, "xy"}, {Load::bulk, "bulk"}}};

/// The modulus of a packing of rigid discs, over the shear modulus of the binder.
double known_modulus(const std::string& packing, const std::string& bulk_ratio, const std::string& load) {
  const auto table =
      read_csv(BRECCIA_REFERENCE_DIRECTORY "/disc_packings/moduli.csv", {"packing", "K_over_g", "Gf_over_g", "load"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("packing")[row] == packing && table.text("K_over_g")[row] == bulk_ratio &&
        table.text("Gf_over_g")[row] == "inf" && table.text("load")[row] == load) {
      return table.numbers("modulus")[row];
    }
  }
  throw std::out_of_range("no such packing: " + packing);
}

class Packings : public testing::TestWithParam<const char*> {};

// Gaps of 0.2 to 0.5 % of a diameter are a twentieth of a cell.
TEST_P(Packings, OfDiscsHaveTheModuliOfConformingElements) {
  const std::string packing = GetParam();
  const auto box = test::disc_packing(packing);
  const double smallest = std::ranges::min_element(box.particles, {}, &Disc::diameter)->diameter;
  const auto cells = static_cast<int>(std::lround(12.0 / smallest));
  constexpr double bulk_ratio = 1e6, rigid = 1e9;
  const auto problem = test::with_gaps(test::moved(box, {0.37, 0.71}, cells), cells, bulk_ratio, rigid);
  for (const auto& [load, name] : loads) {
    EXPECT_NEAR(test::modulus_of(problem, load) / known_modulus(packing, "1e+06", name), 1.0, 0.015) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Random, Packings,
                         testing::Values("equal_57_040_g040.csv", "ratio2.3_66_040_g030.csv", "ratio3_67_040_g020.csv",
                                         "equal_75_040_g050.csv"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase_if(name, [](char c) { return c == '.' || c == '_'; });
                           return name.substr(0, name.size() - 3);
                         });

// A gap in a row of cells, on a row of nodes, and between both.
TEST(SquareArrays, WithNarrowGapsAreRightAtAnyPositionOfTheGrid) {
  for (const auto* packing :
       {"square_g010.csv", "square_g030.csv", "square_g100.csv", "square27_g030.csv", "square45_g030.csv"}) {
    const auto box = test::disc_packing(packing);
    const auto cells = static_cast<int>(std::lround(16.0 / box.particles.front().diameter));
    for (const auto& position : positions) {
      const auto problem = test::with_gaps(test::moved(box, position, cells), cells, 1e6, 1e7);
      for (const auto& [load, name] : {loads[0], loads[1]}) {
        EXPECT_NEAR(test::modulus_of(problem, load) / known_modulus(packing, "1e+06", name), 1.0, 0.025)
            << packing << ' ' << name << " at " << position[0];
      }
    }
  }
}

TEST(SquareArrays, WithWideGapsAreWithinPercent) {
  std::vector<double> errors;
  constexpr int cells = 16;
  for (const auto& array : test::periodic_square_arrays("elastic_square_array.csv")) {
    const Microstructure<2> box = {
        1.0, Walls::periodic, {{{0.5, 0.5}, 2.0 * std::sqrt(array.fraction / std::numbers::pi)}}};
    const auto problem =
        test::with_gaps(test::moved(box, positions[2], cells), cells, array.bulk_ratio, array.contrast);
    errors.push_back(std::abs(test::modulus_of(problem, array.load) / array.modulus - 1.0));
  }
  std::ranges::sort(errors);
  ASSERT_EQ(errors.size(), 90U);
  EXPECT_LT(errors[45], 0.004);
  EXPECT_LT(errors.back(), 0.04);
}

// Blocks with faces inside and on their sides.
TEST(Gaps, OfTheIterativeSolverAreThoseOfTheDirectOne) {
  for (const double bulk_ratio : {3.0, 1e3, 1e6}) {
    auto problem = test::with_gaps(test::disc_packing("ratio2.3_66_040_g030.csv"), 77, bulk_ratio, 10.0 * bulk_ratio);
    problem.linear.method = LinearMethod::direct;
    auto iterative = problem;
    iterative.linear.method = LinearMethod::iterative;
    for (const auto load : {Load::shear, Load::bulk}) {
      EXPECT_NEAR(test::modulus_of(iterative, load) / test::modulus_of(problem, load), 1.0, 1e-5) << bulk_ratio;
    }
  }
}

TEST(Gaps, OfABoxThatIsMovedByWholeCellsAreTheSame) {
  const auto box = test::disc_packing("equal_57_040_g040.csv");
  constexpr int cells = 60;
  const auto here = test::with_gaps(box, cells, 1e3, 1e3),
             there = test::with_gaps(test::moved(box, {7.0, 31.0}, cells), cells, 1e3, 1e3);
  EXPECT_NEAR(test::modulus_of(here, Load::shear) / test::modulus_of(there, Load::shear), 1.0, 1e-6);
}

// Particles that are not stiffer have no gaps. Where they hardly are, the stiffness of the particles that ties slopes
// counts twice.
TEST(Gaps, WithoutContrastMatterLittle) {
  const auto box = test::disc_packing("equal_57_040_g040.csv");
  for (const double contrast : {0.5, 1.0 + 1e-9}) {
    auto problem = test::with_gaps(box, 60, 10.0, contrast);
    for (auto& material : problem.materials) material.bulk = PronySeries(10.0);
    auto without = problem;
    without.discretisation.set_particles_with_gaps(nullptr);
    EXPECT_NEAR(test::modulus_of(problem, Load::shear) / test::modulus_of(without, Load::shear), 1.0,
                contrast < 1.0 ? 0.0 : 0.03);
  }
}

/// Discs with narrow gaps in a binder that relaxes from a glass to a rubber.
QuasistaticProblem<2> relaxing() {
  auto problem = test::with_gaps(test::disc_packing("equal_57_040_g040.csv"), 36, 10.0, 100.0);
  problem.materials = test::random_composite(4, 1, Boundary::periodic).materials;
  return problem;
}

TEST(Gaps, InAReducedResponseAreThoseOfSingleElasticSolutions) {
  const auto problem = relaxing();
  const auto path = carson_path(problem.materials.front(), test::relaxation_window);
  const auto responses =
      sample_responses(problem, test::shear_and_bulk, matrix_path(0, path), {.tolerance = 1e-6}).responses;
  for (std::size_t i = 0; i < path.size(); i += 8) {
    const auto exact = sample_responses(problem, test::shear_and_bulk, matrix_path(0, std::array{path[i]})).responses;
    for (std::size_t l = 0; l < 2; ++l) {
      EXPECT_NEAR(responses[l].modulus(path[i]) / exact[l].modulus(path[i]), 1.0, 2e-6) << path[i].shear;
    }
  }
}

TEST(Gaps, InAReducedResponseInTimeAgreeWithStepping) {
  const auto problem = relaxing();
  const auto path = carson_path(problem.materials.front(), test::relaxation_window);
  const auto responses =
      sample_responses(problem, test::shear_and_bulk, matrix_path(0, path), {.tolerance = 1e-6}).responses;
  const auto times = test::logarithmic(1e-3 * test::relaxation_window.begin, test::relaxation_window.end, 30);
  const auto steps = run_log_time_stepping(problem, test::shear_and_bulk, times).responses;
  for (std::size_t l = 0; l < 2; ++l) {
    const auto modulus = relaxation_modulus(creep_compliance(responses[l], problem.materials.front()));
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < test::relaxation_window.begin) continue;
      EXPECT_NEAR(steps[l].values[i] / modulus.at(times[i]), 1.0, 2e-3) << times[i] << " s";
    }
  }
}

/// Three discs between walls, with narrow gaps, in a binder that relaxes.
QuasistaticProblem<2> between_walls(Boundary boundary) {
  const Microstructure<2> box = {1.0, Walls::hard, {{{0.253, 0.253}, 0.5}, {{0.747, 0.3}, 0.48}, {{0.5, 0.745}, 0.5}}};
  auto problem = test::with_gaps(box, 24, 10.0, 100.0);
  problem.boundary = boundary;
  problem.materials = test::random_composite(4, 1, Boundary::periodic).materials;
  return problem;
}

TEST(Gaps, BetweenWallsAreTheSameByBothSolvers) {
  for (const auto boundary : {Boundary::displacement, Boundary::traction}) {
    auto direct = between_walls(boundary);
    direct.linear.method = LinearMethod::direct;
    auto iterative = direct;
    iterative.linear = {.method = LinearMethod::iterative, .tolerance = 1e-9};
    for (const auto load : {Load::shear, Load::bulk}) {
      EXPECT_NEAR(test::modulus_of(iterative, load) / test::modulus_of(direct, load), 1.0, 1e-6) << name_of(boundary);
    }
  }
}

// Under tractions the layer between a side and the disc beside it decides.
TEST(Gaps, BetweenWallsAreWithinPercent) {
  const auto table = read_csv(BRECCIA_REFERENCE_DIRECTORY "/disc_packings/moduli_walls.csv",
                              {"packing", "boundary", "Gf_over_g", "load"});
  const std::map<std::string, int> cells = {{"walls_one_g030.csv", 13}, {"walls_four_g100.csv", 25}};
  int found = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto n = cells.find(table.text("packing")[row]);
    if (n == cells.end() || table.text("Gf_over_g")[row] != "inf" || table.numbers("K_over_g")[row] != 1e6) continue;
    auto problem = test::with_gaps(test::disc_packing_between_walls(n->first), n->second, 1e6, 1e9);
    const bool is_held = table.text("boundary")[row] == "displacement";
    problem.boundary = is_held ? Boundary::displacement : Boundary::traction;
    const auto load = std::ranges::find(loads, table.text("load")[row], &NamedLoad::name);
    const double modulus = test::modulus_of(problem, load->load);
    EXPECT_NEAR(modulus / table.numbers("modulus")[row], 1.0, is_held ? 0.01 : 0.05) << n->first << ", row " << row;
    ++found;
  }
  EXPECT_EQ(found, 12);
}

// The mean stress is conjugate to a uniform strain of the nodes and of the slopes, and flow through faces, which takes
// volume from one cell to its neighbour, leaves the mean strain.
TEST(Gaps, HaveFieldsThatAverageToTheCurve) {
  for (const auto boundary : test::boundaries) {
    const auto problem = boundary == Boundary::periodic ? relaxing() : between_walls(boundary);
    const auto& binder = problem.materials.front();
    for (const auto load : {Load::shear, Load::diagonal_shear, Load::bulk}) {
      const auto found =
          sample_responses(problem, std::array{load}, matrix_path(0, carson_path(binder, test::relaxation_window)));
      const auto compliance = creep_compliance(found.responses[0], binder);
      const double time = 1e-4;
      const auto fields = found.fields(0, std::array{binder}, time);
      const double stress = modulus_of(load, test::mean_stress(fields)),
                   strain = compliance_of(load, test::mean_strain(fields));
      const bool creeps = boundary == Boundary::traction;
      SCOPED_TRACE(testing::Message() << name_of(boundary) << ", " << name_of(load));
      EXPECT_NEAR(creeps ? stress : stress / relaxation_modulus(compliance).at(time), 1.0, 1e-9);
      EXPECT_NEAR(creeps ? strain / compliance.at(time) : strain, 1.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace breccia
