#include "breccia/homogenisation/stage_microstructure.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "checkpoint/checkpoint.hpp"
#include "homogenisation/box/explicit_packing.hpp"
#include "homogenisation/box/image_packing.hpp"
#include "homogenisation/box/laguerre_packing.hpp"
#include "homogenisation/box/lubachevsky_stillinger_packing.hpp"
#include "homogenisation/box/microstructure_measures.hpp"
#include "homogenisation/box/random_sequential_packing.hpp"
#include "homogenisation/box/regular_packing.hpp"
#include "homogenisation/box/stage_microstructure_state.hpp"
#include "homogenisation/run/named_errors.hpp"

namespace breccia {
namespace {

/// Fills a box by the method of its packing.
template <int dim>
PlacedBox<dim> place(const Stage& stage, const PackingMethod<dim>& packing, PackingRunner& runner) {
  if (stage.fillers.empty() && !stage.has_image()) return {Microstructure<dim>{stage.side, Walls::hard, {}}};
  return std::visit([&](const auto& method) { return placed(stage, method, runner); }, packing);
}

struct ParticlesIn {
  template <class Particles>
  std::size_t operator()(const Particles& box) const {
    return box.particles.size();
  }
  template <int dim>
  std::size_t operator()(const Grains<dim>& grains) const {
    return grains.statistics.count;
  }
  template <int dim>
  std::size_t operator()(const SharedImage<dim>&) const {
    return 0;
  }
};

struct StatisticsOfGrains {
  template <int dim>
  const GrainStatistics* operator()(const Grains<dim>& grains) const {
    return &grains.statistics;
  }
  template <class Content>
  const GrainStatistics* operator()(const Content&) const {
    return nullptr;
  }
};

}  // namespace

const GrainStatistics* StageMicrostructure::grains() const {
  return visit_nested(StatisticsOfGrains(), box);
}

std::size_t StageMicrostructure::particles() const {
  return visit_nested(ParticlesIn(), box);
}

double StageMicrostructure::mean_diameter() const {
  // A ball has the volume d/6 for each unit of its surface, a disc the area d/4 for each unit of its circumference.
  const double ratio = std::holds_alternative<Box<3>>(box) ? 6.0 : 4.0;
  return interface_per_area > 0.0 ? ratio * fraction / interface_per_area : std::numeric_limits<double>::infinity();
}

std::optional<double> StageMicrostructure::size_deviation() const {
  std::optional<double> largest;
  for (const auto& filler : fillers) largest = std::max(largest, filler.size_deviation);
  return largest;
}

StageMicrostructure make_microstructure(const Stage& stage, const ProgressObserver& follow, Checkpoint* checkpoint) {
  if (checkpoint != nullptr && checkpoint->is_finished())
    return read_stage_microstructure(*checkpoint->earlier(), stage);
  StageMicrostructure result;
  PackingRunner runner(stage, follow, checkpoint);
  const auto fill = [&](const auto& packing) {
    auto placed = place(stage, packing, runner);
    result.box = std::move(placed.box);
    for (const auto& deviation : placed.size_deviations) result.fillers.push_back({.size_deviation = deviation});
    result.events = placed.events;
  };
  name_errors(stage.name, [&] { std::visit(fill, stage.packing); });
  result.seconds = runner.seconds();
  if (checkpoint != nullptr) checkpoint->finish([&](StateWriter& state) { save(state, result); });
  measure(stage, result);
  return result;
}

}  // namespace breccia
