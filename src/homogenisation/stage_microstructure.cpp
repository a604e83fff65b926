#include "breccia/homogenisation/stage_microstructure.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_microstructure_state.hpp"
#include "breccia/microstructure/cubic_array.hpp"
#include "breccia/microstructure/particle_validity.hpp"
#include "breccia/microstructure/regular_array.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/study/coatings.hpp"
#include "breccia/study/filler_shapes.hpp"

#include "drawn_particles.hpp"
#include "microstructure_measures.hpp"
#include "named_errors.hpp"
#include "packed_grains.hpp"
#include "packing_advice.hpp"
#include "packing_state.hpp"
#include "sequential_packing.hpp"

namespace breccia {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // which clang 14 does not find by itself

/// Packs the particles of a stage, if it has a random packing, from the beginning or from the state of an earlier run,
/// and measures the time.
class StagePacking {
 public:
  StagePacking(const Stage& stage, const ProgressObserver& follow, Checkpoint* checkpoint)
      : stage_(stage),
        follow_(follow),
        checkpoint_(checkpoint),
        earlier_(checkpoint != nullptr ? checkpoint->earlier() : nullptr),
        seconds_before_(earlier_ != nullptr ? earlier_->number(packing_seconds_name) : 0.0) {}

  template <int dim>
  Packing<dim> run(const PackingRequest& request) {
    auto packing = earlier_ != nullptr ? go_on<dim>(request) : PackingRun<dim>(request);
    while (!packing.is_done()) {
      packing.advance();
      report(packing.progress());
      if (checkpoint_ == nullptr || !checkpoint_->is_due()) continue;
      checkpoint_->save([&](StateWriter& state) {
        save(state, packing.state());
        state.write(packing_seconds_name, seconds());
      });
    }
    return packing.packing();
  }

  /// Runs a packing that is not saved on its way.
  template <class Request>
  void run(SequentialRun<Request>& packing) {
    while (!packing.is_done()) {
      packing.advance();
      report(packing.progress());
      if (checkpoint_ == nullptr || !checkpoint_->is_due()) continue;
      checkpoint_->save([&](StateWriter& state) { state.write(packing_seconds_name, seconds()); });
    }
  }

  /// Wall time [s], including that of earlier runs.
  [[nodiscard]] double seconds() const {
    return seconds_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  template <int dim>
  [[nodiscard]] PackingRun<dim> go_on(const PackingRequest& request) const {
    try {
      return {request, read_packing_state<dim>(*earlier_)};
    } catch (const InputError& error) {
      throw FileError(fmt::format("{}: {}; start anew instead of resuming", earlier_->path(), error.what()));
    }
  }

  void report(const PackingProgress& packing) const {
    if (!follow_) return;
    follow_({.what = stage_.name + ": packing",
             .share = packing.fraction / packing.fraction_to_reach,
             .details = fmt::format("{} events", packing.events)});
  }

  const Stage& stage_;
  const ProgressObserver& follow_;
  Checkpoint* checkpoint_;
  const StateReader* earlier_;
  double seconds_before_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Pack>
auto in_words_of_the_deck(const Stage& stage, const PackingRequest& request, const Pack& pack) {
  try {
    return pack();
  } catch (const PackingError& error) {
    throw NumericalError(message_on(stage, request, error));
  }
}

/// The shells around particles (PackingRequest): their coatings, and half of what the gap of their filler is wider than
/// the smallest. Empty where no particle has one.
std::vector<double> shells_of(const Stage& stage, const DrawnParticles& drawn, double smallest_gap) {
  std::vector<double> shells;
  for (const auto number : drawn.fillers) {
    const auto& filler = stage.fillers[number];
    shells.push_back(filler.coating_thickness() + 0.5 * (filler.gap - smallest_gap));
  }
  const bool has_any = std::ranges::any_of(shells, [](double shell) { return shell > 0.0; });
  return has_any ? shells : std::vector<double>();
}

template <int dim>
Microstructure<dim> pack_at_random(const Stage& stage, const LubachevskyStillingerPacking& method,
                                   StagePacking& packing, StageMicrostructure& result) {
  const auto drawn = draw_particles(stage);
  const double gap = std::ranges::min(stage.fillers, {}, &Filler::gap).gap;
  PackingRequest request;
  // Particles keep the whole gap to a wall, too: the boundary there is as rigid as a particle.
  const double inset = method.walls == Walls::hard ? 0.5 * gap : 0.0;
  request.side = stage.side - 2.0 * inset;
  request.walls = method.walls;
  request.minimum_gap = gap;
  request.seed = method.seed;
  request.diameters = drawn.diameters;
  request.shells = shells_of(stage, drawn, gap);
  for (const auto& deviation : drawn.size_deviations) result.fillers.push_back({.size_deviation = deviation});
  auto packed = in_words_of_the_deck(stage, request, [&] { return packing.run<dim>(request); });
  result.events = packed.events;
  for (auto& ball : packed.balls) {
    for (auto& coordinate : ball.centre) coordinate += inset;
  }
  auto fillers = stage.fillers.size() > 1 ? drawn.fillers : std::vector<std::size_t>();
  return {stage.side, method.walls, std::move(packed.balls), std::move(fillers)};
}

/// Particles of any shape; discs alone are discs again.
Box<2> with_shapes(ParticleBox box) {
  if (auto discs = as_discs(box)) return *std::move(discs);
  return box;
}

/// Ellipsoids; those that are all balls are spheres again.
Box<3> with_shapes(EllipsoidBox box) {
  if (auto spheres = as_balls(box)) return *std::move(spheres);
  return box;
}

/// Places particles by a request, and returns their poses.
template <class Request>
std::vector<typename Request::Pose> poses_of(const Stage& stage, const Request& request, StagePacking& packing,
                                             StageMicrostructure& result) {
  try {
    SequentialRun<Request> run(request);
    packing.run(run);
    result.events = run.progress().events;
    return run.poses();
  } catch (const PackingError& error) {
    throw NumericalError(message_on(stage, request, error));
  }
}

Box<2> pack_sequentially(const Stage& stage, const RandomSequentialPacking& method, StagePacking& packing,
                         StageMicrostructure& result) {
  auto drawn = draw_particles(stage);
  for (const auto& deviation : drawn.size_deviations) result.fillers.push_back({.size_deviation = deviation});
  const auto request = sequential_request(stage, method, drawn);
  const auto poses = poses_of(stage, request, packing, result);
  return with_shapes(packed_box(stage, request, poses, std::move(drawn.fillers)));
}

Box<3> pack_ellipsoids(const Stage& stage, const RandomSequentialPacking& method, StagePacking& packing,
                       StageMicrostructure& result) {
  auto drawn = draw_particles(stage);
  for (const auto& deviation : drawn.size_deviations) result.fillers.push_back({.size_deviation = deviation});
  const auto request = ellipsoid_request(stage, method, drawn);
  const auto poses = poses_of(stage, request, packing, result);
  return with_shapes(packed_ellipsoids(stage, request, poses, std::move(drawn.fillers)));
}

template <int dim>
Box<dim> valid_balls(const Stage& stage, Microstructure<dim> balls) {
  require_valid(with_coatings(stage, balls));
  return balls;
}

template <class Shaped>
auto valid_shapes(Shaped shaped) {
  require_valid(shaped);
  return with_shapes(std::move(shaped));
}

Box<2> place_in_plane(const Stage& stage, StagePacking& packing, StageMicrostructure& result) {
  if (stage.fillers.empty() && !stage.has_image()) return Microstructure<2>{stage.side, Walls::hard, {}};
  return std::visit(
      Overloaded{
          [&](const LubachevskyStillingerPacking& method) -> Box<2> {
            return pack_at_random<2>(stage, method, packing, result);
          },
          [&](const LatticePacking&) -> Box<2> { throw InputError("a cubic lattice is for three dimensions"); },
          [&](const RegularPacking& array) -> Box<2> {
            const auto& size = std::get<SingleSize>(stage.fillers.front().sizes.value());
            return regular_array<2>(stage.side, {array.columns, array.rows}, size.diameter);
          },
          [&](const LaguerrePacking& method) -> Box<2> { return make_grains<2>(stage, method, result); },
          [&](const ImagePacking& pixels) -> Box<2> { return pixels.image; },
          [&](const RandomSequentialPacking& method) { return pack_sequentially(stage, method, packing, result); },
          [&](const ExplicitPacking& listed) {
            if (!listed.particles.empty()) return valid_shapes(particle_box(stage, listed));
            return valid_balls<2>(stage, {stage.side, listed.walls, listed.discs, listed.fillers});
          }},
      stage.packing);
}

Box<3> place_in_space(const Stage& stage, StagePacking& packing, StageMicrostructure& result) {
  if (stage.fillers.empty() && !stage.has_image()) return Microstructure<3>{stage.side, Walls::hard, {}};
  return std::visit(
      Overloaded{[&](const LubachevskyStillingerPacking& method) -> Box<3> {
                   return pack_at_random<3>(stage, method, packing, result);
                 },
                 [&](const LatticePacking& cubic) -> Box<3> {
                   const auto& size = std::get<SingleSize>(stage.fillers.front().sizes.value());
                   return cubic_array(cubic.lattice, stage.side, cubic.repeats, size.diameter);
                 },
                 [&](const ExplicitPacking& listed) {
                   if (!listed.ellipsoids.empty()) return valid_shapes(ellipsoid_box(stage, listed));
                   return valid_balls<3>(stage, {stage.side, listed.walls, listed.spheres, listed.fillers});
                 },
                 [&](const RandomSequentialPacking& method) { return pack_ellipsoids(stage, method, packing, result); },
                 [&](const LaguerrePacking& method) -> Box<3> { return make_grains<3>(stage, method, result); },
                 [](const ImagePacking& voxels) -> Box<3> { return voxels.stack; },
                 [](const RegularPacking&) -> Box<3> {
                   throw InputError("columns and rows of discs are for two dimensions");
                 }},
      stage.packing);
}

void place(const Stage& stage, StagePacking& packing, StageMicrostructure& result) {
  if (stage.dimensions == 2) {
    result.box = place_in_plane(stage, packing, result);
  } else {
    result.box = place_in_space(stage, packing, result);
  }
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
  // A ball has the volume d/6 for each unit of its surface.
  return interface_per_area > 0.0 ? 6.0 * fraction / interface_per_area : std::numeric_limits<double>::infinity();
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
  StagePacking packing(stage, follow, checkpoint);
  name_errors(stage.name, [&] { place(stage, packing, result); });
  result.seconds = packing.seconds();
  if (checkpoint != nullptr) checkpoint->finish([&](StateWriter& state) { save(state, result); });
  measure(stage, result);
  return result;
}

}  // namespace breccia
