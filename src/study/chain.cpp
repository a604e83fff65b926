#include "study/chain.hpp"

#include <algorithm>

#include "study/expansion_rules.hpp"

namespace breccia {
namespace {

void add_once(std::vector<Load>& loads, Load load) {
  if (std::ranges::find(loads, load) == loads.end()) loads.push_back(load);
}

}  // namespace

const Stage* stage_of_matrix(const Study& study, const Stage& stage) {
  const auto* earlier = std::get_if<EarlierStage>(&stage.matrix);
  return earlier == nullptr ? nullptr : &*std::ranges::find(study.stages, earlier->name, &Stage::name);
}

const Material& binder_of(const Study& study, const Stage& stage) {
  const auto* const below = stage_of_matrix(study, stage);
  return below == nullptr ? std::get<Material>(stage.matrix) : binder_of(study, *below);
}

std::vector<Load> loads_of(const Study& study, const Stage& stage) {
  std::vector<Load> loads;
  const auto add = [&](const TestLoad& asked) {
    if (asked.is_isotropic()) {
      for (const auto shear : isotropic_shears(stage.dimensions())) add_once(loads, shear);
    } else {
      add_once(loads, *asked.of_test());
    }
  };
  std::ranges::for_each(study.tests.loads, add);
  const auto is_compared = [&](ModulusKind kind) {
    return std::ranges::any_of(study.measurements,
                               [&](const Measurement& one) { return one.stage == stage.name && one.kind == kind; });
  };
  // In the plane the bulk modulus is a difference of those of both tests.
  const bool needs_both = serves_as_matrix(study.stages, stage.name) || is_compared(ModulusKind::young) ||
                          (is_compared(ModulusKind::bulk) && stage.dimensions() == 2);
  const bool expands = asks_for_expansion(study) && !obstacle_to_expansion(study, stage);
  if (needs_both) add(shear_of_material(study.tests));
  if (needs_both || expands || is_compared(ModulusKind::bulk)) add(Load::bulk);
  return loads;
}

std::vector<Load> solved_loads(const Study& study, const Stage& stage, Boundary boundary) {
  auto loads = loads_of(study, stage);
  if (!study.tests.whole_stiffness || boundary == Boundary::traction) return loads;
  for (const auto& pair : pairs_of_loads) {
    if (has_test_load(pair.both, stage.dimensions())) loads.push_back(pair.both);
  }
  return loads;
}

std::size_t most_solved_loads(const Study& study, const Stage& stage) {
  std::size_t most = 0;
  for (const auto boundary : study.tests.boundaries) {
    most = std::max(most, solved_loads(study, stage, boundary).size());
  }
  return most;
}

bool asks_for_isotropic(const Tests& tests) {
  return std::ranges::find(tests.loads, TestLoad::isotropic()) != tests.loads.end();
}

TestLoad shear_of_material(const Tests& tests) {
  return asks_for_isotropic(tests) ? TestLoad::isotropic() : TestLoad(Load::shear);
}

}  // namespace breccia
