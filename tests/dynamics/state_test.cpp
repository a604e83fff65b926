#include "checkpoint/state.hpp"

#include <cmath>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "dynamics/dynamic_solver.hpp"
#include "materials.hpp"
#include "temporary_directory.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

class DynamicState : public testing::TestWithParam<std::tuple<Formulation, Volumetric, Boundary>> {
 protected:
  [[nodiscard]] static std::unique_ptr<DynamicSolver<2>> solver(int threads, int cells = 12) {
    const auto& [formulation, volumetric, boundary] = GetParam();
    DynamicProblem<2> problem{testing_materials::disc_in_box(cells),
                              {testing_materials::relaxing, testing_materials::stiff}};
    problem.volumetric = volumetric;
    problem.boundary = boundary;
    problem.load = {.xy = 0.5};
    problem.traction = {.xy = 1.0};
    problem.time_step = 0.5 * stable_time_step(problem.discretisation, problem.materials, volumetric, 1.0);
    problem.ramp = StrainRamp(100 * problem.time_step);
    return make_dynamic_solver(formulation, std::move(problem), threads);
  }

  test::TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "state.h5";
};

TEST_P(DynamicState, GoesOnWithTheSameBitsFromEveryPhase) {
  // During the ramp and after it.
  for (const int steps : {1, 60, 250}) {
    const auto whole = solver(1), first = solver(1), second = solver(2);
    std::vector<Averages<2>> expected, found, before;
    whole->advance(steps, before);
    whole->advance(80, expected);
    first->advance(steps, before);
    StateWriter writer(path_, {"deck", "version"});
    first->save(writer, "/solver");
    writer.commit();
    second->restore(StateReader(path_), "/solver");
    second->advance(80, found);
    EXPECT_EQ(found, expected) << steps;
    EXPECT_EQ(second->steps_taken(), whole->steps_taken());
    EXPECT_EQ(second->fields().stress, whole->fields().stress);
  }
}

TEST_P(DynamicState, OfAnotherGridIsRefused) {
  const auto coarse = solver(1, 8);
  StateWriter writer(path_, {"deck", "version"});
  coarse->save(writer, "/solver");
  writer.commit();
  EXPECT_THROW(solver(1)->restore(StateReader(path_), "/solver"), FileError);
}

/// The lists of points in the state of a classical run.
struct PointLists {
  std::vector<double> numbers, indices, cells, history;
};

void write(StateWriter& state, const PointLists& lists) {
  state.write("/solver/points", lists.numbers);
  state.write("/solver/places", lists.indices);
  state.write("/solver/cells", lists.cells);
  state.write("/solver/history", lists.history);
}

class ClassicalState : public DynamicState {};

TEST_P(ClassicalState, OfPointsThatCannotBeIsRefused) {
  StateWriter writer(path_, {"deck", "version"});
  solver(1)->save(writer, "/solver");
  writer.commit();
  const StateReader sound(path_);
  const auto read = [&](const char* name) { return sound.numbers(name); };
  const PointLists lists = {read("/solver/points"), read("/solver/places"), read("/solver/cells"),
                            read("/solver/history")};
  const auto step = sound.integer("/solver/step");
  const auto is_taken = [&](const PointLists& changed) {
    const auto path = directory_.path() / "changed.h5";
    StateWriter changing(path, {"deck", "version"});
    changing.write("/solver/step", step);
    write(changing, changed);
    changing.commit();
    try {
      solver(1)->restore(StateReader(path), "/solver");
    } catch (const FileError&) {
      return false;
    }
    return true;
  };
  EXPECT_TRUE(is_taken(lists));
  for (const double cell : {-1.0, 144.0, 1e12, 0.5, std::nan("")}) {
    auto changed = lists;
    changed.cells[3] = cell;
    EXPECT_FALSE(is_taken(changed)) << "cell " << cell;
  }
  for (const double index : {lists.indices[1], -1.0, 0.5, 1e18}) {
    auto changed = lists;
    changed.indices[0] = index;
    EXPECT_FALSE(is_taken(changed)) << "index " << index;
  }
}

TEST_P(DynamicState, OfCubesGoesOnWithTheSameBits) {
  const auto& [formulation, volumetric, boundary] = GetParam();
  DynamicProblem<3> problem{testing_materials::sphere_in_box(5),
                            {testing_materials::relaxing, testing_materials::stiff}};
  problem.volumetric = volumetric;
  problem.boundary = boundary;
  problem.load = {.yz = 0.5};
  problem.traction = {.yz = 1.0};
  problem = testing_materials::with_step(problem, 0.5);
  problem.ramp = StrainRamp(40 * problem.time_step);
  const auto whole = make_dynamic_solver(formulation, problem, 1), first = make_dynamic_solver(formulation, problem, 1),
             second = make_dynamic_solver(formulation, problem, 1);
  std::vector<Averages<3>> expected, found, before;
  whole->advance(25, before);
  whole->advance(25, expected);
  first->advance(25, before);
  StateWriter writer(path_, {"deck", "version"});
  first->save(writer, "/solver");
  writer.commit();
  second->restore(StateReader(path_), "/solver");
  second->advance(25, found);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(second->fields().stress, whole->fields().stress);
  EXPECT_THROW(solver(1)->restore(StateReader(path_), "/solver"), FileError);
}

constexpr auto with = [](auto formulations) {
  return testing::Combine(formulations, testing::Values(Volumetric::averaged, Volumetric::standard),
                          testing::Values(Boundary::displacement, Boundary::traction, Boundary::periodic));
};
INSTANTIATE_TEST_SUITE_P(All, DynamicState,
                         with(testing::Values(Formulation::total_lagrangian, Formulation::classical)), test::by_words);
INSTANTIATE_TEST_SUITE_P(All, ClassicalState, with(testing::Values(Formulation::classical)), test::by_words);

}  // namespace
}  // namespace breccia
