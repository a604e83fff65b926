#include "study/chain.hpp"

#include <algorithm>

namespace breccia {

const Stage* stage_of_matrix(const Study& study, const Stage& stage) {
  const auto* earlier = std::get_if<EarlierStage>(&stage.matrix);
  return earlier == nullptr ? nullptr : &*std::ranges::find(study.stages, earlier->name, &Stage::name);
}

const Material& binder_of(const Study& study, const Stage& stage) {
  const auto* const below = stage_of_matrix(study, stage);
  return below == nullptr ? std::get<Material>(stage.matrix) : binder_of(study, *below);
}

std::vector<Load> loads_of(const Study& study, const Stage& stage) {
  auto loads = study.tests.loads;
  if (!serves_as_matrix(study.stages, stage.name)) return loads;
  for (const auto load : {Load::shear, Load::bulk}) {
    if (std::ranges::find(loads, load) == loads.end()) loads.push_back(load);
  }
  return loads;
}

}  // namespace breccia
