#include "binder.hpp"

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

}  // namespace breccia
