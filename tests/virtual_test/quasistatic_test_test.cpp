#include "virtual_test/quasistatic_test.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"
#include "virtual_test/composites.hpp"
#include "virtual_test/quasistatic_test_state.hpp"

namespace breccia {
namespace {

namespace composites = testing_composites;

QuasistaticTest one_particle(PhaseIndex matrix, PhaseIndex filler) {
  QuasistaticTest test = {.composite = discretise<2>({6e-3, Walls::hard, {{{2e-3, 3e-3}, 3e-3}}}, 12, matrix, filler),
                          .materials = {composites::binder, composites::binder},
                          .varying = {{matrix, "matrix"}},
                          .loads = {Load::shear, Load::bulk},
                          .times = {1e-3, 0.1},
                          .points_per_decade = 4};
  test.materials[filler] = composites::particle;
  return test;
}

TEST(RunQuasistaticTest, AnyPhaseMayBeTheMatrix) {
  const auto first = run_quasistatic_test(one_particle(0, 1)), second = run_quasistatic_test(one_particle(1, 0));
  for (std::size_t load = 0; load < first.responses.size(); ++load) {
    const auto &one = first.responses[load].modulus, &other = second.responses[load].modulus;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i].modulus / other[i].modulus, 1.0, 1e-7) << i;
  }
}

TEST(QuasistaticTestState, WithANumberThatIsNoLoadIsRefused) {
  const test::TemporaryDirectory directory;
  const auto read_with = [&](Load load) {
    QuasistaticTestResult result;
    result.responses.emplace_back().load = load;
    const auto path = directory.path() / "result.h5";
    StateWriter writer(path, {"deck", "version"});
    save_result(writer, result);
    writer.commit();
    return read_quasistatic_result(StateReader(path)).responses.front().load;
  };
  EXPECT_EQ(read_with(Load::bulk), Load::bulk);
  EXPECT_EQ(read_with(Load::axial_shear), Load::axial_shear);
  EXPECT_EQ(read_with(Load::shear_and_bulk), Load::shear_and_bulk);
  EXPECT_EQ(read_with(Load::shear_zx_and_axial_shear), Load::shear_zx_and_axial_shear);
  EXPECT_THROW(read_with(static_cast<Load>(22)), FileError);
}

TEST(RunQuasistaticTest, TheReducedSolverMustKnowTheMatrix) {
  auto test = one_particle(0, 1);
  test.varying = {{no_phase, "matrix"}};
  EXPECT_EQ(test::message_of<InputError>([&] { static_cast<void>(run_quasistatic_test(test)); }),
            "quasi-static test: expected one of the 2 phases as the matrix, got number 65535");
  test.varying.clear();
  EXPECT_THROW(static_cast<void>(run_quasistatic_test(test)), InputError);
  test.varying = {{2, "matrix"}};
  EXPECT_THROW(static_cast<void>(run_quasistatic_test(test)), InputError);
  // The particle is the phase that varies, so the binder relaxes without varying.
  test.varying = {{1, "matrix"}};
  EXPECT_THROW(static_cast<void>(run_quasistatic_test(test)), InputError);
  test.varying = {{no_phase, "matrix"}};
  test.options.solver = Solver::stepping;
  EXPECT_NO_THROW(static_cast<void>(run_quasistatic_test(test)));
}

// Elastic grains between films of the binder. The mean stress over the fields is the modulus.
TEST(RunQuasistaticTest, BothSolversAgreeOnGrainsAndFilms) {
  LaguerreSites<2> sites;
  sites.side = 6e-3;
  for (const auto& place :
       {Vector<2>{0.8e-3, 1.1e-3}, {3.9e-3, 1.4e-3}, {2.2e-3, 3.2e-3}, {5.2e-3, 4.1e-3}, {1.9e-3, 5.3e-3}}) {
    sites.sites.push_back({place, 0.0});
  }
  const auto& particle = composites::particle;
  QuasistaticTest test = {
      .composite = FilmProblem<2>{.tessellation = Tessellation<2>(sites),
                                  .thickness = 0.1e-3,
                                  .grain = {.bulk = particle.bulk.unrelaxed(), .shear = particle.shear.unrelaxed()}},
      .materials = {composites::binder, particle},
      .varying = {{0, "matrix"}},
      .boundary = Boundary::periodic,
      .loads = {Load::shear, Load::bulk},
      .times = {1e-3, 0.1},
      .points_per_decade = 4,
      .field_times = {1e-2, 0.1}};
  const auto reduced = run_quasistatic_test(test);
  test.options.solver = Solver::stepping;
  const auto stepped = run_quasistatic_test(test);
  for (const auto* result : {&reduced, &stepped}) {
    EXPECT_EQ(times_of(result->fields), test.field_times);
    for (const auto& [time, fields] : std::get<NetworkFields<2>>(result->fields).at_times) {
      double stress = 0.0, area = 0.0;
      for (const auto& cell : fields.cells) {
        stress += cell.content * cell.stress[3];
        area += cell.content;
      }
      const auto at = std::ranges::find_if(result->responses.front().modulus, [wanted = time](const Sample& one) {
        return std::abs(one.time / wanted - 1.0) < 1e-9;
      });
      ASSERT_NE(at, result->responses.front().modulus.end());
      EXPECT_NEAR(stress / area / at->modulus, 1.0, 1e-7);
    }
  }
  for (std::size_t load = 0; load < test.loads.size(); ++load) {
    const auto &one = reduced.responses[load].modulus, &other = stepped.responses[load].modulus;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i].modulus / other[i].modulus, 1.0, 1e-3) << i;
  }
}

// The binder flows, and the particle relaxes in shear and in volume.
TEST(RunQuasistaticTest, BothSolversAgreeWhereTheParticleRelaxesToo) {
  auto reduced = one_particle(0, 1);
  reduced.varying = {{0, "matrix"}, {1, "filler"}};
  reduced.materials[1].shear = PronySeries(2e6, {{5e-3, 5e6}, {0.2, 1e7}});
  reduced.materials[1].bulk = PronySeries(1e7, {{2e-2, 4e7}});
  auto stepped = reduced;
  stepped.options.solver = Solver::stepping;
  stepped.options.steps_per_decade = 80;
  const auto one = run_quasistatic_test(reduced), other = run_quasistatic_test(stepped);
  for (std::size_t load = 0; load < one.responses.size(); ++load) {
    const auto &exact = one.responses[load].modulus, &steps = other.responses[load].modulus;
    ASSERT_EQ(exact.size(), steps.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_NEAR(exact[i].modulus / steps[i].modulus, 1.0, 1e-3) << exact[i].time;
    }
  }
}

TEST(RunQuasistaticTest, RefusesAnIncompleteTest) {
  for (const auto solver : {Solver::reduced, Solver::stepping}) {
    auto test = one_particle(0, 1);
    test.options.solver = solver;
    for (const int per_decade : {0, -1}) {
      test.points_per_decade = per_decade;
      EXPECT_THROW(static_cast<void>(run_quasistatic_test(test)), InputError) << per_decade << " points per decade";
    }
    test.points_per_decade = 4;
    test.materials.pop_back();
    EXPECT_THROW(static_cast<void>(run_quasistatic_test(test)), InputError) << "the particle has no material";
  }
}

}  // namespace
}  // namespace breccia
