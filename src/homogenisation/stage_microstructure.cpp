#include "breccia/homogenisation/stage_microstructure.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_microstructure_state.hpp"
#include "breccia/io/units.hpp"
#include "breccia/microstructure/regular_array.hpp"
#include "breccia/microstructure/size_distribution.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"
#include "breccia/study/filler_sizes.hpp"

#include "microstructure_measures.hpp"
#include "named_errors.hpp"
#include "packing_advice.hpp"
#include "packing_state.hpp"

namespace breccia {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;  // which clang 14 does not find by itself

/// Packs the particles of a stage, if it has any to pack, from the beginning or from where an earlier run has left it,
/// and counts the time.
class StagePacking {
 public:
  StagePacking(const PackingFollower& follow, Checkpoint* checkpoint)
      : follow_(follow),
        checkpoint_(checkpoint),
        earlier_(checkpoint != nullptr ? checkpoint->earlier() : nullptr),
        seconds_before_(earlier_ != nullptr ? earlier_->number(packing_seconds_name) : 0.0) {}

  Packing<2> run(const PackingRequest& request) {
    auto packing = earlier_ != nullptr ? go_on(request) : PackingRun<2>(request);
    while (!packing.is_done()) {
      packing.advance();
      if (follow_) follow_(packing.progress());
      if (checkpoint_ == nullptr || !checkpoint_->is_due()) continue;
      checkpoint_->save([&](StateWriter& state) {
        save(state, packing.state());
        state.write(packing_seconds_name, seconds());
      });
    }
    return packing.packing();
  }

  /// Wall time, that of earlier runs included.
  [[nodiscard]] double seconds() const {
    return seconds_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  [[nodiscard]] PackingRun<2> go_on(const PackingRequest& request) const {
    try {
      return {request, read_packing_state(*earlier_)};
    } catch (const InputError& error) {
      throw FileError(fmt::format("{}: {}; run without --resume, which begins anew", earlier_->path(), error.what()));
    }
  }

  const PackingFollower& follow_;
  Checkpoint* checkpoint_;
  const StateReader* earlier_;
  double seconds_before_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Pack>
Packing<2> in_words_of_the_deck(const Stage& stage, const PackingRequest& request, const Pack& pack) {
  try {
    return pack();
  } catch (const PackingError& error) {
    throw NumericalError(message_on(stage, request, error));
  }
}

Microstructure<2> pack_at_random(const Stage& stage, const LubachevskyStillingerPacking& method, StagePacking& packing,
                                 StageMicrostructure& result) {
  const auto& filler = *stage.filler;
  PackingRequest request;
  // Particles keep the whole gap to a wall, too: the boundary there is as rigid as a particle.
  const double inset = method.walls == Walls::hard ? 0.5 * filler.gap : 0.0;
  request.side = stage.side - 2.0 * inset;
  request.walls = method.walls;
  request.minimum_gap = filler.gap;
  request.seed = method.seed;
  if (const auto distribution = distribution_of(filler)) {
    request.diameters = draw_diameters<2>(*distribution, filler.fraction.value(), stage.side);
    result.size_deviation = largest_deviation<2>(*distribution, request.diameters);
  } else {
    request.diameters = std::get<ListedSizes>(filler.sizes.value()).diameters;
  }
  auto packed = in_words_of_the_deck(stage, request, [&] { return packing.run(request); });
  result.events = packed.events;
  for (auto& ball : packed.balls) {
    for (auto& coordinate : ball.centre) coordinate += inset;
  }
  return {stage.side, method.walls, std::move(packed.balls)};
}

Microstructure<2> place_particles(const Stage& stage, StagePacking& packing, StageMicrostructure& result) {
  if (!stage.filler) return {stage.side, Walls::hard, {}};
  return std::visit(Overloaded{[&](const LubachevskyStillingerPacking& method) {
                                 return pack_at_random(stage, method, packing, result);
                               },
                               [&](const RegularPacking& array) {
                                 const auto& size = std::get<SingleSize>(stage.filler->sizes.value());
                                 return regular_array<2>(stage.side, {array.columns, array.rows}, size.diameter);
                               },
                               [&](const ExplicitPacking& listed) {
                                 Microstructure<2> microstructure = {stage.side, listed.walls, listed.discs};
                                 require_valid(microstructure);
                                 return microstructure;
                               }},
                    stage.filler->packing);
}

}  // namespace

StageMicrostructure make_microstructure(const Stage& stage, const PackingFollower& follow, Checkpoint* checkpoint) {
  if (checkpoint != nullptr && checkpoint->is_finished()) return read_stage_microstructure(*checkpoint->earlier());
  StageMicrostructure result;
  StagePacking packing(follow, checkpoint);
  result.microstructure = name_errors(stage.name, [&] { return place_particles(stage, packing, result); });
  result.seconds = packing.seconds();
  if (checkpoint != nullptr) checkpoint->finish([&](StateWriter& state) { save(state, result); });
  measure(result);
  return result;
}

}  // namespace breccia
