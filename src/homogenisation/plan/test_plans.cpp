#include "homogenisation/plan/test_plans.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "homogenisation/plan/cell_memory.hpp"
#include "homogenisation/plan/cell_time.hpp"
#include "homogenisation/plan/film_costs.hpp"
#include "homogenisation/plan/measured_costs.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "study/chain.hpp"

namespace breccia {
namespace {

/// Passes every dynamic test of a stage, on a grid that may be coarser than that of the study, to an action.
template <int dim, class Action>
void for_each_dynamic_test(const Study& study, const Stage& stage, const Discretisation<dim>& discretisation,
                           const Action& action) {
  const auto matrix = expected_matrix(study, stage);
  for (const auto boundary : study.tests.boundaries) {
    for (const auto load : loads_of(study, stage)) {
      action(make_dynamic_test(study, stage, matrix, discretisation, boundary, load, 0));
    }
  }
}

template <int dim>
double refinement_of(const DynamicTest<dim>& test, int cells) {
  return static_cast<double>(cells) / test.discretisation.grid().cells[0];
}

template <int dim>
double memory_of(const DynamicTest<dim>& test, int cells) {
  return measured_costs::program + dynamic_memory(test, refinement_of(test, cells));
}

template <int dim>
double memory_of_dynamic_tests(const Study& study, const Stage& stage, int cells) {
  // Neither the positions of the particles nor the grid matter.
  constexpr int few = 2;
  double most = 0.0;
  for_each_dynamic_test(study, stage,
                        discretise(stage, Microstructure<dim>{stage.side, Walls::hard, {}}, few, study.tests.mixing),
                        [&](const DynamicTest<dim>& test) { most = std::max(most, memory_of(test, cells)); });
  return most;
}

template <int dim>
TestPlan plan_of_dynamic_test(const Stage& stage, const DynamicTest<dim>& test, int cells) {
  const auto points = static_cast<double>(point_count(stage, cells));
  TestPlan plan = {.method = Method::dynamic,
                   .boundary = test.boundary,
                   .load = test.load,
                   .size = cells_in_words(stage, cells) + " cells",
                   .unknowns = points,
                   .bytes = memory_of(test, cells),
                   .domains = plan_dynamic_test(test, refinement_of(test, cells)),
                   .speed = trial_speed(test)};
  std::int64_t steps = 0;
  for (const auto& domain : plan.domains) steps += domain.steps;
  plan.seconds = points * static_cast<double>(steps) / plan.speed;
  return plan;
}

}  // namespace

TestPlan plan_of_quasistatic_test(const Study& study, const Stage& stage, Boundary boundary, int cells) {
  return {.boundary = boundary,
          .size = cells_in_words(stage, cells) + " cells",
          .unknowns = quasistatic_unknowns(study, stage, cells),
          .seconds = quasistatic_time(study, stage, boundary, cells),
          .bytes = quasistatic_memory(study, stage, cells)};
}

TestPlan plan_of_film_test(const Study& study, const Stage& stage, Boundary boundary, const GrainStatistics& grains) {
  const auto placed = placed_grains(stage, grains);
  return {.boundary = boundary,
          .size = fmt::format("{} grains and films", grains.count),
          .unknowns = film_unknowns(study.tests, placed),
          .seconds = film_time(study, stage, placed),
          .bytes = film_memory(study, stage, placed)};
}

std::vector<TestPlan> plans_of_dynamic_tests(const Study& study, const Stage& stage, const StageMicrostructure& packed,
                                             int cells) {
  // The largest grid that is really set up, which takes some 20 MB a Prony term. A finer grid is planned by means of
  // it, since its own points would take long, and more memory than there may be.
  const int most_planned = stage.dimensions() == 3 ? 48 : 1000;
  std::vector<TestPlan> plans;
  const auto add_plans = [&]<int dim>(const Discretisation<dim>& discretisation) {
    for_each_dynamic_test(study, stage, discretisation, [&](const DynamicTest<dim>& test) {
      plans.push_back(plan_of_dynamic_test(stage, test, cells));
    });
  };
  std::visit(add_plans, discretise(stage, packed, std::min(cells, most_planned), study.tests.mixing));
  return plans;
}

double memory_of_dynamic_tests(const Study& study, const Stage& stage, int cells) {
  return stage.dimensions() == 3 ? memory_of_dynamic_tests<3>(study, stage, cells)
                                 : memory_of_dynamic_tests<2>(study, stage, cells);
}

}  // namespace breccia
